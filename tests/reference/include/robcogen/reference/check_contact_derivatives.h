// Derivatives of the dynamics with contacts against differences of dense solutions.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "robcogen/reference/check_derivatives.h"
#include "robcogen/reference/contacts.h"

namespace robcogen::reference {

inline constexpr Tolerance kContactDerivative{
    "kContactDerivative", 1e-8, "relative to the largest element; a fourth-order difference of 3e-5 of the reference"};

// A state in which functions of contacts are differentiated.
struct ContactState {
  Situation at;
  Vector<Real> wanted, restitution;        // by row
  std::vector<double> active, compliance;  // by row
};

// (base acceleration, qdd, wrenches); nullopt if the solution in double loses more than `digits`.
inline std::optional<Vector<Real>> constrained_accelerations(const Robot& robot, const ContactState& s, double digits) {
  const Forces<Real> bias = bias_forces(robot, s.at.motion, s.at.loads);
  return solve_contacts(
      joint_space_inertia(robot, s.at.motion.q), contact_jacobian(robot, s.at.motion.q),
      cut(robot.floating_base, stacked(Vector<Real>(6) - bias.base_wrench, s.at.tau - bias.tau)),
      s.wanted - contact_bias(robot, s.at.motion), s.active, s.compliance, digits);
}

// (base velocity, qd) after the impact, and the impulses.
inline std::optional<Vector<Real>> velocities_after_impact(const Robot& robot, const ContactState& s, double digits) {
  const Motion<Real>& m = s.at.motion;
  const Matrix<Real> J = contact_jacobian(robot, m.q);
  const Vector<Real> before = robot.floating_base ? stacked(m.base_velocity, m.qd) : m.qd;
  Vector<Real> change = J * before;
  for (int r = 0; r < change.rows(); ++r) change(r) *= -(1 + s.restitution(r));
  auto result = solve_contacts(
      joint_space_inertia(robot, m.q), J, Vector<Real>(before.rows()), change, s.active, s.compliance, digits);
  if (result) result->set_block(0, 0, result->head(before.rows()) + before);
  return result;
}

// Compares blocks of derivatives, one after another in the results behind the values of the function, with differences
// along a random direction.
class ContactBlocks {
 public:
  using Value = std::optional<Vector<Real>> (*)(const Robot&, const ContactState&, double digits);

  ContactBlocks(const Case& c, std::string name, Vector<Real> results, ContactState state, Value value, Checks& checks)
      : c_(c),
        checks_(checks),
        name_(std::move(name)),
        results_(std::move(results)),
        state_(std::move(state)),
        value_(value),
        rows_(c.H.rows() + state_.wanted.rows()),
        next_(rows_) {}

  // change(state, d): moves the variables of the block, one a column, by d.
  template <class Change>
  void compare(const char* block, int columns, std::mt19937_64& engine, const Change& change) {
    Matrix<Real> found(rows_, columns);
    std::copy_n(results_.data() + next_, rows_ * columns, found.data());
    next_ += rows_ * columns;
    const Vector<Real> direction = uniform_vector(engine, columns, 1).cast<Real>();
    const Vector<Real> expected = difference([&](Real step) {
      constexpr double kAnyDigits = 1e9;
      ContactState moved = state_;
      change(moved, step * direction);
      return in_situation(c_, moved.at, [&](const Robot& robot, const Situation& at) {
        ContactState there = moved;
        there.at = at;
        return value_(robot, there, kAnyDigits).value();
      });
    });
    checks_.record(
        name_ + ": " + block, kContactDerivative, largest(found * direction - expected) / (1 + largest(found)),
        c_.index);
  }

 private:
  const Case& c_;
  Checks& checks_;
  std::string name_;
  Vector<Real> results_;
  ContactState state_;
  Value value_;
  int rows_, next_;
};

// Compare all blocks of a function, in the order of its results.
inline void compare_blocks_of_forward_dynamics(ContactBlocks& blocks, const Case& c, std::mt19937_64& engine) {
  using Along = Vector<Real>;
  const int n = c.robot.dof();
  blocks.compare(
      "d_q", n, engine, [&](ContactState& s, const Along& d) { s.at.motion.q = moved(c.robot, s.at.motion.q, d); });
  blocks.compare("d_qd", n, engine, [](ContactState& s, const Along& d) { s.at.motion.qd += d; });
  blocks.compare("d_tau", n, engine, [](ContactState& s, const Along& d) { s.at.tau += d; });
  if (c.floating) {
    blocks.compare("d_base_rotation", 3, engine, [](ContactState& s, const Along& d) {
      s.at.loads.gravity = seen_from_turned_base(s.at.loads.gravity, d);
    });
    blocks.compare(
        "d_base_velocity", 6, engine, [](ContactState& s, const Along& d) { s.at.motion.base_velocity += d; });
  }
  const int rows = contact_rows(c.robot);
  blocks.compare("d_contact_acceleration", rows, engine, [](ContactState& s, const Along& d) { s.wanted += d; });
}

inline void compare_blocks_of_impact(ContactBlocks& blocks, const Case& c, std::mt19937_64& engine) {
  using Along = Vector<Real>;
  const int n = c.robot.dof();
  blocks.compare(
      "d_q", n, engine, [&](ContactState& s, const Along& d) { s.at.motion.q = moved(c.robot, s.at.motion.q, d); });
  blocks.compare("d_qd", n, engine, [](ContactState& s, const Along& d) { s.at.motion.qd += d; });
  if (c.floating)
    blocks.compare(
        "d_base_velocity", 6, engine, [](ContactState& s, const Along& d) { s.at.motion.base_velocity += d; });
  blocks.compare("d_restitution", c.robot.contacts.size, engine, [&](ContactState& s, const Along& d) {
    const std::vector<double> rows = by_row(c.robot, d.cast<double>().values());
    for (int r = 0; r < s.restitution.rows(); ++r) s.restitution(r) += Real(rows[static_cast<std::size_t>(r)]);
  });
}

}  // namespace robcogen::reference
