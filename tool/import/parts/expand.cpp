#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/parts.h"
#include "import/parts/assembly.h"
#include "import/parts/coupling_loops.h"
#include "import/parts/placements.h"
#include "import/parts/rewrite.h"
#include "import/parts/scope.h"

namespace robcogen::import {
namespace {

using namespace parts;
using kinematics::Body;
using kinematics::Child;
using kinematics::Document;
using kinematics::Instance;
using kinematics::Joint;
using kinematics::Link;

constexpr std::size_t kMaxInstances = 4096;
constexpr std::size_t kMaxDepth = 64;

class Expander {
 public:
  Expander(const DocumentPtr& document, const Resolver& resolve, Diagnostics& diagnostics)
      : document_(document),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()),
        scopes_(document, resolve, diagnostics),
        source_(std::make_shared<Source>(document->source)) {}

  // Not where an import or a part in reach is wrong: more errors would follow from it.
  std::optional<Document> expand() {
    if (diagnostics_.error_count() > errors_before_) return std::nullopt;
    Assembly robot = assemble({document_, nullptr, document_->robot}, {}, 0);
    Document result = *document_;
    static_cast<Body&>(result) = std::move(robot.body);
    if (robot.base) {
      robot.base->children = std::move(robot.roots);
      result.links.insert(result.links.begin(), std::move(*robot.base));
    }
    result.limbs = std::move(robot.limbs);
    result.imports.clear();
    result.parts.clear();
    if (instances_ > 0) result.source = source_;
    if (diagnostics_.error_count() > errors_before_) return std::nullopt;
    return result;
  }

 private:
  DocumentPtr document_;
  Diagnostics& diagnostics_;
  std::size_t errors_before_;
  Scopes scopes_;
  std::shared_ptr<Source> source_;
  std::size_t instances_ = 0;
  std::vector<Entry> open_;  // parts being put in, each attached in the one before

  Place place(const Span& span) const { return {source_, span}; }

  // With all that is attached in it; its text begins at this offset.
  Assembly assemble(const Entry& entry, const Meanings& meanings, std::size_t offset) {
    open_.push_back(entry);
    Assembly assembly;
    assembly.body = rewritten(entry.body(), offset, meanings, source_, diagnostics_);
    if (entry.part != nullptr) {
      for (Child root : entry.part->roots) {
        for (kinematics::Name* name : {&root.link, &root.joint})
          name->span = {name->span.begin + offset, name->span.end + offset};
        assembly.roots.push_back(std::move(root));
      }
    } else if (!assembly.body.links.empty() && assembly.body.links.front().is_base) {
      assembly.base = std::move(assembly.body.links.front());
      assembly.body.links.erase(assembly.body.links.begin());
      assembly.roots = std::exchange(assembly.base->children, {});
    }
    // Instances stand after all elements of the part itself.
    Assembly attached;
    std::vector<std::string> instances;
    for (const auto& [link, children] : in_order_of_text(assembly))
      for (const Instance& instance : std::exchange(link->instances, {})) {
        attach(entry.document, instance, *link, *children, attached);
        instances.push_back(instance.name.text);
      }
    const std::size_t own = assembly.body.couplings.size();
    append(assembly.body, std::move(attached.body));
    assembly.limbs = std::move(attached.limbs);
    unroll_couplings(assembly, own, instances, source_, diagnostics_);
    if (entry.document == document_ && entry.part == nullptr) number(assembly);
    open_.pop_back();
    return assembly;
  }

  static void append(Body& body, Body added) {
    std::move(added.links.begin(), added.links.end(), std::back_inserter(body.links));
    std::move(added.joints.begin(), added.joints.end(), std::back_inserter(body.joints));
    std::move(added.couplings.begin(), added.couplings.end(), std::back_inserter(body.couplings));
    std::move(added.loop_joints.begin(), added.loop_joints.end(), std::back_inserter(body.loop_joints));
    std::move(added.actuators.begin(), added.actuators.end(), std::back_inserter(body.actuators));
    std::move(added.independents.begin(), added.independents.end(), std::back_inserter(body.independents));
  }

  // The links, and where their children are listed.
  static std::vector<std::pair<Link*, std::vector<Child>*>> in_order_of_text(Assembly& assembly) {
    std::vector<std::pair<Link*, std::vector<Child>*>> links;
    if (assembly.base) links.emplace_back(&*assembly.base, &assembly.roots);
    for (Link& link : assembly.body.links) links.emplace_back(&link, &link.children);
    std::stable_sort(links.begin(), links.end(), [](const auto& a, const auto& b) {
      return a.first->span.begin < b.first->span.begin;
    });
    return links;
  }

