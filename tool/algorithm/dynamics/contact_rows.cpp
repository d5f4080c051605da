#include "algorithm/dynamics/contact_rows.h"

#include "algorithm/dynamics/frame_bias.h"
#include "algorithm/kinematics/chain_columns.h"

namespace robcogen::algorithm {
namespace {

std::vector<std::string> elements(const ContactFrames& contacts, const char* angular, const char* linear) {
  std::vector<std::string> names;
  for (const model::ContactFrame& contact : contacts)
    for (const char* part : {angular, linear})
      for (const char axis : {'x', 'y', 'z'})
        if (contact.is_surface || part == linear) names.push_back(contact.frame.name + "_" + part + axis);
  return names;
}

// The motion of the contact frame by coordinate. For a point the angular parts are left out, because nothing reads
// them.
std::vector<Motion> columns_of(
    Trace& trace,
    const std::vector<Expression>& q,
    const model::FramePair& frames,
    bool is_surface) {
  if (is_surface) return columns_with_base(trace, q, frames);
  std::vector<Motion> columns;
  for (const Vector3& linear : point_columns(trace, q, frames)) columns.push_back({{}, linear});
  return columns;
}

std::vector<std::vector<Motion>> columns_of(
    Trace& trace,
    const std::vector<Expression>& q,
    const ContactFrames& contacts) {
  const model::Frame base = trace.tree.frames().front();
  std::vector<std::vector<Motion>> columns;
  for (const model::ContactFrame& contact : contacts)
    columns.push_back(columns_of(trace, q, {base, contact.frame}, contact.is_surface));
  return columns;
}

}  // namespace

ContactRows::ContactRows(Trace& trace, const std::vector<Expression>& q, const ContactFrames& contacts)
    : ContactRows(contacts, columns_of(trace, q, contacts)) {}

ContactRows::ContactRows(const ContactFrames& contacts, const std::vector<std::vector<Motion>>& columns)
    : ConstraintRows{"contacts", motion_elements(contacts), {}} {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::size_t first = J.size();
    for (std::size_t k = 0; k < columns[c].size(); ++k) {
      const std::vector<Expression> elements = elements_of(contacts[c], columns[c][k]);
      J.resize(first + elements.size(), std::vector<Expression>(columns[c].size()));
      for (std::size_t i = 0; i < elements.size(); ++i) J[first + i][k] = elements[i];
    }
    contact.resize(J.size(), static_cast<int>(c));
  }
}

std::vector<Expression> elements_of(const model::ContactFrame& contact, const Motion& motion) {
  std::vector<Expression> values;
  if (contact.is_surface) values.assign(motion.angular.element.begin(), motion.angular.element.end());
  values.insert(values.end(), motion.linear.element.begin(), motion.linear.element.end());
  return values;
}

std::vector<std::string> motion_elements(const ContactFrames& contacts) {
  return elements(contacts, "w", "v");
}

std::vector<std::string> force_elements(const ContactFrames& contacts) {
  return elements(contacts, "n", "f");
}

std::vector<Expression> contact_bias(
    const TracedRobot& robot,
    const std::vector<LinkMotion>& motions,
    const Vector3& gravity,
    const ContactFrames& contacts) {
  std::vector<Expression> bias;
  for (const model::ContactFrame& contact : contacts) {
    Motion acceleration = acceleration_of(robot, motions, contact.frame);
    acceleration.linear += gravity;
    for (const Expression& e : elements_of(contact, acceleration)) bias.push_back(e);
  }
  return bias;
}

}  // namespace robcogen::algorithm
