#include "algorithm/composite.h"

#include <functional>

namespace robcogen::algorithm {
namespace {

void name_composite(Trace& trace, const std::string& link, const MassProperties& m) {
  name(trace.graph, m.first_moment, link + "_h");
  const char* axes = "xyz";
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) trace.graph.name(m.pseudo_inertia[i][j], link + "_S" + axes[i] + axes[j]);
}

void collect(const Setup& setup, int link, std::vector<MassProperties>& composite) {
  const auto l = static_cast<std::size_t>(link);
  composite[l] = setup.mass(link);
  for (const JointView& joint : setup.children(link)) {
    collect(setup, joint.child, composite);
    if (!setup.parent_matters(joint.child)) continue;
    const std::string& name = setup.link_name(link);
    setup.trace.section(name, "link " + name + ": composite inertia");
    composite[l] = composite[l] + to_parent(setup.pose(joint.index), composite[static_cast<std::size_t>(joint.child)]);
  }
  name_composite(setup.trace, setup.link_name(link), composite[l]);
}

}  // namespace

std::vector<MassProperties> composite_bodies(const Setup& setup) {
  std::vector<MassProperties> composite(setup.tree().links.size());
  collect(setup, 0, composite);
  return composite;
}

MassProperties moving_body(const Setup& setup, const std::vector<MassProperties>& composite) {
  if (setup.floating()) return composite[0];
  MassProperties total;
  for (const JointView& joint : setup.children(0))
    total = total + to_parent(setup.pose(joint.index), composite[static_cast<std::size_t>(joint.child)]);
  return total;
}

Spatial unit_wrench(const MassProperties& m, bool revolute) {
  const Vector3& h = m.first_moment;
  const Matrix3& s = m.pseudo_inertia;
  const Expression zero;
  if (revolute) return {{-s[0][2], -s[1][2], s[0][0] + s[1][1]}, {-h[1], h[0], zero}};
  return {{h[1], -h[0], zero}, {zero, zero, m.mass}};
}

Spatial rigid_body_acceleration(Trace& trace, const MassProperties& body, const Spatial& missing) {
  trace.section(trace.tree.links[0].name, "base: acceleration");
  const Matrix3 inertia = inertia_tensor(body);
  const Matrix3 coupling = skew(body.first_moment);  // moment from linear acceleration: h x a
  std::vector<std::vector<Expression>> a(6, std::vector<Expression>(6));
  std::vector<Expression> b(6);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      a[i][j] = inertia[i][j];
      a[3 + i][j] = coupling[j][i];
      a[i][3 + j] = coupling[i][j];
    }
    a[3 + i][3 + i] = body.mass;
    b[i] = -missing.angular[i];
    b[3 + i] = -missing.linear[i];
  }
  const std::vector<Expression> x = solve(a, b);
  const Spatial result{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  name(trace.graph, result.angular, "base_acceleration_w");
  name(trace.graph, result.linear, "base_acceleration_v");
  return result;
}

void add_composite_forces(
    const Setup& setup,
    const std::vector<MassProperties>& composite,
    const Spatial& base_acceleration,
    std::vector<Expression>& tau) {
  const std::function<void(int, const Spatial&)> descend = [&](int link, const Spatial& parent) {
    for (const JointView& joint : setup.children(link)) {
      const std::string& name = setup.link_name(joint.child);
      setup.trace.section(name, "link " + name + ": share of the base acceleration");
      const Spatial a = to_child(setup.pose(joint.index), parent);
      const Spatial unit = unit_wrench(composite[static_cast<std::size_t>(joint.child)], joint.revolute);
      tau[static_cast<std::size_t>(joint.index)] += dot(unit, a);
      descend(joint.child, a);
    }
  };
  descend(0, base_acceleration);
}

}  // namespace robcogen::algorithm
