#include "driver/fused_functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "algorithm/catalogue/find.h"
#include "algorithm/catalogue/fused.h"
#include "backend/cpp/names.h"
#include "driver/derivatives.h"
#include "driver/failure.h"
#include "import/kinematics.h"
#include "language/desired/parse_function.h"

namespace robcogen::driver {
namespace {

using algorithm::Declaration;
using algorithm::Declared;
using model::FusedFunction;

// In code for GPUs, `kernel_f`, `batch_f` and `in_lanes_f` are made for each function f.
bool begins_like_kernel(const std::string& name) {
  return name.starts_with("kernel_") || name.starts_with("batch_") || name.starts_with("in_lanes_");
}

class FunctionChecker {
 public:
  FunctionChecker(const model::KinematicTree& tree, const model::DesiredTransforms& desired, Diagnostics& diagnostics)
      : tree_(tree), desired_(desired), diagnostics_(diagnostics) {}

  void check(const FusedFunction& function) {
    check_name(function);
    std::set<std::string> given;
    std::vector<std::vector<Declared>> parts;
    for (const FusedFunction::Part& part : function.parts) {
      if (!given.insert(part.function).second) {
        diagnostics_.error("duplicate-part", part.place, fmt::format("'{}' is given twice", part.function));
        continue;
      }
      if (std::optional<std::vector<Declared>> overloads = find(function, part)) parts.push_back(std::move(*overloads));
    }
    if (function.parts.size() == 1)
      diagnostics_
          .error("single-part", function.place, fmt::format("'{}' has the results of one function only", function.name))
          .hint = "add others: name = function + function";
    check_arguments(function, parts);
  }

 private:
  const model::KinematicTree& tree_;
  const model::DesiredTransforms& desired_;
  Diagnostics& diagnostics_;
  std::map<std::string, Place> defined_;
  std::vector<Declared> functions_;  // of the robot, once they are needed

  const std::vector<Declared>& functions() {
    if (functions_.empty())
      for (const std::string& group : algorithm::groups())
        if (group != algorithm::kFusedGroup)
          for (Declared& f : algorithm::declared(tree_, desired_, group)) functions_.push_back(std::move(f));
    return functions_;
  }

  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const Declared& f : functions()) names.push_back(algorithm::dotted(f.is->scope, f.name));
    return names;
  }

  void check_name(const FusedFunction& function) {
    const auto [first, is_new] = defined_.insert({function.name, function.place});
    if (!is_new)
      diagnostics_
          .error("duplicate-function", function.place, fmt::format("function '{}' is defined twice", function.name))
          .notes.push_back({first->second, "first defined here"});
    const std::string taken = name_like(function.name);
    if (!taken.empty())
      diagnostics_.error("name-taken", function.place, fmt::format("robot '{}' has '{}' already", tree_.name, taken))
          .hint = "give the fused function another name";
    else if (
        backend::cpp::identifier(function.name) != function.name || backend::cpp::is_taken(function.name) ||
        begins_like_kernel(function.name))
      diagnostics_
          .error("name-taken", function.place, fmt::format("'{}' is a name of the generated code", function.name))
          .hint = "give the fused function another name";
  }

  // A function of the robot that has this name, or is in a scope of this name; empty if there is none.
  std::string name_like(const std::string& name) {
    const std::string structure = backend::cpp::name_of_structure(name), scope = name + ".";
    for (const Declared& f : functions()) {
      const std::string own = algorithm::dotted(f.is->scope, f.name);
      if (f.kernel == name || backend::cpp::name_of_structure(own) == structure || own.starts_with(scope)) return own;
    }
    return "";
  }

