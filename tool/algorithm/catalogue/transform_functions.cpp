#include "algorithm/catalogue/transform_functions.h"

#include "algorithm/kinematics/merged_primitives.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/kinematics/transform_kinds.h"

namespace robcogen::algorithm {
namespace {

using model::CoordinateTransform;
using model::CoordinateTransforms;
using model::PrimitiveTransform;
using model::Quantity;
using symbolic::Program;
using symbolic::Role;

// Calls seen(leaf) for every parameter and variable of a quantity.
template <class RelativeMotion>
void for_each_name(const Quantity& q, const RelativeMotion& seen) {
  switch (q.op()) {
    case Quantity::Op::constant:
      return;
    case Quantity::Op::parameter:
    case Quantity::Op::variable:
      return seen(q);
    case Quantity::Op::add:
    case Quantity::Op::subtract:
    case Quantity::Op::multiply:
    case Quantity::Op::divide:
      for_each_name(q.left(), seen);
      return for_each_name(q.right(), seen);
    default:
      return for_each_name(q.left(), seen);
  }
}

// The primitives in the convention of poses: moved frame on the right.
std::vector<PrimitiveTransform> rightwards(const CoordinateTransforms& document, const CoordinateTransform& transform) {
  std::vector<PrimitiveTransform> primitives = transform.primitives;
  if (document.position == model::MovedFramePosition::left)
    for (PrimitiveTransform& p : primitives) p.amount = -p.amount;
  return primitives;
}

// `Rx(a - b)`
std::string text(const CoordinateTransforms& document, const PrimitiveTransform& primitive) {
  return std::string(primitive.rotation ? "R" : "T") + "xyz"[static_cast<int>(primitive.axis)] + "(" +
         model::print(primitive.amount, document.parameters, document.variables) + ")";
}

// The first variable or parameter of an amount, after which the values behind it are named.
std::string subject_of(const CoordinateTransforms& document, const Quantity& amount) {
  std::string subject;
  for_each_name(amount, [&](const Quantity& q) {
    const auto index = static_cast<std::size_t>(q.index());
    if (subject.empty())
      subject = q.op() == Quantity::Op::variable ? document.variables[index] : document.parameters[index].name;
  });
  return subject;
}

// The path past each primitive that is not constant.
Path path_of(const CoordinateTransforms& document, const CoordinateTransform& transform) {
  Path path(1);
  for (const PrimitiveTransform& primitive : merged(rightwards(document, transform))) {
    path.back().primitives.push_back(primitive);
    path.back().subject = subject_of(document, primitive.amount);
    if (path.back().subject.empty()) continue;
    path.back().passed = text(document, primitive);
    path.emplace_back();
  }
  return path;
}

}  // namespace

std::string name_of(const CoordinateTransform& transform) {
  return transform.name.empty() ? transform.left + "_X_" + transform.right : transform.name;
}

Arguments arguments_of(const CoordinateTransforms& document, const CoordinateTransform& transform) {
  std::vector<bool> used(document.variables.size(), false);
  Arguments arguments;
  for (const PrimitiveTransform& primitive : transform.primitives)
    for_each_name(primitive.amount, [&](const Quantity& q) {
      if (q.op() == Quantity::Op::variable)
        used[static_cast<std::size_t>(q.index())] = true;
      else
        arguments.parameters = true;
    });
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) arguments.variables.push_back(static_cast<int>(i));
  return arguments;
}

Arguments all_arguments(const CoordinateTransforms& document) {
  Arguments arguments;
  arguments.parameters = !document.parameters.empty();
  for (std::size_t i = 0; i < document.variables.size(); ++i) arguments.variables.push_back(static_cast<int>(i));
  return arguments;
}

namespace {

// Declares the inputs that the transform depends on: parameters, variables. Returns a value for each variable of the
// document; those that it does not depend on have none.
std::vector<Expression> declare(ProgramTrace& trace, const CoordinateTransforms& document, const Arguments& arguments) {
  if (arguments.parameters) trace.parameter_input(document.parameters);
  std::vector<Expression> variables(document.variables.size());
  if (arguments.variables.empty()) return variables;
  std::vector<std::string> labels;
  for (int i : arguments.variables) labels.push_back(document.variables[static_cast<std::size_t>(i)]);
  const std::vector<Expression> inputs = trace.input("variables", Role::variables, labels);
  for (std::size_t k = 0; k < inputs.size(); ++k)
    variables[static_cast<std::size_t>(arguments.variables[k])] = inputs[k];
  return variables;
}

}  // namespace

Program transform_program(
    const CoordinateTransforms& document,
    const CoordinateTransform& transform,
    TransformForm form,
    const std::string& name) {
  const Arguments arguments = arguments_of(document, transform);
  const Path path = path_of(document, transform);
  return cheapest_transform(form, behind_last_turn(path), [&](int moment_from) {
    ProgramTrace trace;
    const std::vector<Expression> variables = declare(trace, document, arguments);
    output_transform(trace, path, variables, form, moment_from);
    return trace.program(name);
  });
}

PrimitiveProduct primitive_product(
    const CoordinateTransforms& document,
    const CoordinateTransform& transform,
    model::MovedFramePosition position,
    const Arguments& arguments) {
  PrimitiveProduct product{transform.primitives, {}};
  ProgramTrace trace;
  const std::vector<Expression> variables = declare(trace, document, arguments);
  std::vector<Expression> amounts;
  for (PrimitiveTransform& p : product.primitives) {
    if (document.position != position) p.amount = -p.amount;
    amounts.push_back(trace.lift(p.amount, variables));
  }
  trace.output("amounts", Role::value, amounts);
  product.amounts = trace.program("amounts_" + name_of(transform));
  return product;
}

std::vector<symbolic::Function> transform_functions(const CoordinateTransforms& document) {
  std::vector<symbolic::Function> list;
  for (const TransformKind& kind : transform_kinds())
    for (const CoordinateTransform& transform : document.transforms) {
      symbolic::Function f;
      f.group = "transforms";
      f.scope = "transforms::" + kind.scope;
      f.name = name_of(transform);
      f.kernel = kind.scope + "_" + f.name;
      f.summary = {kind.summary(transform.left, transform.right)};
      f.left = transform.left;
      f.right = transform.right;
      f.program = transform_program(document, transform, kind.form, f.kernel);
      list.push_back(std::move(f));
    }
  return list;
}

}  // namespace robcogen::algorithm
