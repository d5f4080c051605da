// Checks of inverse kinematics in closed form, through the tables: the reference computes the poses of its branches.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "robcogen/reference/check_dynamics.h"
#include "robcogen/reference/check_identities.h"

namespace robcogen::reference {

inline constexpr Tolerance kInversePose{
    "kInversePose", 1e-12, "rounding, by which the error of a pose exceeds its misfit, relative to the lengths"};
inline constexpr Tolerance kInversePositions{
    "kInversePositions", 1e-6, "where branches meet, roots lose half of their digits"};

// One chain in one state.
class InverseKinematicsCheck {
 public:
  InverseKinematicsCheck(
      const Case& c,
      const reflection::InverseKinematics& chain,
      const std::vector<double>& cache,
      std::mt19937_64& engine,
      Checks& checks)
      : c_(c), chain_(chain), cache_(cache), checks_(checks), q_(c.sample.motion.q), reference_(q_) {
    // Only a given joint is where the target has it.
    for (int row = 0; row < chain.joint_count; ++row)
      if (chain.joints[row] != chain.given) place(reference_, row) += uniform(engine, 1);
    for (double& x : shift_) x = uniform(engine, 2);
  }

  void run() {
    if (chain_.configuration >= 0) signs_ = call(chain_.configuration, {q_.values()});
    if (chain_.redundancy >= 0) swivel_ = call(chain_.redundancy, {q_.values()});
    const Matrix<double> target = transform(c_.robot, q_, chain_.left, chain_.right);
    all_branches(target, true);
    if (chain_.branch >= 0) branch(target);
    Matrix<double> shifted = target;
    for (int i = 0; i < 3; ++i) shifted(i, 3) += shift_[i];
    all_branches(shifted, false);
  }

 private:
  using Values = std::vector<double>;
  using Task = reflection::InverseTask;

  const Case& c_;
  const reflection::InverseKinematics& chain_;
  const Values& cache_;
  Checks& checks_;
  const Vector<double> q_;
  Vector<double> reference_;
  double shift_[3];
  Values signs_, swivel_;

  void record(const char* what, const Tolerance& tolerance, Real error) {
    checks_.record(std::string("inverse_kinematics: ") + what, tolerance, error, c_.index);
  }

  bool slides(int row) const { return c_.robot.joints[chain_.joints[row]].type == JointType::prismatic; }
  double& place(Vector<double>& q, int row) const { return q(c_.robot.position_of(chain_.joints[row])); }

  // Returns all results, one after another.
  Values call(int function, const std::vector<Values>& arguments) const {
    const reflection::Function& f = c_.robot.functions[function];
    Values in, out(static_cast<std::size_t>(f.outputs));
    for (const Values& values : arguments) in.insert(in.end(), values.begin(), values.end());
    if (f.inputs == static_cast<int>(in.size() + cache_.size())) in.insert(in.begin(), cache_.begin(), cache_.end());
    checks_.record("inputs of inverse_kinematics", kExact, f.inputs == static_cast<int>(in.size()) ? 0 : 1, c_.index);
    if (f.inputs == static_cast<int>(in.size())) f.call(in.data(), out.data());
    return out;
  }

  Values of_target(const Matrix<double>& target) const {
    if (chain_.task == Task::position) return origin_of(target).values();
    Values elements;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) elements.push_back(target(row, column));
    return elements;
  }

  // By how much the largest difference in what the task asks for exceeds the misfit, relative to the lengths.
  Real error(const Vector<double>& q, const Matrix<double>& target, Real misfit) const {
    const Matrix<double> difference = transform(c_.robot, q, chain_.left, chain_.right) - target;
    const int first = chain_.task == Task::pose ? 0 : chain_.task == Task::position ? 3 : 2;
    const Real size = largest(difference.block(0, first, 3, 4 - first));
    return worst_of({(size - misfit) / std::max(Real(1), static_cast<Real>(largest(target)))});
  }

  Real distance(const Vector<double>& a, const Vector<double>& b) const {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    Real largest = 0;
    for (int j = 0; j < a.rows(); ++j) {
      Real d = std::abs(a(j) - b(j));
      for (int row = 0; row < chain_.joint_count; ++row)
        if (c_.robot.position_of(chain_.joints[row]) == j && !slides(row)) d = std::abs(std::remainder(d, kTurn));
      largest = worst_of({largest, d});
    }
    return largest;
  }

