#include "algorithm/identification/inertial_parameters.h"

#include <memory>

namespace robcogen::algorithm {

MassProperties mass_properties(const InertialNumbers& numbers, Moments moments) {
  const auto& [m, hx, hy, hz, xx, yy, zz, Ixy, Ixz, Iyz] = numbers;
  Vector3 diagonal{xx, yy, zz};
  if (moments == Moments::of_inertia) {
    const Expression sum = xx + yy, half = 0.5 * (sum + zz);
    diagonal = {half - xx, half - yy, half - zz};
  }
  return {
      m,
      {hx, hy, hz},
      {Vector3{diagonal[0], Ixy, Ixz}, Vector3{Ixy, diagonal[1], Iyz}, Vector3{Ixz, Iyz, diagonal[2]}}};
}

InertialNumbers inertial_numbers(const MassProperties& body, Moments moments) {
  const Matrix3& S = body.pseudo_inertia;
  const Matrix3 diagonal = moments == Moments::of_inertia ? inertia_tensor(body) : S;
  const Vector3& h = body.first_moment;
  return {body.mass, h[0], h[1], h[2], diagonal[0][0], diagonal[1][1], diagonal[2][2], S[0][1], S[0][2], S[1][2]};
}

int first_moving_link(const model::KinematicTree& tree) {
  return tree.floating_base ? 0 : 1;
}

int inertial_parameter_count(const model::KinematicTree& tree) {
  return kParametersOfLink * (tree.link_count() - first_moving_link(tree));
}

std::vector<symbolic::QuantityRef> inertial_parameter_quantities(const model::KinematicTree& tree) {
  std::vector<symbolic::QuantityRef> quantities;
  for (std::size_t i = at(first_moving_link(tree)); i < at(tree.link_count()); ++i) {
    const auto add = [&](const char* symbol, const char* element) {
      quantities.push_back(
          std::make_shared<const symbolic::Quantity>(symbolic::Quantity{tree.links[i].name, symbol, element}));
    };
    add("m", "");
    for (const char* axis : {"x", "y", "z"}) add("h", axis);
    for (const char* axes : {"xx", "yy", "zz", "xy", "xz", "yz"}) add("I", axes);
  }
  return quantities;
}

std::vector<std::string> inertial_parameter_names(const model::KinematicTree& tree) {
  std::vector<std::string> names;
  for (const symbolic::QuantityRef& parameter : inertial_parameter_quantities(tree)) names.push_back(text(*parameter));
  return names;
}

symbolic::Program inertial_parameters(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  std::vector<Expression> numbers;
  for (std::size_t i = at(first_moving_link(tree)); i < at(tree.link_count()); ++i) {
    const model::Link& link = tree.links[i];
    trace.section(link.name, "link ", ": inertial parameters");
    const model::RigidBodyInertia body = link.inertia ? model::in_link_frame(*link.inertia) : model::RigidBodyInertia();
    numbers.push_back(trace.lift(body.mass));
    for (const model::Quantity& moment : body.first_moment) numbers.push_back(trace.lift(moment));
    for (const model::Quantity* q : {&body.ixx, &body.iyy, &body.izz, &body.ixy, &body.ixz, &body.iyz})
      numbers.push_back(trace.lift(*q));
  }
  trace.output("pi", symbolic::Role::value, numbers);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
