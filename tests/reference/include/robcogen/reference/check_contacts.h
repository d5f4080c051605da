// Checks of contact functions against the dense equations, through the table of functions.
#pragma once

#include <algorithm>
#include <string>

#include "robcogen/reference/check_contact_derivatives.h"
#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/contacts.h"

namespace robcogen::reference {

inline constexpr Tolerance kContact{
    "kContact", 1e-9, "relative to the largest result; systems that lose more digits are passed over"};

// One state of a robot with contacts, and calls of its functions by name.
class ContactCheck {
 public:
  ContactCheck(const Case& c, const std::vector<double>& cache, std::mt19937_64& engine, Checks& checks)
      : c_(c), cache_(cache), engine_(engine), checks_(checks), rows_(contact_rows(c.robot)) {}

  void run() {
    if (has("contact_jacobian")) kinematics();
    if (has("constrained_forward_dynamics")) forward_dynamics();
    if (has("impact")) impact();
    if (has("constrained_forward_dynamics_derivatives")) forward_dynamics_derivatives();
    if (has("impact_derivatives")) impact_derivatives();
    if (has("inverse_dynamics_with_contacts")) inverse_dynamics();
    if (has("operational_space")) operational_space();
  }

 private:
  using Values = std::vector<double>;

  const Case& c_;
  const Values& cache_;
  std::mt19937_64& engine_;
  Checks& checks_;
  int rows_;
  Matrix<Real> J_ = contact_jacobian(c_.robot, c_.motion.q);

  const reflection::Function* find(const std::string& name) const {
    const auto found = std::find_if(
        c_.robot.functions.begin(), c_.robot.functions.end(),
        [&](const reflection::Function& f) { return name == f.name; });
    return found == c_.robot.functions.end() ? nullptr : found;
  }
  bool has(const std::string& name) const { return find(name) != nullptr; }

  // Returns all results, one after another.
  Vector<Real> call(const std::string& name, const std::vector<Values>& arguments) const {
    const reflection::Function& f = *find(name);
    Values in = cache_, out(static_cast<std::size_t>(f.outputs));
    for (const Values& values : arguments) in.insert(in.end(), values.begin(), values.end());
    checks_.record(
        "inputs of functions of contacts", kExact, static_cast<int>(in.size()) == f.inputs ? 0 : 1, c_.index);
    if (static_cast<int>(in.size()) != f.inputs) return Vector<Real>(f.outputs);
    f.call(in.data(), out.data());
    Vector<Real> result(f.outputs);
    std::copy(out.begin(), out.end(), result.data());
    return result;
  }

  void record(const std::string& name, const Vector<Real>& found, const Vector<Real>& expected) {
    checks_.record(name, kContact, largest(found - expected) / (1 + largest(expected)), c_.index);
  }

  Values random(int count, double low, double high) {
    Values values(static_cast<std::size_t>(count));
    for (double& x : values) x = (low + high) / 2 + uniform(engine_, (high - low) / 2);
    return values;
  }
  Values random_activity() {
    Values values(static_cast<std::size_t>(c_.robot.contacts.size));
    for (double& x : values) x = uniform(engine_, 1) > -0.4 ? 1 : 0;
    return values;
  }

  Values base_velocity() const { return c_.floating ? c_.sample.motion.base_velocity.values() : Values(); }
  Values base_acceleration() const { return c_.floating ? c_.sample.motion.base_acceleration.values() : Values(); }
  // Returns the elements in the order of results: joints first, then the base.
  Vector<Real> joints_first(const Vector<Real>& x) const {
    const int n = c_.robot.dof();
    return c_.floating ? stacked(x.block(6, 0, n, 1), x.head(6)) : x.head(n);
  }
  Vector<Real> velocity() const { return c_.floating ? stacked(c_.motion.base_velocity, c_.motion.qd) : c_.motion.qd; }
  static Vector<Real> column_by_column(const Matrix<Real>& m) {
    Vector<Real> v(m.rows() * m.cols());
    std::copy(m.values().begin(), m.values().end(), v.data());
    return v;
  }
  static Vector<Real> vector(const Values& values) {
    Vector<Real> v(static_cast<int>(values.size()));
    std::copy(values.begin(), values.end(), v.data());
    return v;
  }