  void attach(
      const DocumentPtr& document,
      const Instance& instance,
      Link& link,
      std::vector<Child>& children,
      Assembly& attached) {
    const Entry* entry = scopes_.find(document, instance.part.text);
    if (entry == nullptr) {
      diagnostics_
          .error(
              "unknown-part", place(instance.part.span), fmt::format("part '{}' is not declared", instance.part.text))
          .hint = did_you_mean(instance.part.text, scopes_.names(document));
      return;
    }
    if (!may_attach(*entry, instance)) return;
    const std::size_t offset = source_->use(
        entry->document->source, instance.name.span,
        fmt::format("'{}' is attached as '{}' here", instance.part.text, instance.name.text));
    Assembly part = assemble(*entry, meanings(*entry, instance, offset), offset);
    for (Link& own : part.body.links) own.id.reset();
    if (instance.mirror) reflect(part, *instance.mirror, source_, diagnostics_);
    attached.limbs.push_back(limb_of(part, instance));
    name_after(part, instance.name.text);
    attached.limbs.insert(attached.limbs.end(), part.limbs.begin(), part.limbs.end());
    join(std::move(part), instance, link, children, attached.body);
  }

  bool may_attach(const Entry& entry, const Instance& instance) {
    const auto is_entry = [&](const Entry& open) { return open.is(entry); };
    if (std::any_of(open_.begin(), open_.end(), is_entry)) {
      diagnostics_.error(
          "part-in-itself", place(instance.part.span), fmt::format("part '{}' contains itself", instance.part.text));
      return false;
    }
    if (++instances_ <= kMaxInstances && open_.size() < kMaxDepth) return true;
    if (instances_ > kMaxInstances + 1) return false;  // reported
    instances_ = kMaxInstances + 1;
    diagnostics_.error(
        "too-many-parts", place(instance.part.span),
        open_.size() < kMaxDepth ? fmt::format("the robot has more than {} parts", kMaxInstances)
                                 : fmt::format("parts are nested more than {} deep", kMaxDepth));
    return false;
  }

  // The meanings of names in the part.
  Meanings meanings(const Entry& entry, const Instance& instance, std::size_t offset) {
    Meanings result;
    for (const Joint& joint : entry.body().joints)
      for (std::string& name : coordinate_names(joint)) result.joints.insert(std::move(name));
    std::set<std::string> known;
    if (entry.part != nullptr) {
      result.part = entry.part->name.text;
      for (const kinematics::PartParameter& parameter : entry.part->parameters) {
        known.insert(parameter.name.text);
        if (parameter.default_value) result.values.insert({parameter.name.text, parameter.default_value});
      }
    } else {
      known = parameters_of(entry.body());
    }
    std::map<std::string, Span> given;
    for (const kinematics::Argument& argument : instance.arguments) read(argument, instance, known, given, result);
    if (entry.part == nullptr) return result;
    for (const kinematics::PartParameter& parameter : entry.part->parameters) {
      if (result.values.contains(parameter.name.text)) continue;
      const Span span = {parameter.name.span.begin + offset, parameter.name.span.end + offset};
      diagnostics_
          .error(
              "missing-argument", place(instance.name.span),
              fmt::format("'{}' has no argument for parameter '{}'", instance.name.text, parameter.name.text))
          .notes.push_back({place(span), fmt::format("part '{}' declares it here", instance.part.text)});
      result.values.insert({parameter.name.text, term(Number::rational(1), instance.name.span)});
    }
    return result;
  }

  void read(
      const kinematics::Argument& argument,
      const Instance& instance,
      const std::set<std::string>& known,
      std::map<std::string, Span>& given,
      Meanings& result) {
    const std::string& name = argument.name.text;
    const auto [earlier, is_new] = given.insert({name, argument.name.span});
    if (!is_new) {
      diagnostics_
          .error("duplicate-argument", place(argument.name.span), fmt::format("argument '{}' is given twice", name))
          .notes.push_back({place(earlier->second), "first given here"});
    } else if (!known.contains(name)) {
      diagnostics_
          .error(
              "unknown-argument", place(argument.name.span),
              fmt::format("part '{}' has no parameter '{}'", instance.part.text, name))
          .hint = did_you_mean(name, {known.begin(), known.end()});
    } else {
      result.values.insert_or_assign(name, argument.value);
    }
  }

