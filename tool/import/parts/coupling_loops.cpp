#include "import/parts/coupling_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace robcogen::import::parts {
namespace {

using kinematics::Coupling;
using kinematics::Loop;
using kinematics::Name;
using language::Expression;
using language::ExpressionPtr;

class CouplingUnroller {
 public:
  CouplingUnroller(
      Assembly& assembly,
      const std::vector<std::string>& instances,
      const std::shared_ptr<const Source>& source,
      Diagnostics& diagnostics)
      : body_(assembly.body), instances_(instances), source_(source), diagnostics_(diagnostics) {
    for (const kinematics::Link& link : body_.links) links_.insert(link.name.text);
    if (assembly.base) links_.insert(assembly.base->name.text);
    for (const kinematics::Joint& joint : body_.joints)
      for (std::string& name : coordinate_names(joint)) joints_.insert(std::move(name));
  }

  void run(std::size_t own, std::size_t own_tendons) {
    for (const Loop& loop : body_.loops) check(loop);
    const std::vector<Coupling> written = std::exchange(body_.couplings, {});
    for (std::size_t begin = 0, end = 0; begin < own; begin = end) {
      const int number = written[begin].loop;
      while (end < own && written[end].loop == number) ++end;
      if (number == Coupling::kNoLoop) {
        for (std::size_t i = begin; i < end; ++i) body_.couplings.push_back(instantiated(written[i], nullptr, nullptr));
        continue;
      }
      const Loop& loop = body_.loops[static_cast<std::size_t>(number)];
      for (const Name& instance : loop.instances)
        for (std::size_t i = begin; i < end; ++i) body_.couplings.push_back(instantiated(written[i], &loop, &instance));
    }
    body_.couplings.insert(body_.couplings.end(), written.begin() + static_cast<std::ptrdiff_t>(own), written.end());
    body_.loops.clear();
    for (std::size_t i = 0; i < own_tendons; ++i)
      body_.tendons[i].length = instantiated(body_.tendons[i].length, nullptr, nullptr);
  }

 private:
  kinematics::Body& body_;
  const std::vector<std::string>& instances_;
  const std::shared_ptr<const Source>& source_;
  Diagnostics& diagnostics_;
  std::set<std::string> links_, joints_;
  std::set<std::pair<std::string, std::string>> reported_;  // instances that do not exist, or lack a joint

  bool is_listed(const std::string& name) const {
    return std::find(instances_.begin(), instances_.end(), name) != instances_.end();
  }

  void check(const Loop& loop) {
    const std::string& variable = loop.variable.text;
    if (links_.contains(variable) || joints_.contains(variable) || is_listed(variable))
      diagnostics_
          .error(
              "loop-variable", {source_, loop.variable.span},
              fmt::format(
                  "there is already {} '{}'",
                  links_.contains(variable)    ? "a link"
                  : joints_.contains(variable) ? "a joint"
                                               : "an instance",
                  variable))
          .hint = "choose another name for the loop variable";
    std::map<std::string, Span> listed;
    for (const Name& instance : loop.instances) {
      const auto [earlier, is_new] = listed.insert({instance.text, instance.span});
      if (is_new)
        is_instance(instance);
      else
        diagnostics_
            .error(
                "repeated-instance", {source_, instance.span},
                fmt::format("instance '{}' is listed twice", instance.text))
            .notes.push_back({{source_, earlier->second}, "first listed here"});
    }
  }

  // The joints of an instance, by their names in the part.
  std::vector<std::string> joints_of(const std::string& instance) const {
    std::vector<std::string> names;
    const std::string prefix = instance + "_";
    for (const std::string& joint : joints_)
      if (joint.starts_with(prefix)) names.push_back(joint.substr(prefix.size()));
    return names;
  }

  // Whether this is an instance. Reports each name that is not one, once.
  bool is_instance(const Name& instance) {
    if (is_listed(instance.text) || !joints_of(instance.text).empty()) return true;
    if (reported_.insert({instance.text, ""}).second)
      diagnostics_
          .error(
              "unknown-instance", {source_, instance.span},
              fmt::format(
                  "'{0}' is not an instance of a part, and no name of a joint begins with '{0}_'", instance.text))
          .hint = did_you_mean(instance.text, instances_);
    return false;
  }

  // Returns the name of a joint of an instance. A joint that does not exist is reported and gets some name.
  std::string joint(const Name& instance, const std::string& own, const Span& span) {
    const std::string name = element_name(instance.text, own);
    if (!is_instance(instance) || joints_.contains(name) || !reported_.insert({instance.text, own}).second) return name;
    Diagnostic& error = diagnostics_.error(
        "unknown-joint-of-instance", {source_, span},
        fmt::format("instance '{}' has no joint '{}'", instance.text, own));
    if (instance.span.begin < span.begin)
      error.notes.push_back({{source_, instance.span}, fmt::format("'{}' is listed here", instance.text)});
    error.hint = did_you_mean(own, joints_of(instance.text));
    return name;
  }

  Coupling instantiated(Coupling coupling, const Loop* loop, const Name* instance) {
    if (!coupling.instance.empty())
      coupling.joint.text = joint(
          meant(coupling.instance, coupling.joint.span, loop, instance)
              .value_or(Name{coupling.instance, coupling.joint.span}),
          coupling.joint.text, coupling.joint.span);
    coupling.instance.clear();
    coupling.loop = Coupling::kNoLoop;
    coupling.value = instantiated(coupling.value, loop, instance);
    return coupling;
  }

  // Returns the instance to which a name before a point refers, if it refers to one.
  std::optional<Name> meant(const std::string& name, const Span& span, const Loop* loop, const Name* instance) const {
    if (loop != nullptr && name == loop->variable.text) return *instance;
    return is_listed(name) ? std::optional(Name{name, span}) : std::nullopt;
  }

  // The parser reads `leg.knee` as a parameter of a group.
  ExpressionPtr instantiated(const ExpressionPtr& e, const Loop* loop, const Name* instance) {
    if (e->kind == Expression::Kind::name && !e->group.empty()) {
      const std::optional<Name> named = meant(e->group, e->span, loop, instance);
      if (!named) return e;
      Expression result = *e;
      result.name = joint(*named, e->name, e->span);
      result.group.clear();
      return std::make_shared<const Expression>(std::move(result));
    }
    if (!e->left) return e;
    Expression result = *e;
    result.left = instantiated(e->left, loop, instance);
    if (e->right) result.right = instantiated(e->right, loop, instance);
    return std::make_shared<const Expression>(std::move(result));
  }
};

}  // namespace

bool names_instances(const kinematics::Body& body) {
  return std::any_of(body.couplings.begin(), body.couplings.end(), [](const Coupling& coupling) {
    return coupling.loop != Coupling::kNoLoop || !coupling.instance.empty();
  });
}

void unroll_couplings(
    Assembly& assembly,
    std::size_t own,
    std::size_t own_tendons,
    const std::vector<std::string>& instances,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  if (instances.empty() && !names_instances(assembly.body)) return;
  CouplingUnroller(assembly, instances, source, diagnostics).run(own, own_tendons);
}

}  // namespace robcogen::import::parts