  void kinematics() {
    const Motion<double>& m = c_.sample.motion;
    record("contact_jacobian", call("contact_jacobian", {m.q.values()}), column_by_column(J_));
    const std::vector<Values> state = {m.q.values(), m.qd.values(), base_velocity()};
    record("contact_velocity", call("contact_velocity", state), J_ * velocity());
    record("contact_bias", call("contact_bias", state), contact_bias(c_.robot, c_.motion));
    const Matrix<Real> W = J_ * solve(c_.H, transpose(J_));
    record("inverse_contact_inertia", call("inverse_contact_inertia", {m.q.values()}), column_by_column(W));
  }

  void forward_dynamics() {
    const Motion<double>& m = c_.sample.motion;
    const int n = c_.robot.dof();
    const Values tau = random(n, -20, 20), wanted = random(rows_, -5, 5);
    const Values active = random_activity(), compliance = random(rows_, 0.1, 1);
    Values external;
    for (const Vector<double>& wrench : c_.sample.external)
      external.insert(external.end(), wrench.values().begin(), wrench.values().end());
    for (const Overload& o : overloads(c_.sample)) {
      // There are kernels with all arguments, and kernels with standard gravity only.
      const bool all = o.arguments.gravity != nullptr && o.arguments.external != nullptr;
      const bool folded = o.arguments.gravity == nullptr && o.arguments.external == nullptr && !c_.floating;
      if (!all && !folded) continue;
      std::vector<Values> arguments = {m.q.values(), m.qd.values(), tau, base_velocity(), wanted, active, compliance};
      if (all) arguments.insert(arguments.end(), {c_.sample.gravity.values(), external});
      const std::string name = std::string("constrained_forward_dynamics") + (all ? "_external" : "");
      const Forces<Real> bias = bias_forces(c_.robot, c_.motion, o.loads);
      const Vector<Real> forces = cut(c_.floating, stacked(Vector<Real>(6) - bias.base_wrench, vector(tau) - bias.tau));
      const auto expected = solve_contacts(
          c_.H, J_, forces, vector(wanted) - contact_bias(c_.robot, c_.motion), by_row(c_.robot, active), compliance,
          1e-3 * kContact.value);
      if (!expected) continue;
      record(name, call(name, arguments), stacked(joints_first(*expected), expected->tail(rows_)));
    }
  }

  void impact() {
    const Motion<double>& m = c_.sample.motion;
    const Values active = random_activity(), compliance = random(rows_, 0.1, 1);
    const Values restitution = random(c_.robot.contacts.size, 0, 1), e = by_row(c_.robot, restitution);
    Vector<Real> change = J_ * velocity();
    for (int r = 0; r < rows_; ++r) change(r) *= -(1 + Real(e[static_cast<std::size_t>(r)]));
    const auto expected = solve_contacts(
        c_.H, J_, Vector<Real>(c_.H.rows()), change, by_row(c_.robot, active), compliance, 1e-3 * kContact.value);
    if (!expected) return;
    const Vector<Real> after = velocity() + expected->head(c_.H.rows());
    record(
        "impact", call("impact", {m.q.values(), m.qd.values(), base_velocity(), restitution, active, compliance}),
        stacked(joints_first(after), expected->tail(rows_)));
  }

