// Kernels for poses of the base in Python modules, whose arrays are a unit quaternion w, x, y, z and a position. They
// compute what <robcogen/pose.h> computes, without Eigen, which would take most of the time to compile a module.
#pragma once

#include <cmath>
#include <cstddef>

namespace robcogen::python {

// A vector of three elements, or the elements x, y, z of a quaternion.
template <class S>
struct Vector3 {
  S x, y, z;
  friend Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector3 operator*(S f, Vector3 a) { return {f * a.x, f * a.y, f * a.z}; }
  friend S dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vector3 cross(Vector3 a, Vector3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

template <class S>
Vector3<S> read(const S* v) {
  return {v[0], v[1], v[2]};
}
template <class S>
void write(Vector3<S> v, S* to) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

template <class S>
struct Quaternion {
  S w;
  Vector3<S> v;
  friend Quaternion operator*(Quaternion a, Quaternion b) {
    return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
  }
};

template <class S>
Quaternion<S> conjugate(Quaternion<S> q) {
  return {q.w, S(-1) * q.v};
}
template <class S>
Vector3<S> rotate(Quaternion<S> q, Vector3<S> a) {
  const Vector3<S> t = S(2) * cross(q.v, a);
  return a + q.w * t + cross(q.v, t);
}
template <class S>
Quaternion<S> read_quaternion(const S* q) {
  const S norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / norm, {q[1] / norm, q[2] / norm, q[3] / norm}};
}
// Writes it with unit length, however many steps follow one another.
template <class S>
void write(Quaternion<S> q, S* to) {
  const S factor = S(1) / std::sqrt(q.w * q.w + dot(q.v, q.v));
  to[0] = factor * q.w;
  write(factor * q.v, to + 1);
}

// sin(t) / t, (1 - cos(t)) / t^2 and (t - sin(t)) / t^3 for an angle t, from its square; by series near zero.
template <class S>
struct Coefficients {
  S c1, c2, c3;

  explicit Coefficients(S squared) {
    if (squared < S(1)) {
      c2 = series(2, squared) / S(2);
      c3 = series(3, squared) / S(6);
      c1 = S(1) - squared * c3;
      return;
    }
    const S t = std::sqrt(squared), s = std::sin(t / S(2));
    c1 = std::sin(t) / t;
    c2 = S(2) * s * s / squared;
    c3 = (S(1) - c1) / squared;
  }
  // k! times the sum over i of (-t^2)^i / (2 i + k)!, for t^2 <= 1.
  static S series(int k, S squared) {
    S sum(1);
    for (int i = 9; i > 0; --i) sum = S(1) - squared / S((2 * i - 1 + k) * (2 * i + k)) * sum;
    return sum;
  }
};

// The rotation by a vector along the axis whose length is the angle, and the vector of a rotation of at most half a
// turn.
template <class S>
Quaternion<S> rotation(Vector3<S> turn) {
  const S quarter = dot(turn, turn) / S(4);
  const Coefficients<S> half(quarter);
  return {S(1) - quarter * half.c2, half.c1 / S(2) * turn};
}
template <class S>
Vector3<S> turn_of(Quaternion<S> q) {
  const S sign = q.w < S(0) ? S(-1) : S(1), squared = dot(q.v, q.v);
  if (squared == S(0)) return S(2) * sign * q.v;
  const S sine = std::sqrt(squared);
  return S(2) * sign * std::atan2(sine, sign * q.w) / sine * q.v;
}

template <class S>
void from_mujoco(const S* const* in, S* const* out) {
  write(read_quaternion(in[0] + 3), out[0]);
  write(read(in[0]), out[0] + 4);
}
template <class S>
void to_mujoco(const S* const* in, S* const* out) {
  write(read(in[0] + 4), out[0]);
  write(read_quaternion(in[0]), out[0] + 3);
}
template <class S>
void from_ros(const S* const* in, S* const* out) {
  const S* const q = in[1];
  const S wxyz[4] = {q[3], q[0], q[1], q[2]};
  write(read_quaternion(wxyz), out[0]);
  write(read(in[0]), out[0] + 4);
}
template <class S>
void to_ros(const S* const* in, S* const* out) {
  const Quaternion<S> q = read_quaternion(in[0]);
  write(read(in[0] + 4), out[0]);
  write(q.v, out[1]);
  out[1][3] = q.w;
}

template <class S>
void gravity_in_base(const S* const* in, S* const* out) {
  write(rotate(conjugate(read_quaternion(in[0])), read(in[1])), out[0]);
}

// An exact screw motion, and its inverse.
template <class S>
void integrate_pose(const S* pose, const S* velocity, S dt, S* moved) {
  const Quaternion<S> q = read_quaternion(pose);
  const Vector3<S> turn = dt * read(velocity), shift = dt * read(velocity + 3);
  const Coefficients<S> c(dot(turn, turn));
  const Vector3<S> once = cross(turn, shift), twice = cross(turn, once);
  write(q * rotation(turn), moved);
  write(read(pose + 4) + rotate(q, shift + c.c2 * once + c.c3 * twice), moved + 4);
}
template <class S>
void difference_of_poses(const S* from, const S* to, S* velocity) {
  const Quaternion<S> q = conjugate(read_quaternion(from));
  const Vector3<S> turn = turn_of(q * read_quaternion(to));
  const Vector3<S> way = rotate(q, read(to + 4) - read(from + 4));
  const S squared = dot(turn, turn);
  const Coefficients<S> c(squared);
  // (1 - t / 2 cot(t / 2)) / t^2
  const S k = squared < S(1) ? (c.c3 - S(2) * Coefficients<S>::series(4, squared) / S(24)) / (S(2) * c.c2)
                             : (S(1) - c.c1 / (S(2) * c.c2)) / squared;
  const Vector3<S> once = cross(turn, way), twice = cross(turn, once);
  write(turn, velocity);
  write(way - S(0.5) * once + k * twice, velocity + 3);
}

// A robot with `kDof` velocities, in whose positions these elements begin unit quaternions.
template <int kDof, int... kQuaternions>
struct Joints {
  static constexpr bool is_quaternion(int element) {
    bool result = false;
    ((result = result || element == kQuaternions), ...);
    return result;
  }
  // q, qd, base_pose, base_velocity, dt -> q, base_pose
  template <class S>
  static void integrate(const S* const* in, S* const* out) {
    const S* const q = in[0];
    const S dt = *in[4];
    for (int j = 0, k = 0; j < kDof; ++j, ++k) {
      if (!is_quaternion(k)) {
        out[0][k] = q[k] + dt * in[1][j];
        continue;
      }
      write(read_quaternion(q + k) * rotation(dt * read(in[1] + j)), out[0] + k);
      k += 3;
      j += 2;
    }
    integrate_pose(in[2], in[3], dt, out[1]);
  }
  // q_from, q_to, pose_from, pose_to -> qd, base_velocity
  template <class S>
  static void difference(const S* const* in, S* const* out) {
    for (int j = 0, k = 0; j < kDof; ++j, ++k) {
      if (!is_quaternion(k)) {
        out[0][j] = in[1][k] - in[0][k];
        continue;
      }
      write(turn_of(conjugate(read_quaternion(in[0] + k)) * read_quaternion(in[1] + k)), out[0] + j);
      k += 3;
      j += 2;
    }
    difference_of_poses(in[2], in[3], out[1]);
  }
};

}  // namespace robcogen::python
