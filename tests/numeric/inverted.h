// Inverse kinematics of a chain, interpreted, with the reference for it.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "algorithm/kinematics/inverse_kinematics.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/spatial/trace.h"
#include "dice.h"
#include "linear_algebra.h"
#include "reference_tables.h"
#include "robcogen/reference/kinematics.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric {

using algorithm::InverseKinematicsSize;
using model::InverseTask;
using model::KinematicTree;
using reference::Matrix;
using reference::Vector;
using Values = std::vector<double>;

inline constexpr double kPi = 3.14159265358979323846;

// Positions are those of all coordinates of the robot.
class Inverted {
 public:
  Inverted(KinematicTree tree, const model::FramePair& frames, const InverseTask& task)
      : tree_(std::move(tree)),
        parameters_(algorithm::parameter_values(tree_)),
        tables_(reference_tables(tree_, parameters_)),
        frames_(frames),
        task_(task),
        rows_(algorithm::chain_coordinates(tree_, frames)),
        size_(algorithm::inverse_kinematics_size(tree_, frames_, task_)) {
    if (size_.branches == 0) return;
    all_ = algorithm::inverse_kinematics(tree_, frames_, task_, "all");
    if (task_.by_swivel) redundancy_ = algorithm::inverse_kinematics_redundancy(tree_, frames_, task_, "redundancy");
    if (size_.signs == 0) return;
    branch_ = algorithm::inverse_kinematics_branch(tree_, frames_, task_, "branch");
    configuration_ = algorithm::inverse_kinematics_configuration(tree_, frames_, task_, "configuration");
  }

  InverseKinematicsSize size() const { return size_; }
  int dof() const { return tree_.dof(); }
  bool slides(int k) const {
    const int joint = tree_.coordinates()[static_cast<std::size_t>(k)];
    return tree_.joints[static_cast<std::size_t>(joint)].type == model::JointType::prismatic;
  }

  Matrix<double> pose(const Values& q) const {
    Vector<double> positions(dof());
    for (int k = 0; k < dof(); ++k) positions(k) = q[static_cast<std::size_t>(k)];
    return reference::transform(
        tables_.robot(), positions, frame_index(tree_, frames_.left), frame_index(tree_, frames_.right));
  }
  double determinant(const Values& q) const {
    Vector<double> positions(dof());
    for (int k = 0; k < dof(); ++k) positions(k) = q[static_cast<std::size_t>(k)];
    const Matrix<double> J = reference::frame_jacobian(
        tables_.robot(), positions, frame_index(tree_, frames_.left), frame_index(tree_, frames_.right));
    const int rows = task_.kind == InverseTask::Kind::point ? 3 : 6;
    Eigen::MatrixXd columns(rows, rows);
    for (int k = 0, column = 0; k < dof(); ++k) {
      if (k == task_.given) continue;
      for (int i = 0; i < rows; ++i) columns(i, column) = J(6 - rows + i, k);
      ++column;
    }
    return test::determinant(columns);
  }
  bool has_determinant() const { return size_.has_determinant; }

  // The largest difference in what the task asks for.
  double error(const Values& q, const Matrix<double>& target) const {
    const Matrix<double> found = pose(q);
    double largest = 0.0;
    for (int column = 0; column < 4; ++column) {
      if (column < 3 && task_.kind == InverseTask::Kind::point) continue;
      if (column < 2 && task_.kind == InverseTask::Kind::axis) continue;
      for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(found(row, column) - target(row, column)));
    }
    return largest;
  }

  struct Branch {
    Values q;
    double misfit, determinant;
  };
  std::vector<Branch> branches(const Matrix<double>& target, const Values& reference) const {
    auto found = symbolic::interpret(all_, arguments(target, reference, {}));
    std::vector<Branch> list;
    for (std::size_t b = 0; b < static_cast<std::size_t>(size_.branches); ++b) {
      Values q = reference;
      for (std::size_t row = 0; row < rows_.size(); ++row) {
        const std::size_t place = b * rows_.size() + row;
        double& position = q[static_cast<std::size_t>(rows_[row])];
        position = found["sin_q"][place];
        if (slides(rows_[row])) continue;
        position = std::atan2(found["sin_q"][place], found["cos_q"][place]);
        EXPECT_NEAR(std::hypot(found["sin_q"][place], found["cos_q"][place]), 1.0, 1e-12);
      }
      list.push_back({q, found["misfit"][b], found["determinant"][b]});
    }
    return list;
  }
  Values signs(const Values& q) const { return symbolic::interpret(configuration_, at({{"q", q}}))["signs"]; }
  Branch branch(const Matrix<double>& target, const Values& signs, const Values& reference) const {
    auto found = symbolic::interpret(branch_, arguments(target, reference, {{"signs", signs}}));
    return {found["q"], found["misfit"][0], found["determinant"][0]};
  }

  double distance(const Values& a, const Values& b) const {
    double largest = 0.0;
    for (int k = 0; k < dof(); ++k) {
      const double d = a[static_cast<std::size_t>(k)] - b[static_cast<std::size_t>(k)];
      largest = std::max(largest, std::abs(slides(k) ? d : std::remainder(d, 2 * kPi)));
    }
    return largest;
  }

 private:
  KinematicTree tree_;
  Values parameters_;
  reference::Tables tables_;
  model::FramePair frames_;
  InverseTask task_;
  std::vector<int> rows_;  // coordinates of the chain
  InverseKinematicsSize size_;
  symbolic::Program all_, branch_, configuration_, redundancy_;

  symbolic::Arrays<double> at(symbolic::Arrays<double> arrays) const {
    if (!parameters_.empty()) arrays["parameters"] = parameters_;
    return arrays;
  }

  // The swivel is that of the reference.
  symbolic::Arrays<double> arguments(
      const Matrix<double>& target,
      const Values& reference,
      symbolic::Arrays<double> arrays) const {
    arrays["reference"] = reference;
    if (task_.by_swivel)
      arrays["swivel"] = symbolic::interpret(redundancy_, symbolic::Arrays<double>{{"q", reference}})["swivel"];
    Values X;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) X.push_back(target(row, column));
    if (task_.kind == InverseTask::Kind::point)
      arrays["p"] = {X.begin() + 12, X.begin() + 15};
    else
      arrays["X"] = X;
    return at(std::move(arrays));
  }
};

// Random positions, or special ones: at and next to quarter turns, where chains are singular.
inline Values random_positions(const Inverted& chain, Dice& dice, bool is_special) {
  Values q;
  for (int k = 0; k < chain.dof(); ++k) {
    q.push_back(chain.slides(k) ? dice.between(-0.5, 0.5) : dice.between(-kPi, kPi));
    if (is_special && !chain.slides(k) && dice.chance(0.35))
      q.back() = (dice.below(5) - 2) * kPi / 2 + (dice.below(3) - 1) * std::pow(10.0, -2 - dice.below(15));
  }
  return q;
}

}  // namespace robcogen::numeric
