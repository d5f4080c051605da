#include "server/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include "import/parameters.h"
#include "language/kinematics/expressions.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;
using language::Expression;
using language::ExpressionPtr;

class ValueCollector {
 public:
  explicit ValueCollector(const Parsed& document) : reader_(document.source, ignored_) {}

  std::vector<Value> list;

  void declare(const ExpressionPtr& e) {
    if (e) reader_.declare_names_in(*e);
  }
  void add(const ExpressionPtr& e, bool is_angle) {
    if (!e || e->span.end <= e->span.begin) return;
    if (is_angle) angles_.insert(e->span.begin);
    const model::Quantity q = reader_.read(*e, is_angle ? model::ParameterKind::angle : model::ParameterKind::length);
    if (!q.is_constant()) return;
    list.push_back({e->span, is_angle, e->kind == Expression::Kind::number, q.number()});
  }

  void angles(const kinematics::Placement& placement) {
    for (const ExpressionPtr& e : placement.rotation) add(e, true);
  }
  void body(const kinematics::Body& body) {
    for (const kinematics::Link& link : body.links) {
      for (const kinematics::Frame& frame : link.frames) angles(frame.placement);
      for (const kinematics::Instance& instance : link.instances)
        if (instance.placement) angles(*instance.placement);
    }
    for (const kinematics::Joint& joint : body.joints) {
      angles(joint.placement);
      if (joint.type == kinematics::Joint::Type::revolute && joint.limits.position)
        for (const ExpressionPtr& e : *joint.limits.position) add(e, true);
    }
    kinematics::visit_body(body, [&](const ExpressionPtr& e) {
      if (e && !angles_.contains(e->span.begin)) add(e, false);
    });
  }
  void steps(const std::vector<language::AxisStep>& steps) {
    for (const language::AxisStep& step : steps) add(step.amount, step.rotation);
  }

 private:
  Diagnostics ignored_;
  import::QuantityReader reader_;
  std::set<std::size_t> angles_;  // where expressions of angles begin
};

}  // namespace

std::vector<Value> values_in(const Parsed& document) {
  ValueCollector collector(document);
  if (const kinematics::Document* robot = document.robot()) {
    for (const kinematics::Part& part : robot->parts)
      kinematics::visit_body(part, [&](const ExpressionPtr& e) { collector.declare(e); });
    kinematics::visit_body(*robot, [&](const ExpressionPtr& e) { collector.declare(e); });
    for (const kinematics::Part& part : robot->parts) collector.body(part);
    collector.body(*robot);
  } else if (const auto* motions = document.motions()) {
    for (const auto& motion : motions->motions)
      for (const language::AxisStep& step : motion.steps) collector.declare(step.amount);
    for (const auto& motion : motions->motions) collector.steps(motion.steps);
  } else if (const auto* transforms = document.transforms()) {
    for (const auto& transform : transforms->transforms)
      for (const language::AxisStep& step : transform.primitives) collector.declare(step.amount);
    for (const auto& transform : transforms->transforms) collector.steps(transform.primitives);
  }
  std::sort(collector.list.begin(), collector.list.end(), [](const Value& a, const Value& b) {
    return a.span.begin < b.span.begin;
  });
  return std::move(collector.list);
}

std::string degrees_of(const Number& angle) {
  if (angle.is_zero()) return "0";
  const double degrees = angle.is_pi_multiple()
                             ? static_cast<double>(angle.ratio()->num) * 180.0 / static_cast<double>(angle.ratio()->den)
                             : angle.value() * 180.0 / std::numbers::pi;
  return fmt::format("{:.6g}", degrees);
}

std::string describe(const Value& value, const Parsed& document) {
  const std::string_view text = document.source->text().substr(value.span.begin, value.span.end - value.span.begin);
  if (value.is_angle)
    return fmt::format("`{}` is {}°, {} rad", text, degrees_of(value.number), print_double(value.number.value()));
  if (value.is_literal) return "";
  return fmt::format("`{}` is {}", text, print_double(value.number.value()));
}

}  // namespace robcogen::server
