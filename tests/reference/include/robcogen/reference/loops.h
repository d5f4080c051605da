// Robots with loops, in one state. Newton's method closes the loops from the position in which they are assembled, and
// joints that follow through them become coupled joints, linearised at that state. Positions, velocities,
// accelerations, and first derivatives with respect to positions are those of the robot.
//
// No formula of the generator is used: a loop is a set of rows, functions of all joints whose derivatives are frame
// Jacobians of the robot with all joints free. The rows are solved by least squares.
#pragma once

#include <deque>

#include "robcogen/reference/checks.h"
#include "robcogen/reference/dynamics.h"
#include "robcogen/reference/samples.h"

namespace robcogen::reference {

// The robot in which all joints are coordinates.
inline Robot with_free_joints(Robot robot) {
  robot.couplings = {nullptr, 0};
  return robot;
}

// The errors by which the frames of each loop are apart, and their derivatives with respect to all joints.
struct LoopRows {
  Vector<Real> error;
  Matrix<Real> columns;
};

inline LoopRows loop_rows(const Robot& robot, const Vector<Real>& joints) {
  const Robot free = with_free_joints(robot);
  constexpr int kMaxRows = 6;
  LoopRows all{Vector<Real>(kMaxRows * robot.loops.size), Matrix<Real>(kMaxRows * robot.loops.size, robot.joints.size)};
  int row = 0;
  for (const reflection::Loop& loop : robot.loops) {
    const Matrix<Real> X = transform(free, joints, loop.frames[0], loop.frames[1]);
    const Matrix<Real> J = frame_jacobian(free, joints, loop.frames[0], loop.frames[1]);
    const Vector<Real> apart = origin_of(X);
    const bool is_slider = loop.type == reflection::LoopType::slider;
    if (loop.type == reflection::LoopType::distance) {
      const Real length = static_cast<Real>(loop.length);
      all.error(row) = (dot(apart, apart) - length * length) / 2;
      for (int c = 0; c < J.cols(); ++c)
        for (int i = 0; i < 3; ++i) all.columns(row, c) += apart(i) * J(3 + i, c);
    } else {
      for (int i = 0; i < (is_slider ? 2 : 3); ++i) {
        all.error(row + i) = apart(i);
        for (int c = 0; c < J.cols(); ++c) all.columns(row + i, c) = J(3 + i, c);
      }
    }
    if (loop.type == reflection::LoopType::hinge) {
      // The components of one frame's axis along x and y of the other frame; the axis changes by w x z.
      const Vector<Real> z = X.block(0, 2, 3, 1);
      for (int i = 0; i < 2; ++i) all.error(row + 3 + i) = z(i);
      for (int c = 0; c < J.cols(); ++c) {
        const Vector<Real> change = cross(Vector<Real>{J(0, c), J(1, c), J(2, c)}, z);
        for (int i = 0; i < 2; ++i) all.columns(row + 3 + i, c) = change(i);
      }
    }
    if (is_slider || loop.type == reflection::LoopType::weld) {
      // The columns of R change by w x; where R is the identity, these rows are the components of w.
      const Matrix<Real> R = X.block(0, 0, 3, 3);
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        all.error(row + 3 + i) = (R(k, j) - R(j, k)) / 2;
        for (int c = 0; c < J.cols(); ++c) {
          const auto rate = [&](int r, int column) {
            return cross(Vector<Real>{J(0, c), J(1, c), J(2, c)}, R.block(0, column, 3, 1))(r);
          };
          all.columns(row + 3 + i, c) = (rate(k, j) - rate(j, k)) / 2;
        }
      }
    }
    row += kMaxRows;
  }
  return all;
}

