#include "export/frames.h"

#include <algorithm>
#include <map>

#include "export/expression.h"

namespace robcogen::exporting {

using language::AxisStep;
using language::Expression;
using language::ExpressionPtr;
using language::FramesHeader;
using language::Name;
using model::Parameter;
using model::ParameterKind;

namespace {

Name named(const std::string& text) {
  return {text, {}};
}

// The groups of a document, and the group of each parameter.
struct Groups {
  std::vector<language::ParameterGroup> declared;
  std::map<std::string, std::string> of_parameter;
};

Groups groups_of(const std::vector<Parameter>& parameters) {
  Groups groups;
  for (const auto& [kind, name] : {std::pair(ParameterKind::length, "lengths"), {ParameterKind::angle, "angles"}}) {
    language::ParameterGroup group;
    group.name = named(name);
    for (const Parameter& parameter : parameters) {
      if (parameter.kind != kind) continue;
      group.parameters.push_back(named(parameter.name));
      groups.of_parameter[parameter.name] = name;
    }
    if (!group.parameters.empty()) groups.declared.push_back(std::move(group));
  }
  return groups;
}

// Spells amounts in a document with these groups and keywords.
class AmountWriter {
 public:
  AmountWriter(
      const std::vector<Parameter>& parameters,
      const std::vector<std::string>& variables,
      const std::vector<std::string>& keywords)
      : parameters_(parameters), variables_(variables), keywords_(keywords), groups_(groups_of(parameters)) {}

  ExpressionPtr write(const model::Quantity& amount) const {
    return localised(*expression(amount, parameters_, variables_));
  }

  const std::vector<language::ParameterGroup>& groups() const { return groups_.declared; }

 private:
  ExpressionPtr localised(const Expression& from) const {
    Expression e = from;
    if (e.kind == Expression::Kind::name) {
      const auto group = groups_.of_parameter.find(e.name);
      if (group != groups_.of_parameter.end()) e.group = group->second;
      e.escaped = e.escaped || std::find(keywords_.begin(), keywords_.end(), e.name) != keywords_.end();
    }
    if (e.left) e.left = localised(*e.left);
    if (e.right) e.right = localised(*e.right);
    return std::make_shared<const Expression>(std::move(e));
  }

  const std::vector<Parameter>& parameters_;
  const std::vector<std::string>& variables_;
  const std::vector<std::string>& keywords_;
  Groups groups_;
};

FramesHeader header(
    const std::string& model,
    const std::vector<std::string>& frames,
    const std::vector<language::ParameterGroup>& groups) {
  FramesHeader header;
  header.model = named(model);
  header.groups = groups;
  if (frames.empty()) return header;
  header.frames.emplace();
  for (const std::string& frame : frames) header.frames->push_back(named(frame));
  return header;
}

template <class Primitive>
std::vector<AxisStep> steps(const std::vector<Primitive>& primitives, const AmountWriter& amounts) {
  std::vector<AxisStep> result;
  for (const Primitive& primitive : primitives)
    result.push_back({primitive.rotation, static_cast<int>(primitive.axis), amounts.write(primitive.amount), {}});
  return result;
}

std::optional<Name> user_name(const std::string& name) {
  return name.empty() ? std::nullopt : std::optional(named(name));
}

}  // namespace

language::motion::Document motion_document(const model::RigidMotions& motions) {
  using namespace language::motion;
  const AmountWriter amounts(motions.parameters, motions.variables, keywords());
  Document document;
  document.header = header(motions.name, motions.frames, amounts.groups());
  document.convention = motions.convention == model::MotionConvention::local ? Convention::local : Convention::fixed;
  for (const model::Motion& motion : motions.motions) {
    document.motions.push_back(
        {named(motion.from), named(motion.to), steps(motion.steps, amounts), user_name(motion.name), {}, {}});
  }
  return document;
}

language::transforms::Document transforms_document(const model::CoordinateTransforms& transforms) {
  using namespace language::transforms;
  const AmountWriter amounts(transforms.parameters, transforms.variables, keywords());
  std::vector<std::string> frames;
  for (const model::CoordinateTransform& transform : transforms.transforms) {
    for (const std::string& frame : {transform.left, transform.right})
      if (std::find(frames.begin(), frames.end(), frame) == frames.end()) frames.push_back(frame);
  }
  Document document;
  document.header = header(transforms.name, frames, amounts.groups());
  document.position =
      transforms.position == model::MovedFramePosition::left ? MovedFramePosition::left : MovedFramePosition::right;
  for (const model::CoordinateTransform& transform : transforms.transforms) {
    document.transforms.push_back(
        {named(transform.left),
         named(transform.right),
         steps(transform.primitives, amounts),
         user_name(transform.name),
         {},
         {}});
  }
  return document;
}

}  // namespace robcogen::exporting
