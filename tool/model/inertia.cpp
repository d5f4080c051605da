// Transforms mass properties from a user frame to the link frame.
#include "model/kinematic_tree.h"

namespace robcogen::model {

namespace {

using Vector = std::array<Quantity, 3>;
using Matrix = std::array<Vector, 3>;  // rows

Quantity dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector operator*(const Matrix& m, const Vector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

Vector scaled(const Quantity& factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

// The inertia tensor: products enter with negative sign.
Matrix tensor(const Inertia& i) {
  return {Vector{i.ixx, -i.ixy, -i.ixz}, Vector{-i.ixy, i.iyy, -i.iyz}, Vector{-i.ixz, -i.iyz, i.izz}};
}

}  // namespace

Matrix rotation_matrix(const Placement& placement) {
  const Vector& angles = placement.rotation;
  const Quantity sx = sin(angles[0]), cx = cos(angles[0]);
  const Quantity sy = sin(angles[1]), cy = cos(angles[1]);
  const Quantity sz = sin(angles[2]), cz = cos(angles[2]);
  return {
      Vector{cy * cz, -(cy * sz), sy}, Vector{cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -(sx * cy)},
      Vector{sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy}};
}

RigidBodyInertia in_link_frame(const Inertia& inertia) {
  RigidBodyInertia body;
  body.mass = inertia.mass;
  if (!inertia.reference) {
    body.first_moment = scaled(inertia.mass, inertia.com);
    body.ixx = inertia.ixx, body.iyy = inertia.iyy, body.izz = inertia.izz;
    body.ixy = inertia.ixy, body.ixz = inertia.ixz, body.iyz = inertia.iyz;
    return body;
  }

  const Matrix R = rotation_matrix(*inertia.reference);
  const Vector& t = inertia.reference->translation;
  const Vector c = R * inertia.com;  // centre of mass relative to the reference origin, in link axes
  body.first_moment = scaled(inertia.mass, {t[0] + c[0], t[1] + c[1], t[2] + c[2]});

  // The parallel-axis theorem from the reference origin straight to the link origin:
  //   I_link = R I R' + m ((2 t.c + t.t) 1 - (t c' + c t' + t t')).
  // Going through the centre of mass is equivalent, but subtracts m |c|^2 and adds it again.
  const Matrix I = tensor(inertia);
  const Matrix rows = {I * R[0], I * R[1], I * R[2]};  // row i: I R' e_i, as I is symmetric
  const Quantity two(Number::rational(2));
  const auto moment = [&](std::size_t i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return dot(R[i], rows[i]) + inertia.mass * (two * (t[j] * c[j] + t[k] * c[k]) + t[j] * t[j] + t[k] * t[k]);
  };
  const auto product = [&](std::size_t i, std::size_t j) {
    return inertia.mass * (t[i] * c[j] + c[i] * t[j] + t[i] * t[j]) - dot(R[i], rows[j]);
  };
  body.ixx = moment(0), body.iyy = moment(1), body.izz = moment(2);
  body.ixy = product(0, 1), body.ixz = product(0, 2), body.iyz = product(1, 2);
  return body;
}

RigidBodyInertia in_outer_frame(const RigidBodyInertia& body, const Placement& pose) {
  const Matrix R = rotation_matrix(pose);
  const Vector& t = pose.translation;
  const Vector h = R * body.first_moment;  // in outer axes, about the origin of the link frame
  const Matrix I = {
      Vector{body.ixx, -body.ixy, -body.ixz}, Vector{-body.ixy, body.iyy, -body.iyz},
      Vector{-body.ixz, -body.iyz, body.izz}};
  const Matrix rows = {I * R[0], I * R[1], I * R[2]};  // as above
  const Quantity two(Number::rational(2));
  const auto moment = [&](std::size_t i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return dot(R[i], rows[i]) + two * (t[j] * h[j] + t[k] * h[k]) + body.mass * (t[j] * t[j] + t[k] * t[k]);
  };
  const auto product = [&](std::size_t i, std::size_t j) {
    return t[i] * h[j] + h[i] * t[j] + body.mass * (t[i] * t[j]) - dot(R[i], rows[j]);
  };
  RigidBodyInertia outer;
  outer.mass = body.mass;
  for (std::size_t i = 0; i < 3; ++i) outer.first_moment[i] = body.mass * t[i] + h[i];
  outer.ixx = moment(0), outer.iyy = moment(1), outer.izz = moment(2);
  outer.ixy = product(0, 1), outer.ixz = product(0, 2), outer.iyz = product(1, 2);
  return outer;
}

RigidBodyInertia operator+(const RigidBodyInertia& a, const RigidBodyInertia& b) {
  RigidBodyInertia sum = {a.mass + b.mass, {},           a.ixx + b.ixx, a.iyy + b.iyy, a.izz + b.izz, a.ixy + b.ixy,
                          a.ixz + b.ixz,   a.iyz + b.iyz};
  for (std::size_t k = 0; k < 3; ++k) sum.first_moment[k] = a.first_moment[k] + b.first_moment[k];
  return sum;
}

}  // namespace robcogen::model
