#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/parts.h"
#include "import/parts/arguments.h"
#include "import/parts/assembly.h"
#include "import/parts/attachment.h"
#include "import/parts/coupling_loops.h"
#include "import/parts/rewrite.h"
#include "import/parts/scope.h"

namespace robcogen::import {
namespace {

using namespace parts;
using kinematics::Body;
using kinematics::Child;
using kinematics::Document;
using kinematics::Instance;
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

  // Stops early if an import or a part in scope is wrong, because more errors would follow from it.
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
  std::vector<Entry> open_;  // parts being expanded, each attached in the one before

  Place place(const Span& span) const { return {source_, span}; }

  // Assembles a part with everything that is attached within it. Its text begins at this offset.
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
    // Elements of instances follow all elements of the part itself.
    Assembly attached;
    std::vector<std::string> instances;
    for (const auto& [link, children] : in_order_of_text(assembly))
      for (const Instance& instance : std::exchange(link->instances, {})) {
        attach(entry.document, instance, *link, *children, attached);
        instances.push_back(instance.name.text);
      }
    const std::size_t own = assembly.body.couplings.size(), own_tendons = assembly.body.tendons.size();
    append(assembly.body, std::move(attached.body));
    assembly.limbs = std::move(attached.limbs);
    unroll_couplings(assembly, own, own_tendons, instances, source_, diagnostics_);
    if (entry.document == document_ && entry.part == nullptr) number_links(assembly);
    open_.pop_back();
    return assembly;
  }

  // The links, each with the list of its children.
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
    Assembly part = assemble(*entry, meanings_of(*entry, instance, offset, source_, diagnostics_), offset);
    for (Link& own : part.body.links) own.id.reset();
    if (instance.mirror) reflect(part, *instance.mirror, source_, diagnostics_);
    attached.limbs.push_back(limb_of(part, instance));
    name_after(part, instance.name.text);
    attached.limbs.insert(attached.limbs.end(), part.limbs.begin(), part.limbs.end());
    append(attached.body, join_to_link(std::move(part), instance, link, children, source_, diagnostics_));
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
