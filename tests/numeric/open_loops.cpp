#include "open_loops.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace robcogen::numeric {
namespace {

using reference::Matrix;
using reference::Real;
using reference::Vector;

// Returns the last link on the paths from the base to both ends.
int last_common_link(const reflection::Robot& robot, const reflection::Loop& loop) {
  const std::vector<int> first = reference::supporting_joints(robot, robot.frames[loop.frames[0]].link);
  const std::vector<int> second = reference::supporting_joints(robot, robot.frames[loop.frames[1]].link);
  int link = 0;
  for (const int j : reference::outward_order(robot)) {
    const auto supports = [&](const std::vector<int>& joints) {
      return std::find(joints.begin(), joints.end(), j) != joints.end();
    };
    if (supports(first) && supports(second)) link = robot.joints[j].child;
  }
  return link;
}

// The frame at one end of a loop, in the last link that carries both ends.
struct End {
  Vector<Real> point;
  Matrix<Real> axes, angular, linear;  // angular, linear: the frame's velocity, a column per coordinate
};

std::array<End, 2> ends_of(const reflection::Robot& free, const reflection::Loop& loop, const Vector<Real>& joints) {
  const std::vector<Matrix<Real>> poses = reference::link_poses(free, joints);
  const int common = last_common_link(free, loop);
  const Matrix<Real>& carrier = poses[static_cast<std::size_t>(common)];
  const Matrix<Real> to_carrier = transpose(reference::rotation_of(carrier));
  const int base = free.floating_base ? 6 : 0, columns = base + free.joints.size;
  std::array<End, 2> ends;
  for (std::size_t e = 0; e < 2; ++e) {
    const reflection::Frame& frame = free.frames[loop.frames[e]];
    const Matrix<Real> placement = reference::placement<Real>(frame.translation, frame.rotation);
    const Matrix<Real> pose = poses[static_cast<std::size_t>(frame.link)] * placement;
    ends[e].point = to_carrier * (reference::origin_of(pose) - reference::origin_of(carrier));
    ends[e].axes = to_carrier * reference::rotation_of(pose);
    const Matrix<Real> relative = reference::body_jacobian(free, poses, frame.link, reference::origin_of(placement)) -
                                  reference::body_jacobian(free, poses, common, ends[e].point);
    ends[e].angular = to_carrier * relative.block(0, 6 - base, 3, columns);
    ends[e].linear = to_carrier * relative.block(3, 6 - base, 3, columns);
  }
  return ends;
}

class Rows {
 public:
  explicit Rows(int columns) : columns_(columns) {}