  // A state with random contacts.
  ContactState contact_state(const Loads<Real>& loads) {
    const Values restitution = random(c_.robot.contacts.size, 0, 1);
    return {
        {c_.motion, loads, vector(random(c_.robot.dof(), -20, 20))},
        vector(random(rows_, -5, 5)),
        vector(by_row(c_.robot, restitution)),
        by_row(c_.robot, random_activity()),
        random(rows_, 0.1, 1)};
  }
  // One value per contact, from one per row.
  Values by_contact(const std::vector<Real>& rows) const {
    Values values;
    int next = 0;
    for (const reflection::Contact& contact : c_.robot.contacts) {
      values.push_back(static_cast<double>(rows[static_cast<std::size_t>(next)]));
      next += contact.is_surface ? 6 : 3;
    }
    return values;
  }
  static Values doubles(const Vector<Real>& v) { return v.cast<double>().values(); }

  void forward_dynamics_derivatives() {
    const Motion<double>& m = c_.sample.motion;
    Values external;
    for (const Vector<double>& wrench : c_.sample.external)
      external.insert(external.end(), wrench.values().begin(), wrench.values().end());
    for (const Overload& o : overloads(c_.sample)) {
      const bool all = o.arguments.gravity != nullptr && o.arguments.external != nullptr;
      const bool folded = o.arguments.gravity == nullptr && o.arguments.external == nullptr && !c_.floating;
      if (!all && !folded) continue;
      const ContactState s = contact_state(o.loads);
      const auto expected = constrained_accelerations(c_.robot, s, 1e-3 * kContact.value);
      if (!expected) continue;
      const std::vector<Real> active(s.active.begin(), s.active.end());
      std::vector<Values> arguments = {m.q.values(),      m.qd.values(),      doubles(s.at.tau), base_velocity(),
                                       doubles(s.wanted), by_contact(active), s.compliance};
      if (all) arguments.insert(arguments.end(), {c_.sample.gravity.values(), external});
      const std::string name = std::string("constrained_forward_dynamics_derivatives") + (all ? "_external" : "");
      const Vector<Real> found = call(name, arguments);
      record(name, found.head(c_.H.rows() + rows_), stacked(joints_first(*expected), expected->tail(rows_)));
      ContactBlocks blocks(c_, name, found, s, constrained_accelerations, checks_);
      compare_blocks_of_forward_dynamics(blocks, c_, engine_);
    }
  }

  void impact_derivatives() {
    const Motion<double>& m = c_.sample.motion;
    const ContactState s = contact_state({});
    const auto expected = velocities_after_impact(c_.robot, s, 1e-3 * kContact.value);
    if (!expected) return;
    const std::vector<Real> active(s.active.begin(), s.active.end());
    const Vector<Real> found = call(
        "impact_derivatives", {m.q.values(), m.qd.values(), base_velocity(), by_contact(s.restitution.values()),
                               by_contact(active), s.compliance});
    record(
        "impact_derivatives", found.head(c_.H.rows() + rows_), stacked(joints_first(*expected), expected->tail(rows_)));
    ContactBlocks blocks(c_, "impact_derivatives", found, s, velocities_after_impact, checks_);
    compare_blocks_of_impact(blocks, c_, engine_);
  }

  void inverse_dynamics() {
    const Motion<double>& m = c_.sample.motion;
    const Values wrenches = random(rows_, -50, 50);
    const Loads<Real> loads = reference::loads<Real>(c_.sample.gravity);
    const Vector<Real> needed = cut(c_.floating, generalized_forces(c_.robot, c_.motion, loads));
    const std::string overload = c_.floating ? "" : "_gravity";
    record(
        "inverse_dynamics_with_contacts",
        call(
            "inverse_dynamics_with_contacts" + overload, {m.q.values(), m.qd.values(), m.qdd.values(), base_velocity(),
                                                          base_acceleration(), wrenches, c_.sample.gravity.values()}),
        joints_first(needed - transpose(J_) * vector(wrenches)));
    if (!has("constrained_inverse_dynamics")) return;
    const Values weights = random(rows_, 0.5, 2);
    const double r = 0.2;
    const Matrix<Real> J_b = J_.block(0, 0, rows_, 6);
    Matrix<Real> weighted = J_b;
    for (int i = 0; i < rows_; ++i)
      for (int k = 0; k < 6; ++k) weighted(i, k) *= Real(weights[static_cast<std::size_t>(i)]);
    const Matrix<Real> K = transpose(J_b) * weighted + Real(r) * Matrix<Real>::identity(6);
    const Vector<Real> f = weighted * solve(K, needed.head(6));
    const Vector<Real> left = joints_first(needed - transpose(J_) * f);
    const int n = c_.robot.dof();
    record(
        "constrained_inverse_dynamics",
        call(
            "constrained_inverse_dynamics", {m.q.values(),
                                             m.qd.values(),
                                             m.qdd.values(),
                                             base_velocity(),
                                             base_acceleration(),
                                             weights,
                                             {r},
                                             c_.sample.gravity.values()}),
        stacked(stacked(left.head(n), f), left.tail(6)));
    smallest_torque(needed, weights, r);
  }

