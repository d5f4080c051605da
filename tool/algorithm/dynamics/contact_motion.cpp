#include "algorithm/dynamics/contact_motion.h"

#include "algorithm/kinematics/path.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

// The motion of a point of a link.
struct PointMotion {
  Vector3 w, wd;
  Vector3 p, v, a;  // position, velocity, classical acceleration

  // Another point of the same link.
  PointMotion at_point(const Vector3& position) const {
    const Vector3 arm = position - p, turning = cross(w, arm);
    PointMotion other{w, wd, position, v + turning, a};
    other.a += cross(wd, arm);
    other.a += cross(w, turning);
    return other;
  }
};

// The motion subspace of a joint, and its rates while it moves with the link before the joint.
struct MovingAxis {
  int joint = 0, first = 0;
  Motion S, rate, second_rate;
  Vector3 mean_rate;  // of the axis, at the mean velocity of a spherical joint
  PointMotion origin;
};

Motion turned(const Vector3& w, const Motion& m) {
  return {cross(w, m.angular), cross(w, m.linear)};
}

class Chain {
 public:
  Chain(Trace& trace, const StateInputs& in)
      : trace_(trace), in_(in), two_(trace.graph.constant(2.0)), half_(trace.graph.constant(0.5)) {
    const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, {});
    link_ = {base.angular.w, base.angular.wd, {}, in.base_velocity.linear, base.a};
  }

  // Passes one joint, or the components of a spherical one.
  void pass(const std::vector<JointOnPath>& joints, const PathPose& here) {
    const PointMotion before = link_.at_point(here.position);
    Vector3 relative;  // angular velocity, and its rate in axes of the link before
    PointMotion behind = before;
    const std::size_t first = axes_.size();
    for (const auto& [joint, backward] : joints) {
      const Motion S = in_axes(here.rotation, subspace(joint_of(trace_, joint), trace_.graph), backward);
      const Motion rate = turned(before.w, S), second = turned(before.wd, S);
      axes_.push_back({joint, joints.front().joint, S, rate, second, {}, before});
      axes_.back().second_rate += turned(before.w, rate);
      const Expression &qd = in_.qd[at(joint)], &qdd = in_.qdd[at(joint)];
      relative += qd * S.angular;
      behind.wd += qdd * S.angular;
      behind.wd += qd * rate.angular;
      behind.v += qd * S.linear;
      behind.a += qdd * S.linear;
      behind.a += two_ * (qd * rate.linear);
    }
    behind.w += relative;
    for (std::size_t k = first; k < axes_.size(); ++k) {
      MovingAxis& axis = axes_[k];
      axis.mean_rate = axis.rate.angular;
      if (joints.size() > 1) axis.mean_rate += half_ * cross(relative, axis.S.angular);
      describe_axis(axis);
    }
    link_ = behind;
  }

  ContactMotion at_end(const Vector3& position, const std::string& frame) const {
    const PointMotion contact = link_.at_point(position);
    described("p", frame, position);
    described("v", frame, contact.v);
    described("a", frame, contact.a);
    ContactMotion result{{}, position, {}};
    for (const MovingAxis& axis : axes_) result.columns.push_back(column_of(axis, contact));
    if (!trace_.tree.floating_base) return result;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 axis = unit_vector(trace_.graph, k), rate = cross(in_.base_velocity.angular, axis);
      const Vector3 relative = contact.v - in_.base_velocity.linear;
      Motion& change = result.acceleration_by_base_velocity[k];
      change = {rate + cross(axis, contact.w), cross(axis, in_.base_velocity.linear)};
      change.linear += cross(rate, position);
      change.linear += two_ * cross(axis, relative);
    }
    return result;
  }

 private:
  Trace& trace_;
  const StateInputs& in_;
  Expression two_, half_;
  PointMotion link_;  // of the link reached
  std::vector<MovingAxis> axes_;

  ContactColumn column_of(const MovingAxis& axis, const PointMotion& contact) const {
    const Vector3 &s = axis.S.angular, &sd = axis.rate.angular, &sdd = axis.second_rate.angular;
    const Vector3 &l = axis.S.linear, &ld = axis.rate.linear, &ldd = axis.second_rate.linear;
    const Vector3 r = contact.p - axis.origin.p, rd = contact.v - axis.origin.v, rdd = contact.a - axis.origin.a;
    const Vector3 along = cross(s, rd), turning = cross(sd, r) + along;
    const Vector3 mean = is_single(axis) ? turning : cross(axis.mean_rate, r) + along;
    const Vector3 with_contact = cross(s, contact.w);
    ContactColumn result{axis.joint,           axis.first,
                         {s, l + cross(s, r)}, {sd + with_contact, ld + turning},
                         {sdd, ldd},           {two_ * axis.mean_rate + with_contact, two_ * (ld + mean)}};
    Motion& by_position = result.acceleration_by_position;
    by_position.angular += cross(sd, contact.w);
    by_position.angular += cross(s, contact.wd);
    by_position.linear += cross(sdd, r);
    by_position.linear += two_ * cross(sd, rd);
    by_position.linear += cross(s, rdd);
    return result;
  }

  bool is_single(const MovingAxis& axis) const { return !joint_of(trace_, axis.joint).is_spherical(); }

  void describe_axis(const MovingAxis& axis) const {
    const std::string& name = trace_.tree.joints[at(axis.joint)].name;
    described({name, "axis"}, axis.S);
    described({name, "axis_d"}, axis.rate);
    described({name, "axis_dd"}, axis.second_rate);
  }
};