  // The rate of the swivel angle of the positions q with a joint.
  double swivel_rate(int row) const {
    constexpr double kStep = 1e-5;
    Vector<double> before = q_, behind = q_;
    place(before, row) -= kStep;
    place(behind, row) += kStep;
    const double change = call(chain_.redundancy, {behind.values()})[0] - call(chain_.redundancy, {before.values()})[0];
    return std::remainder(change, 2 * 3.14159265358979323846) / (2 * kStep);
  }

  // Newton steps on a chain that is slightly off miss positions in which it is almost singular: where a pivot of J^T J
  // is small. The last row of J is that of the swivel angle.
  bool may_be_missed() const {
    if (chain_.tolerance == 0) return false;
    constexpr double kLeastPivot = 20;  // per tolerance
    const Matrix<double> pose = transform(c_.robot, q_, chain_.left, chain_.right);
    const Matrix<double> all = frame_jacobian(c_.robot, q_, chain_.left, chain_.right);
    Matrix<double> J(chain_.redundancy < 0 ? 6 : 7, chain_.joint_count - (chain_.given < 0 ? 0 : 1));
    int k = 0;
    for (int row = 0; row < chain_.joint_count; ++row) {
      if (chain_.joints[row] == chain_.given) continue;
      Matrix<double> column = all.col(chain_.joints[row]);
      double about_axis = 0;
      for (int i = 0; i < 3; ++i) about_axis += pose(i, 2) * column(i, 0);
      for (int i = 0; i < 3; ++i) {
        if (chain_.task == Task::position) column(i, 0) = 0;
        if (chain_.task == Task::position_and_axis) column(i, 0) -= about_axis * pose(i, 2);
      }
      J.set_block(0, k, column);
      if (chain_.redundancy >= 0) J(6, k) = swivel_rate(row);
      ++k;
    }
    Matrix<double> N = transpose(J) * J;
    double least = N(0, 0);
    for (k = 0; k < N.rows(); ++k) {
      least = std::min(least, N(k, k));
      for (int i = k + 1; i < N.rows(); ++i)
        for (int j = N.rows(); j-- > k;) N(i, j) -= N(i, k) / N(k, k) * N(k, j);
    }
    return !(least > kLeastPivot * chain_.tolerance);
  }

  // A target of the positions q has a branch with these positions; others may have none.
  void all_branches(const Matrix<double>& target, bool is_of_q) {
    const Values out = call(chain_.all, {of_target(target), swivel_, reference_.values()});
    const auto sines = static_cast<std::size_t>(chain_.joint_count * chain_.branches);
    Real nearest = std::numeric_limits<Real>::infinity(), misfit = nearest;
    for (int branch = 0; branch < chain_.branches; ++branch) {
      Vector<double> q = is_of_q ? q_ : reference_;
      for (int row = 0; row < chain_.joint_count; ++row) {
        const auto i = static_cast<std::size_t>(chain_.joint_count * branch + row);
        const double sine = out[i], cosine = out[sines + i];
        place(q, row) = slides(row) ? sine : std::atan2(sine, cosine);
        if (!slides(row)) record("sines and cosines", kInversePose, std::abs(sine * sine + cosine * cosine - 1));
      }
      const Real of_branch = out[2 * sines + static_cast<std::size_t>(branch)];
      record("poses of all branches", kInversePose, error(q, target, of_branch));
      if (const Real d = distance(q, q_); d < nearest) nearest = d, misfit = of_branch;
    }
    if (!is_of_q || may_be_missed()) return;
    record("positions among all branches", kInversePositions, nearest);
    record("misfit in these positions", kInversePositions, misfit);
  }

  // The branch of the positions q; joints outside of the chain keep the positions of the reference.
  void branch(const Matrix<double>& target) {
    const Values out = call(chain_.branch, {of_target(target), swivel_, signs_, reference_.values()});
    Vector<double> q(q_.rows());
    std::copy_n(out.begin(), q.rows(), q.data());
    const Real misfit = out[static_cast<std::size_t>(q.rows())];
    record("pose of a branch", kInversePose, error(q, target, misfit));
    if (may_be_missed()) return;
    record("positions in a branch", kInversePositions, worst_of({distance(q, q_), misfit}));
  }
};

// Does nothing if the robot has no such chain.
inline void check_inverse_kinematics(
    const Case& c,
    const std::vector<double>& cache,
    std::mt19937_64& engine,
    Checks& checks) {
  for (const reflection::InverseKinematics& chain : c.robot.inverse_kinematics)
    InverseKinematicsCheck(c, chain, cache, engine, checks).run();
}

}  // namespace robcogen::reference