  // (1 / weights + J_q U J_q^T) f = J_q U tau + J_b y, J_b^T f + r y = the wrench on the base.
  void smallest_torque(const Vector<Real>& needed, const Values& weights, double r) {
    const Motion<double>& m = c_.sample.motion;
    const int n = c_.robot.dof();
    const Values torque_weights = random(n, 0, 2);
    const Matrix<Real> J_b = J_.block(0, 0, rows_, 6), J_q = J_.block(0, 6, rows_, n);
    Matrix<Real> costly = J_q;
    for (int i = 0; i < rows_; ++i)
      for (int k = 0; k < n; ++k) costly(i, k) *= Real(torque_weights[static_cast<std::size_t>(k)]);
    Matrix<Real> M = costly * transpose(J_q);
    for (int i = 0; i < rows_; ++i) M(i, i) += Real(1) / Real(weights[static_cast<std::size_t>(i)]);
    const Vector<Real> of_torque = solve(M, costly * needed.tail(n));
    const Matrix<Real> of_base = solve(M, J_b);
    const Matrix<Real> K = transpose(J_b) * of_base + Real(r) * Matrix<Real>::identity(6);
    const Vector<Real> f = of_torque + of_base * solve(K, needed.head(6) - transpose(J_b) * of_torque);
    const Vector<Real> left = joints_first(needed - transpose(J_) * f);
    record(
        "minimum_torque_inverse_dynamics",
        call(
            "minimum_torque_inverse_dynamics", {m.q.values(),
                                                m.qd.values(),
                                                m.qdd.values(),
                                                base_velocity(),
                                                base_acceleration(),
                                                weights,
                                                torque_weights,
                                                {r},
                                                c_.sample.gravity.values()}),
        stacked(stacked(left.head(n), f), left.tail(6)));
  }

  void operational_space() {
    const Values active = random_activity(), compliance = random(rows_, 0.1, 1), on = by_row(c_.robot, active);
    const int size = c_.H.rows();
    Matrix<Real> inertia(rows_, rows_), inverse(size, rows_);
    for (int k = 0; k < rows_; ++k) {
      if (on[static_cast<std::size_t>(k)] == 0) continue;
      Vector<Real> unit(rows_);
      unit(k) = 1;
      const auto x = solve_contacts(c_.H, J_, Vector<Real>(size), unit, on, compliance, 1e-3 * kContact.value);
      if (!x) return;
      inverse.set_block(0, k, x->head(size));
      inertia.set_block(0, k, x->tail(rows_));
    }
    const Matrix<Real> projector = Matrix<Real>::identity(size) - inverse * J_;
    record(
        "operational_space", call("operational_space", {c_.sample.motion.q.values(), active, compliance}),
        stacked(stacked(column_by_column(inertia), column_by_column(inverse)), column_by_column(projector)));
  }
};

// Does nothing if the robot has no contacts.
inline void check_contacts(const Case& c, const std::vector<double>& cache, std::mt19937_64& engine, Checks& checks) {
  if (c.robot.contacts.size > 0) ContactCheck(c, cache, engine, checks).run();
}

}  // namespace robcogen::reference