// The wrench at a contact, from its rows.
Force wrench_at(const model::ContactFrame& contact, const std::vector<Expression>& f, std::size_t first) {
  const std::size_t force = first + (contact.is_surface ? 3 : 0);
  Force wrench{{}, {f[force], f[force + 1], f[force + 2]}};
  if (contact.is_surface) wrench.moment = {f[first], f[first + 1], f[first + 2]};
  return wrench;
}

std::size_t row_count(const model::ContactFrame& contact) {
  return contact.is_surface ? 6 : 3;
}

// The derivatives of the forces of one contact, added to columns by joint with rows of the base and of joints. Column j
// turns the columns i of the Jacobian behind it (or of the same spherical joint), and moves the point for those before.
void add_force_derivatives(
    const ContactMotion& motion,
    const Force& wrench,
    std::size_t base,
    bool floating,
    Columns& by_joint) {
  std::vector<Vector3> turned_force, turned_moment;  // F x s, M x s
  for (const ContactColumn& c : motion.columns) {
    turned_force.push_back(cross(wrench.linear, c.column.angular));
    turned_moment.push_back(cross(wrench.moment, c.column.angular));
  }
  for (std::size_t j = 0; j < motion.columns.size(); ++j) {
    const ContactColumn& moving = motion.columns[j];
    std::vector<Expression>& column = by_joint[at(moving.joint)];
    for (std::size_t i = 0; i < motion.columns.size(); ++i) {
      const ContactColumn& row = motion.columns[i];
      const bool turns = i >= j || row.first == moving.first;
      Expression& value = column[base + at(row.joint)];
      value += turns ? dot(row.column.linear, turned_force[j]) : dot(moving.column.linear, turned_force[i]);
      if (turns) value += dot(row.column.angular, turned_moment[j]);
    }
    if (!floating) continue;
    const Vector3 moment = cross(moving.column.linear, wrench.linear);
    for (std::size_t k = 0; k < 3; ++k) column[k] += moment[k];
  }
}

}  // namespace

ContactMotion contact_motion(Trace& trace, const StateInputs& in, const model::Frame& frame) {
  Chain chain(trace, in);
  const Path path = path_between(trace.tree, {trace.tree.frames().front(), frame});
  const PathPose end = walk(
      trace, path, in.q, [&](const PathSegment& segment, const PathPose& here) { chain.pass(segment.joints, here); });
  trace.section(frame.name, "contact ", ": how its motion changes");
  return chain.at_end(end.position, frame.name);
}

std::vector<ContactMotion> contact_motions(Trace& trace, const StateInputs& in, const ContactFrames& contacts) {
  std::vector<ContactMotion> motions;
  for (const model::ContactFrame& contact : contacts) motions.push_back(contact_motion(trace, in, contact.frame));
  return motions;
}

ContactRows contact_rows(Trace& trace, const ContactFrames& contacts, const std::vector<ContactMotion>& motions) {
  std::vector<std::vector<Motion>> columns;
  for (const ContactMotion& motion : motions) {
    std::vector<Motion>& of_contact = columns.emplace_back();
    if (trace.tree.floating_base) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 axis = unit_vector(trace.graph, k);
        of_contact.push_back({axis, cross(axis, motion.position)});
      }
      for (std::size_t k = 0; k < 3; ++k) of_contact.push_back({{}, unit_vector(trace.graph, k)});
    }
    std::vector<Motion> by_joint(trace.tree.joints.size());
    for (const ContactColumn& c : motion.columns) by_joint[at(c.joint)] = c.column;
    for (const std::vector<MovedJoint>& moved : moved_joints(trace))
      of_contact.push_back(sum_of(moved, [&](int joint) { return by_joint[at(joint)]; }));
  }
  return {contacts, columns};
}

Columns by_coordinate(
    Trace& trace,
    const ContactFrames& contacts,
    const std::vector<ContactMotion>& motions,
    Motion ContactColumn::*part) {
  std::size_t rows = 0, first = 0;
  for (const model::ContactFrame& contact : contacts) rows += row_count(contact);
  Columns by_joint(trace.tree.joints.size(), std::vector<Expression>(rows));
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    for (const ContactColumn& column : motions[c].columns) {
      const std::vector<Expression> elements = elements_of(contacts[c], column.*part);
      for (std::size_t i = 0; i < elements.size(); ++i) by_joint[at(column.joint)][first + i] = elements[i];
    }
    first += row_count(contacts[c]);
  }
  if (trace.tree.couplings.empty()) return by_joint;
  Columns result;
  for (const std::vector<MovedJoint>& moved : moved_joints(trace)) {
    std::vector<Expression>& column = result.emplace_back();
    for (std::size_t row = 0; row < rows; ++row)
      column.push_back(sum_of(moved, [&](int joint) { return by_joint[at(joint)][row]; }));
  }
  return result;
}

Columns generalized_force_derivatives(
    Trace& trace,
    const ContactFrames& contacts,
    const std::vector<ContactMotion>& motions,
    const std::vector<Expression>& f) {
  const bool floating = trace.tree.floating_base;
  const std::size_t joints = trace.tree.joints.size(), base = floating ? 6 : 0;
  Columns by_joint(joints, std::vector<Expression>(base + joints));
  std::size_t first = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    trace.section(contacts[c].frame.name, "contact ", ": derivatives of its forces on the coordinates");
    add_force_derivatives(motions[c], wrench_at(contacts[c], f, first), base, floating, by_joint);
    first += row_count(contacts[c]);
  }
  return by_coordinate(trace, by_joint, static_cast<int>(base));
}

}  // namespace robcogen::algorithm