// dK/dt, by an eighth-order difference along the velocity.
inline Matrix<Real> change_of_columns(const Robot& robot, const Vector<Real>& joints, const Vector<Real>& velocity) {
  const Real step = 1e-2L / (1 + std::sqrt(dot(velocity, velocity)));
  const auto columns = [&](Real steps) { return loop_rows(robot, joints + steps * step * velocity).columns; };
  const Real weights[] = {4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
  Matrix<Real> change(loop_rows(robot, joints).error.rows(), robot.joints.size);
  for (int k = 1; k <= 4; ++k)
    change = change + weights[k - 1] / step * (columns(static_cast<Real>(k)) - columns(static_cast<Real>(-k)));
  return change;
}

// dK/dt qd.
inline Vector<Real> change_of_rates(const Robot& robot, const Vector<Real>& joints, const Vector<Real>& velocity) {
  return change_of_columns(robot, joints, velocity) * velocity;
}

class AtLoops {
 public:
  // Sets in `motion` the positions of followers that are elements of q, and the accelerations that loops add.
  template <class Scalar>
  AtLoops(const Robot& robot, Motion<Scalar>& motion) : AtLoops(robot, motion, nullptr) {}

  // The loops at another motion, whose positions are close to these.
  template <class Scalar>
  AtLoops near(Motion<Scalar>& motion) const {
    return AtLoops(looped_, motion, &joints_);
  }

  const Robot& robot() const { return robot_; }
  // dG/dt at the rates qd of the coordinates, where G is the derivative of all joints with respect to the coordinates:
  // K dG/dt = -dK/dt G. Empty without dependent joints.
  Matrix<Real> change_of_tangent(const Vector<Real>& qd) const {
    if (dependent_.empty()) return {};
    const Matrix<Real> G = tangent(joints_);
    const Matrix<Real> K = dependent_columns(loop_rows(robot_, joints_).columns);
    const Matrix<Real> followed = least_squares(K, change_of_columns(looped_, joints_, G * qd) * G);
    Matrix<Real> change(looped_.joints.size, looped_.dof());
    for (std::size_t d = 0; d < dependent_.size(); ++d)
      for (int c = 0; c < change.cols(); ++c) change(dependent_[d], c) = -followed(static_cast<int>(d), c);
    return change;
  }
  // True if the loops close, not so near to a stretched position that followers move very fast.
  bool is_usual() const { return is_usual_; }

 private:
  Robot looped_, robot_;
  bool is_usual_ = true;
  std::vector<int> dependent_;  // joints
  Vector<Real> joints_;         // positions, if some are dependent
  std::deque<std::vector<double>> factors_;
  std::vector<reflection::Coupling> couplings_;

  // `start` holds the positions of all joints; with nullptr, the loops are closed from the assembled position.
  template <class Scalar>
  AtLoops(const Robot& robot, Motion<Scalar>& motion, const Vector<Real>* start) : looped_(robot), robot_(robot) {
    if (robot.loops.size == 0) return;
    for (int k = 0; k < robot.couplings.size; ++k)
      if (std::isnan(robot.couplings[k].offset)) dependent_.push_back(robot.dof() + k);
    const Vector<Real> y = motion.q.template cast<Real>();
    if (dependent_.empty()) {  // they close as exactly as the document draws them
      constexpr Real kDrawn = 1e-12L;
      is_usual_ = largest(loop_rows(robot_, joint_positions(robot_, y)).error) < kDrawn;
      return;
    }
    joints_ = start ? closed_near(y, *start) : closed(y);
    const Matrix<Real> G = tangent(joints_);
    constexpr Real kClosed = 1e-15L;
    is_usual_ = largest(loop_rows(robot_, joints_).error) < kClosed && !is_racing(G);
    couple(y, joints_, G);
    for (int k = 0; k < robot.followers.size; ++k)
      motion.q(robot.position_count() - robot.followers.size + k) =
          static_cast<Scalar>(joints_(robot.followers[k].joint));
    motion.of_loops = Vector<Scalar>(robot.joints.size);
    const Vector<Real> added = accelerations(joints_, G * motion.qd.template cast<Real>());
    for (std::size_t d = 0; d < dependent_.size(); ++d)
      motion.of_loops(dependent_[d]) = static_cast<Scalar>(added(static_cast<int>(d)));
  }

  bool is_dependent(int joint) const {
    return std::find(dependent_.begin(), dependent_.end(), joint) != dependent_.end();
  }

  // Sets the joints that do not follow through loops for these coordinates; the others keep their positions.
  void set_given(const Vector<Real>& y, Vector<Real>& joints) const {
    for (int j = 0; j < robot_.joints.size; ++j) {
      if (is_dependent(j)) continue;
      joints(j) = 0;
      for (const Mover& mover : movers_of(robot_, j))
        joints(j) += static_cast<Real>(mover.factor) * y(mover.coordinate);
      if (j >= robot_.dof()) joints(j) += static_cast<Real>(robot_.couplings[j - robot_.dof()].offset);
    }
  }

  Matrix<Real> dependent_columns(const Matrix<Real>& columns) const {
    Matrix<Real> K(columns.rows(), static_cast<int>(dependent_.size()));
    for (std::size_t d = 0; d < dependent_.size(); ++d) K.set_block(0, static_cast<int>(d), columns.col(dependent_[d]));
    return K;
  }

  // x with K x = b, by least squares, because some rows are redundant.
  static Matrix<Real> least_squares(const Matrix<Real>& K, const Matrix<Real>& b) {
    return solve(transpose(K) * K, transpose(K) * b);
  }

  // Follows a straight path from the assembled position.
  Vector<Real> closed(const Vector<Real>& y) const {
    constexpr int kSteps = 30;
    Vector<Real> joints(robot_.joints.size);
    for (const int joint : dependent_) joints(joint) = robot_.couplings[joint - robot_.dof()].assembled;
    Vector<Real> start = y;
    for (int j = 0; j < robot_.dof(); ++j)
      if (robot_.joints[j].type != JointType::spherical) start(robot_.position_of(j)) = robot_.joints[j].assembled;
    for (int step = 0; step <= kSteps; ++step)
      close(start + static_cast<Real>(step) / kSteps * (y - start), step == 0 ? 5 * kIterations : kIterations, joints);
    return joints;
  }
  Vector<Real> closed_near(const Vector<Real>& y, Vector<Real> joints) const {
    close(y, kIterations, joints);
    return joints;
  }

  static constexpr int kIterations = 12;

  // Closes the loops for the coordinates y, by Newton's method.
  void close(const Vector<Real>& y, int iterations, Vector<Real>& joints) const {
    set_given(y, joints);
    for (int i = 0; i < iterations; ++i) {
      const LoopRows rows = loop_rows(robot_, joints);
      Matrix<Real> error(rows.error.rows(), 1);
      error.set_block(0, 0, rows.error);
      const Matrix<Real> move = least_squares(dependent_columns(rows.columns), error);
      Real largest_move = 0;
      for (std::size_t d = 0; d < dependent_.size(); ++d)
        largest_move = std::max(largest_move, std::abs(move(static_cast<int>(d), 0)));
      const Real share = largest_move > Real(0.5) ? Real(0.5) / largest_move : Real(1);
      for (std::size_t d = 0; d < dependent_.size(); ++d) joints(dependent_[d]) -= share * move(static_cast<int>(d), 0);
      constexpr Real kStill = 1e-17L;
      if (largest_move < kStill) break;
    }
  }

  // The derivative of all joints with respect to the coordinates.
  Matrix<Real> tangent(const Vector<Real>& joints) const {
    Matrix<Real> G(robot_.joints.size, robot_.dof());
    for (int j = 0; j < robot_.joints.size; ++j)
      if (!is_dependent(j))
        for (const Mover& mover : movers_of(robot_, j)) G(j, mover.coordinate) = static_cast<Real>(mover.factor);
    const Matrix<Real> K = loop_rows(robot_, joints).columns;
    const Matrix<Real> followed = least_squares(dependent_columns(K), K * G);
    for (std::size_t d = 0; d < dependent_.size(); ++d)
      for (int c = 0; c < robot_.dof(); ++c) {
        // Rounding noise of a zero, where a joint does not follow a coordinate.
        constexpr Real kNothing = 1e-14L;
        const Real rate = followed(static_cast<int>(d), c);
        G(dependent_[d], c) = std::abs(rate) > kNothing ? -rate : 0;
      }
    return G;
  }

  // True if followers move much faster than a coordinate; 0.1 m of a slide count as a radian, as in random samples.
  bool is_racing(const Matrix<Real>& G) const {
    constexpr Real kRacing = 4, kStroke = 0.1L;
    const auto slides = [&](int joint) { return !turns(robot_.joints[joint].type); };
    for (const int joint : dependent_)
      for (int c = 0; c < robot_.dof(); ++c) {
        const Real unit = slides(c) && !slides(joint) ? kStroke : Real(1);
        if (std::abs(G(joint, c)) * unit >= kRacing) return true;
      }
    return false;
  }

  void couple(const Vector<Real>& y, const Vector<Real>& joints, const Matrix<Real>& G) {
    for (int k = 0; k < robot_.couplings.size; ++k) {
      const int joint = robot_.dof() + k;
      if (!is_dependent(joint)) {
        couplings_.push_back(robot_.couplings[k]);
        continue;
      }
      std::vector<double>& factors = factors_.emplace_back();
      Real offset = joints(joint);
      for (int c = 0; c < robot_.dof(); ++c) {
        factors.push_back(static_cast<double>(G(joint, c)));
        offset -= static_cast<Real>(factors.back()) * y(c);
      }
      couplings_.push_back({factors.data(), static_cast<double>(offset)});
    }
    robot_.couplings.data = couplings_.data();
  }

  // -K_d^-1 dK/dt qd.
  Matrix<Real> accelerations(const Vector<Real>& joints, const Vector<Real>& velocity) const {
    const Vector<Real> change = change_of_rates(robot_, joints, velocity);
    const Matrix<Real> K = dependent_columns(loop_rows(robot_, joints).columns);
    return Real(-1) * least_squares(K, change);
  }
};

// Draws a state in which the loops of the robot are usual; a robot without loops is returned as it is.
inline AtLoops draw(std::mt19937_64& engine, const Robot& robot, Sample& sample, bool single = false) {
  constexpr int kTries = 100;
  for (int i = 0;; ++i) {
    sample = random_sample(engine, robot);
    if (single) sample = in_single(sample);
    AtLoops closed(robot, sample.motion);
    if (closed.is_usual() || i == kTries) return closed;
  }
}

}  // namespace robcogen::reference
