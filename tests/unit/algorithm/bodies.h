// Bodies of point masses and random poses, as symbols with known numeric values.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "algorithm/spatial/spatial_inertia.h"
#include "values.h"

namespace robcogen::algorithm::test {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& p) {
  Eigen::Matrix3d m;
  m << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  return m;
}

// Featherstone 2008, eq. 2.24 to 2.27: the matrices map coordinates in the frame with pose T to coordinates in the frame in
// which T is given.
inline Matrix6d motion_transform(const Eigen::Isometry3d& t) {
  Matrix6d x = Matrix6d::Zero();
  x.topLeftCorner<3, 3>() = x.bottomRightCorner<3, 3>() = t.linear();
  x.bottomLeftCorner<3, 3>() = cross_matrix(t.translation()) * t.linear();
  return x;
}
inline Matrix6d force_transform(const Eigen::Isometry3d& t) {
  Matrix6d x = Matrix6d::Zero();
  x.topLeftCorner<3, 3>() = x.bottomRightCorner<3, 3>() = t.linear();
  x.topRightCorner<3, 3>() = cross_matrix(t.translation()) * t.linear();
  return x;
}

inline Vector6d value(const Numbers& n, const Motion& m) {
  return (Vector6d() << n.value(m.angular), n.value(m.linear)).finished();
}
inline Vector6d value(const Numbers& n, const Force& f) {
  return (Vector6d() << n.value(f.moment), n.value(f.linear)).finished();
}
inline Matrix6d value(const Numbers& n, const SpatialInertia& x) {
  return Matrix6d(evaluate(n.graph, n.inputs, matrix(x).columns()).data());
}

// A body of a few point masses: its mass, first moment, pseudo-inertia and everything else are sums over the points.
struct Cloud {
  std::vector<double> mass;
  std::vector<Eigen::Vector3d> at;

  static Cloud random(Numbers& n) {
    Cloud cloud;
    for (int k = 0; k < 5; ++k) {
      cloud.mass.push_back(std::abs(n.real()));
      cloud.at.emplace_back(n.real(), n.real(), n.real());
    }
    return cloud;
  }
  double total() const {
    double m = 0;
    for (double each : mass) m += each;
    return m;
  }
  Eigen::Vector3d first_moment() const {
    Eigen::Vector3d h = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k) h += mass[k] * at[k];
    return h;
  }
  Eigen::Matrix3d pseudo_inertia() const {
    Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k) s += mass[k] * at[k] * at[k].transpose();
    return s;
  }
  Eigen::Matrix3d inertia_tensor() const {
    Eigen::Matrix3d i = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k)
      i += mass[k] * (at[k].squaredNorm() * Eigen::Matrix3d::Identity() - at[k] * at[k].transpose());
    return i;
  }
  // The inertia about the origin, which maps acceleration to force: for each mass, m [-[r]x [r]x, [r]x; -[r]x, 1].
  Matrix6d spatial_inertia() const {
    Matrix6d sum = Matrix6d::Zero();
    for (std::size_t k = 0; k < mass.size(); ++k) {
      Eigen::Matrix<double, 3, 6> acceleration;  // of the point, from the body's
      acceleration << -cross_matrix(at[k]), Eigen::Matrix3d::Identity();
      sum += mass[k] * acceleration.transpose() * acceleration;
    }
    return sum;
  }
  // The inertia as a document gives it: moments and products about the link's origin, products with positive sign.
  model::Inertia document() const {
    const Eigen::Matrix3d tensor = inertia_tensor(), s = pseudo_inertia();
    model::Inertia inertia;
    inertia.mass = model::Quantity(total());
    for (std::size_t i = 0; i < 3; ++i)
      inertia.com[i] = model::Quantity(first_moment()[static_cast<Eigen::Index>(i)] / total());
    inertia.ixx = model::Quantity(tensor(0, 0));
    inertia.iyy = model::Quantity(tensor(1, 1));
    inertia.izz = model::Quantity(tensor(2, 2));
    inertia.ixy = model::Quantity(s(0, 1));
    inertia.ixz = model::Quantity(s(0, 2));
    inertia.iyz = model::Quantity(s(1, 2));
    return inertia;
  }
  MassProperties symbols(Numbers& n) const {
    const Eigen::Vector3d h = first_moment();
    const Eigen::Matrix3d s = pseudo_inertia();
    MassProperties m;
    m.mass = n.expression(total());
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      m.first_moment[i] = n.expression(h[row]);
      for (std::size_t j = i; j < 3; ++j)
        m.pseudo_inertia[i][j] = m.pseudo_inertia[j][i] = n.expression(s(row, static_cast<Eigen::Index>(j)));
    }
    return m;
  }
};

// A pose with every component: quarter turns, planes, offset and slide.
struct RandomPose {
  explicit RandomPose(Numbers& n) {
    pose.rotation.quarter = quarter_turn(n.pick(3), n.pick(4));
    transform.rotate(matrix_of(pose.rotation.quarter));
    for (int k = n.pick(4); k > 0; --k) {
      const int axis = n.pick(3);
      const double angle = n.real();
      const Expression symbol = n.expression(angle);
      pose.rotation.planes.push_back({axis, cos(symbol), sin(symbol), symbol});
      transform.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)));
    }
    Eigen::Vector3d offset(n.real(), n.real(), n.real());
    if (n.pick(3) == 0) offset[n.pick(3)] = 0;
    const double slide = n.pick(2) == 0 ? 0.0 : n.real();
    for (std::size_t i = 0; i < 3; ++i)
      if (offset[static_cast<int>(i)] != 0) pose.offset[i] = n.expression(offset[static_cast<int>(i)]);
    if (slide != 0) pose.slide = n.expression(slide);
    transform = Eigen::Translation3d(offset) * transform * Eigen::Translation3d(0, 0, slide);
  }

  static Eigen::Matrix3d matrix_of(const QuarterTurns& q) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) m(static_cast<int>(i), q.image[i]) = q.sign[i];
    return m;
  }

  Pose pose;
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
};

}  // namespace robcogen::algorithm::test