  // The part has its final names.
  void join(Assembly part, const Instance& instance, Link& link, std::vector<Child>& children, Body& attached) {
    const Placement at = instance.placement.value_or(identity(instance.name.span));
    const bool keeps_base = instance.keep && part.base;
    if (instance.keep && !part.base)
      diagnostics_.error(
          "no-base-to-keep", place(*instance.keep),
          fmt::format("part '{}' has no base: only a robot has one", instance.part.text));
    if (keeps_base) {
      keep_base(part, at, children);
    } else {
      for (const Child& root : part.roots) carry(part.body, root, at, instance);
      children.insert(children.end(), part.roots.begin(), part.roots.end());
      if (part.base) lump(*part.base, at, instance, link, part.body);
    }
    append(attached, std::move(part.body));
  }

  // A link on a joint that is held still.
  static void keep_base(Assembly& part, const Placement& at, std::vector<Child>& children) {
    Link base = std::move(*part.base);
    base.is_base = base.floating = false;
    base.children = std::move(part.roots);
    Joint mount;
    mount.name = {base.name.text + "_mount", base.name.span};
    mount.placement = at;
    children.push_back({base.name, mount.name});
    part.body.couplings.push_back({mount.name, term(Number(), base.name.span)});
    part.body.links.insert(part.body.links.begin(), std::move(base));
    part.body.joints.insert(part.body.joints.begin(), std::move(mount));
  }

  // Joints on the base of a part are on the link. A rotor's axis is in the axes of the link too.
  void carry(Body& body, const Child& root, const Placement& at, const Instance& instance) {
    for (Joint& joint : body.joints) {
      if (joint.name.text != root.joint.text) continue;
      place_at(joint.placement, at, instance, fmt::format("joint '{}'", joint.name.text));
      const auto words = kinematics::coordinate_words(joint.type);
      std::optional<kinematics::Rotor>* rotor = &joint.rotor;  // that the link carries
      for (kinematics::Coordinate& coordinate : joint.coordinates)
        if (coordinate.word.text == words.front()) rotor = &coordinate.rotor;
      if (*rotor && (*rotor)->axis && !(*rotor)->carrier)
        (*rotor)->axis = product(rotation_matrix(at.rotation), *(*rotor)->axis);
    }
  }

  void place_at(Placement& placement, const Placement& at, const Instance& instance, const std::string& what) {
    if (const std::optional<Placement> joined = composed(at, placement)) {
      placement = *joined;
      return;
    }
    diagnostics_
        .error(
            "rotation-with-parameter", place(at.span),
            fmt::format(
                "the rotations of '{}' and of {} depend on parameters: they cannot be written as one",
                instance.name.text, what))
        .hint = "give one of the two no rotation, or constants";
  }

  // Frames of the base, and its own frame as one of them, are frames of the link.
  void lump(Link& base, const Placement& at, const Instance& instance, Link& link, Body& body) {
    link.inertia = lumped(link, base, at);
    link.frames.push_back({{"fr_" + base.name.text, base.name.span}, at});
    for (kinematics::Frame& frame : base.frames) {
      place_at(frame.placement, at, instance, fmt::format("frame '{}'", frame.name.text));
      link.frames.push_back(std::move(frame));
    }
    for (Joint& joint : body.joints) {
      for (kinematics::Rotor* rotor : rotors_of(joint)) {
        if (!rotor->carrier || rotor->carrier->text != base.name.text) continue;
        rotor->carrier->text = link.name.text;
        if (rotor->axis) rotor->axis = product(rotation_matrix(at.rotation), *rotor->axis);
      }
    }
  }

  // Links without an id get the next ones, parents first.
  static void number(Assembly& robot) {
    std::map<std::string, Link*> links;
    int last = 0;
    for (Link& link : robot.body.links) {
      links.insert({link.name.text, &link});
      last = std::max(last, link.id.value_or(0));
    }
    std::vector<std::string> pending;
    const auto push = [&](const std::vector<Child>& children) {
      for (auto child = children.rbegin(); child != children.rend(); ++child) pending.push_back(child->link.text);
    };
    push(robot.roots);
    while (!pending.empty()) {
      const auto found = links.find(pending.back());
      pending.pop_back();
      if (found == links.end()) continue;
      Link& link = *found->second;
      links.erase(found);
      if (!link.id) link.id = ++last;
      push(link.children);
    }
  }
};

bool has_parts(const kinematics::Document& document) {
  const auto has_instances = [](const Link& link) { return !link.instances.empty(); };
  return !document.imports.empty() || !document.parts.empty() || names_instances(document) ||
         std::any_of(document.links.begin(), document.links.end(), has_instances);
}

}  // namespace

std::optional<kinematics::Document> expand(
    const DocumentPtr& document,
    const Resolver& resolve,
    Diagnostics& diagnostics) {
  if (!has_parts(*document)) return *document;
  return Expander(document, resolve, diagnostics).expand();
}

}  // namespace robcogen::import