  void add(Real error, const std::vector<Real>& rates) {
    errors_.push_back(error);
    rates_.push_back(rates);
  }
  // Adds a row: an error along `direction`, and the components of the velocities (columns) along it.
  void add(Real error, const Vector<Real>& direction, const Matrix<Real>& velocities) {
    std::vector<Real> rates;
    for (int c = 0; c < columns_; ++c) rates.push_back(dot(direction, Vector<Real>(velocities.col(c))));
    add(error, rates);
  }
  OpenLoops result() const {
    const int rows = static_cast<int>(errors_.size());
    OpenLoops all{Vector<Real>(rows), Matrix<Real>(rows, columns_)};
    for (int r = 0; r < rows; ++r) {
      all.error(r) = errors_[static_cast<std::size_t>(r)];
      for (int c = 0; c < columns_; ++c) all.K(r, c) = rates_[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    }
    return all;
  }

 private:
  int columns_;
  std::vector<Real> errors_;
  std::vector<std::vector<Real>> rates_;
};

Vector<Real> unit(int axis) {
  Vector<Real> v(3);
  v(axis) = 1;
  return v;
}

Vector<Real> axis_of(const End& end, int axis) {
  return end.axes.block(0, axis, 3, 1);
}

void add_loop(const reflection::Robot& free, const reflection::Loop& loop, const Vector<Real>& joints, Rows& rows) {
  using reflection::LoopType;
  const auto [first, second] = ends_of(free, loop, joints);
  const Vector<Real> apart = second.point - first.point;
  const Matrix<Real> moving = second.linear - first.linear, turning = second.angular - first.angular;
  if (loop.type == LoopType::distance) {
    const Real length = static_cast<Real>(loop.length);
    return rows.add((dot(apart, apart) - length * length) / 2, apart, moving);
  }
  if (loop.type == LoopType::slider) {
    // The velocity as seen from the first frame, which turns.
    const Matrix<Real> seen = moving + reference::skew(apart) * first.angular;
    for (int k = 0; k < 2; ++k) rows.add(dot(axis_of(first, k), apart), axis_of(first, k), seen);
  } else {
    for (int k = 0; k < 3; ++k) rows.add(apart(k), unit(k), moving);
  }
  const Vector<Real> z = axis_of(second, 2);
  if (loop.type == LoopType::hinge)
    for (int k = 0; k < 2; ++k) rows.add(dot(axis_of(first, k), z), reference::cross(z, axis_of(first, k)), turning);
  if (loop.type == LoopType::slider || loop.type == LoopType::weld) {
    Vector<Real> turn(3);
    for (int k = 0; k < 3; ++k) turn += Real(0.5) * reference::cross(axis_of(first, k), axis_of(second, k));
    for (int k = 0; k < 3; ++k) rows.add(turn(k), unit(k), turning);
  }
}

}  // namespace

std::vector<int> declared_couplings(const model::KinematicTree& tree) {
  std::vector<int> places;
  for (std::size_t k = 0; k < tree.couplings.size(); ++k)
    if (tree.couplings[k].is_linear() && tree.couplings[k].loop < 0) places.push_back(static_cast<int>(k));
  return places;
}

OpenLoops open_loops(const model::KinematicTree& tree, const reflection::Robot& tables, const Vector<Real>& joints) {
  const reflection::Robot free = reference::with_free_joints(tables);
  const int base = free.floating_base ? 6 : 0;
  Rows rows(base + free.joints.size);
  for (const reflection::Loop& loop : free.loops) add_loop(free, loop, joints, rows);
  for (const int place : declared_couplings(tree)) {
    const int follower = tables.dof() + place;
    std::vector<Real> rates(static_cast<std::size_t>(base + free.joints.size));
    const auto rate = [&](int joint) -> Real& { return rates[static_cast<std::size_t>(base + joint)]; };
    Real error = joints(follower) - static_cast<Real>(tables.couplings[place].offset);
    rate(follower) = 1;
    for (const reference::Mover& mover : reference::movers_of(tables, follower)) {
      rate(mover.coordinate) -= static_cast<Real>(mover.factor);
      error -= static_cast<Real>(mover.factor) * joints(mover.coordinate);
    }
    rows.add(error, rates);
  }
  return rows.result();
}

Vector<Real> change_of_rates(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const Vector<Real>& joints,
    const Vector<Real>& velocities) {
  const Real step = 1e-2L / (1 + std::sqrt(dot(velocities, velocities)));
  const Vector<Real> all = tables.floating_base ? reference::stacked(Vector<Real>(6), velocities) : velocities;
  const auto rates = [&](int steps) {
    return open_loops(tree, tables, joints + static_cast<Real>(steps) * step * velocities).K * all;
  };
  const Real weights[] = {4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
  Vector<Real> change(rates(0).rows());
  for (int k = 1; k <= 4; ++k) change = change + weights[k - 1] / step * (rates(k) - rates(-k));
  return change;
}

void push(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const Vector<Real>& joints,
    int index,
    const std::vector<double>& forces,
    std::size_t& next,
    std::vector<Vector<Real>>& wrenches) {
  using reflection::LoopType;
  const reflection::Robot free = reference::with_free_joints(tables);
  const reflection::Loop& loop = tables.loops[index];
  const auto ends = ends_of(free, loop, joints);
  const bool is_iterative = std::any_of(tree.closures.begin(), tree.closures.end(), [&](const model::Closure& c) {
    return c.method == model::Closure::Method::iterative && std::count(c.loops.begin(), c.loops.end(), index) > 0;
  });
  Vector<Real> force(3), moment(3);
  if (loop.type == LoopType::distance) {
    const Vector<Real> way = ends[1].point - ends[0].point;
    force = -static_cast<Real>(forces.at(next++)) / std::sqrt(dot(way, way)) * way;
  } else {
    for (int k = 0; k < 3; ++k) force(k) = static_cast<Real>(forces.at(next++));
    for (int k = 0; k < 3 && is_iterative && loop.type != LoopType::point; ++k)
      moment(k) = static_cast<Real>(forces.at(next++));
  }
  const std::vector<Matrix<Real>> poses = reference::link_poses(free, joints);
  const Matrix<Real>& carrier = poses[static_cast<std::size_t>(last_common_link(free, loop))];
  for (std::size_t e = 0; e < 2; ++e) {
    const reflection::Frame& frame = free.frames[loop.frames[e]];
    const Matrix<Real>& link = poses[static_cast<std::size_t>(frame.link)];
    const Matrix<Real> to_link = transpose(reference::rotation_of(link)) * reference::rotation_of(carrier);
    const Vector<Real> point = (loop.type == LoopType::slider ? ends[1] : ends[e]).point;
    const Vector<Real> arm = to_link * (point + transpose(reference::rotation_of(carrier)) *
                                                    (reference::origin_of(carrier) - reference::origin_of(link)));
    const Real sign = e == 0 ? 1 : -1;
    const Vector<Real> f = sign * (to_link * force), n = sign * (to_link * moment);
    Vector<Real>& wrench = wrenches[static_cast<std::size_t>(frame.link)];
    wrench = wrench + reference::stacked(n + reference::cross(arm, f), f);
  }
  if (loop.type == LoopType::slider) return;
  // The rows are expressed in the carrier, so an open loop exerts a couple on it.
  Vector<Real>& wrench = wrenches[static_cast<std::size_t>(last_common_link(free, loop))];
  wrench = wrench + reference::stacked(reference::cross(ends[1].point - ends[0].point, force), Vector<Real>(3));
}

}  // namespace robcogen::numeric