  // The overloads of a part; nullopt after an error.
  std::optional<std::vector<Declared>> find(const FusedFunction& function, const FusedFunction::Part& part) {
    std::vector<Declared> overloads = algorithm::find_function(tree_, desired_, part.function);
    if (overloads.empty()) {
      report_missing(function, part);
      return std::nullopt;
    }
    if (overloads.front().is->scope != std::string("inertia_factor")) return overloads;
    diagnostics_
        .error(
            "factor-part", part.place,
            fmt::format("'{}' is a function of an inertia factor, which is an object", part.function))
        .hint = "call it with the result of joint_space_inertia_factor";
    return std::nullopt;
  }

  void report_missing(const FusedFunction& function, const FusedFunction::Part& part) {
    const std::vector<Declaration>& all = algorithm::declarations();
    const auto row = std::find_if(all.begin(), all.end(), [&](const Declaration& d) {
      return algorithm::dotted(d.scope, d.name) == part.function;
    });
    const auto is_fused = [&](const FusedFunction& other) { return other.name == part.function; };
    std::string reason, hint;
    if (std::any_of(desired_.functions.begin(), desired_.functions.end(), is_fused)) {
      reason = "it is a fused function itself";
      hint = "write its parts";
    } else if (row != all.end()) {
      reason = algorithm::reason_of_absence(tree_, row->group, algorithm::Reasons::all);
      if (reason.empty() && row->of == algorithm::Of::contacts && desired_.contacts.empty())
        reason = "no contact frames are named";
    }
    if (reason.empty()) {
      diagnostics_
          .error(
              "unknown-function", part.place, fmt::format("robot '{}' has no function '{}'", tree_.name, part.function))
          .hint = did_you_mean(part.function, names());
      return;
    }
    diagnostics_
        .error(
            "unavailable-part", part.place,
            fmt::format("'{}' cannot be a part of '{}': {}", part.function, function.name, reason))
        .hint = hint;
  }

  // Arguments of one name must be the same.
  void check_arguments(const FusedFunction& function, const std::vector<std::vector<Declared>>& parts) {
    struct Argument {
      std::string part;
      symbolic::Role role;
      std::size_t size;
    };
    std::map<std::string, Argument> known;
    for (const std::vector<Declared>& overloads : parts) {
      const std::string part = algorithm::dotted(overloads.back().is->scope, overloads.back().name);
      for (const symbolic::InputArray& input : algorithm::outline(overloads.back()).inputs) {
        const Argument own = {part, input.role, input.elements.size()};
        const auto [earlier, is_new] = known.insert({input.name, own});
        if (earlier->second.role == own.role && earlier->second.size == own.size) continue;
        diagnostics_.error(
            "different-arguments", function.place,
            fmt::format(
                "'{}' and '{}' cannot be fused: their arguments '{}' differ", earlier->second.part, part, input.name));
      }
    }
  }
};

}  // namespace

std::vector<FusedFunction> functions_of_option(
    const std::string& option,
    const std::vector<std::string>& texts,
    Diagnostics& diagnostics) {
  std::vector<FusedFunction> result;
  for (const std::string& text : texts) {
    const auto source = std::make_shared<const Source>(option, text);
    const std::vector<language::desired::Function> functions = language::desired::parse_functions(source, diagnostics);
    for (FusedFunction& f : import::fused_functions(functions, source)) result.push_back(std::move(f));
  }
  return result;
}

void check_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    Diagnostics& diagnostics) {
  FunctionChecker checker(tree, desired, diagnostics);
  for (const FusedFunction& function : desired.functions) checker.check(function);
}

model::DesiredTransforms checked_desired_transforms(
    const language::desired::Document& document,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics) {
  model::DesiredTransforms desired = import::desired_transforms(document, tree, diagnostics);
  check_functions(tree, desired, diagnostics);
  return desired;
}

void require_compilable(const symbolic::Function& function) {
  if (function.program.statements.size() <= kMaxExpressions) return;
  throw Failure{
      wrong_usage,
      fmt::format(
          "robcogen: error: function '{}': code without loops would have more than {} operations, too many to compile "
          "[too-many-operations]\nhint: fuse fewer functions",
          function.name, kMaxExpressions)};
}

}  // namespace robcogen::driver
