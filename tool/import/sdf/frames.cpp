#include "import/sdf/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "support/index.h"

namespace robcogen::import::from_sdf {
namespace {

constexpr const char* kDelimiter = "::";

// Finds the scope and the last name of `inner::inner::name`, as seen from a scope. Names of SDF 1.7 and earlier may
// themselves contain the delimiter.
template <class Lookup>
std::optional<int> find_named(const Document& document, int scope, const std::string& name, const Lookup& lookup) {
  if (const std::optional<int> found = lookup(document.scopes[at(scope)], name)) return found;
  const auto& nested = document.scopes[at(document.scopes[at(scope)].names)].scopes;
  for (std::size_t at = name.find(kDelimiter); at != std::string::npos; at = name.find(kDelimiter, at + 2))
    if (const auto inner = nested.find(name.substr(0, at)); inner != nested.end())
      return find_named(document, inner->second, name.substr(at + 2), lookup);
  return std::nullopt;
}

std::optional<int> index_of(const std::map<std::string, int>& names, const std::string& name) {
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> names_in(const std::map<std::string, int>& map) {
  std::vector<std::string> names;
  for (const auto& [name, index] : map) names.push_back(name);
  return names;
}

class Resolver {
 public:
  Resolver(Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  void resolve() {
    const std::size_t errors_before = diagnostics_.error_count();
    placements_.assign(document_.frames.size(), -1);
    for (std::size_t f = 1; f < document_.frames.size(); ++f) resolve_names(f);
    for (Joint& joint : document_.joints) {
      joint.parent_link = find_frame(joint.scope, joint.parent, kWorld);
      joint.child_link = find_frame(joint.scope, joint.child, kWorld);
      for (Axis& axis : joint.axes) axis.frame = find_frame(joint.scope, axis.expressed_in, -1);
    }
    if (diagnostics_.error_count() > errors_before) return;
    set_depths();
    set_links();
    if (diagnostics_.error_count() > errors_before) return;
    place_models();
    for (Joint& joint : document_.joints) {
      joint.parent_link = document_.frames[at(joint.parent_link)].link;
      joint.child_link = document_.frames[at(joint.child_link)].link;
    }
  }

 private:
  void resolve_names(std::size_t f) {
    Frame& frame = document_.frames[f];
    frame.reference = find_frame(frame.scope, frame.relative_to, frame.reference);
    frame.carrier = find_frame(frame.inner_scope, frame.attached_to, frame.carrier);
    placements_[f] = find_frame(frame.inner_scope, frame.placement, -1);
  }

  int find_frame(int scope, const Name& name, int otherwise) {
    if (name.text.empty()) return otherwise;
    const auto lookup = [&](const Scope& in, const std::string& text) -> std::optional<int> {
      if (text == "__model__") return in.frame;
      return index_of(document_.scopes[at(in.names)].frames, text);
    };
    if (name.text == "world") return kWorld;
    if (const std::optional<int> found = find_named(document_, scope, name.text, lookup)) return *found;
    // The default of a pose is the same name once more.
    if (!reported_.insert({name.place.source.get(), name.place.span.begin}).second) return otherwise;
    diagnostics_.error("unknown-frame", name.place, fmt::format("'{}' is not a frame of this model", name.text)).hint =
        did_you_mean(name.text, names_in(document_.scopes[at(document_.scopes[at(scope)].names)].frames));
    return otherwise;
  }

  // Walks from each frame along `next` to one whose result is known, and calls `finish` on the way back. Reports circles.
  template <class Next, class Finish>
  void walk(const char* code, const char* what, std::vector<bool>& known, const Next& next, const Finish& finish) {
    std::vector<std::size_t> walks(document_.frames.size(), 0);  // by frame: the walk that came to it
    for (std::size_t start = 1; start < document_.frames.size(); ++start) {
      std::vector<int> path;
      int frame = static_cast<int>(start);
      for (; !known[at(frame)]; frame = next(frame)) {
        known[at(frame)] = true;
        walks[at(frame)] = start;
        path.push_back(frame);
      }
      if (!path.empty() && walks[at(frame)] == start) {
        const Name& name = document_.frames[at(frame)].name;
        diagnostics_.error(code, name.place, fmt::format("frame '{}' is {} itself, through others", name.text, what));
        continue;
      }
      for (auto f = path.rbegin(); f != path.rend(); ++f) finish(*f);
    }
  }

  void set_depths() {
    std::vector<bool> known(document_.frames.size(), false);
    known[kWorld] = true;
    walk(
        "frame-cycle", "placed relative to", known, [&](int frame) { return document_.frames[at(frame)].reference; },
        [&](int frame) {
          Frame& own = document_.frames[at(frame)];
          own.depth = document_.frames[at(own.reference)].depth + 1;
        });
  }

  void set_links() {
    std::vector<bool> known(document_.frames.size(), false);
    known[kWorld] = true;
    for (const Link& link : document_.links) known[at(link.frame)] = true;
    walk(
        "frame-cycle", "attached to", known, [&](int frame) { return document_.frames[at(frame)].carrier; },
        [&](int frame) {
          Frame& own = document_.frames[at(frame)];
          own.link = document_.frames[at(own.carrier)].link;
        });
  }

  // The pose of a model whose `placement_frame` is given follows from the pose of that frame in it. Inner models first,
  // because the frame may be in one.
  void place_models() {
    std::vector<int> models;
    for (std::size_t f = 1; f < document_.frames.size(); ++f)
      if (placements_[f] >= 0) models.push_back(static_cast<int>(f));
    std::stable_sort(models.begin(), models.end(), [&](int a, int b) {
      return document_.frames[at(a)].depth > document_.frames[at(b)].depth;
    });
    for (const int model : models) {
      Frame& frame = document_.frames[at(model)];
      frame.pose = frame.pose * inverse(relative_pose(document_, placements_[at(model)], model));
    }
  }

  Document& document_;
  Diagnostics& diagnostics_;
  std::vector<int> placements_;  // by frame: the placement frame, or -1
  std::set<std::pair<const Source*, std::size_t>> reported_;  // places of unknown names
};

}  // namespace

void resolve_frames(Document& document, Diagnostics& diagnostics) {
  Resolver(document, diagnostics).resolve();
}

Pose relative_pose(const Document& document, int frame, int reference) {
  Pose left, right;  // poses of the two frames in those that the walk has reached
  while (frame != reference) {
    const Frame &a = document.frames[at(frame)], &b = document.frames[at(reference)];
    if (a.depth >= b.depth) {
      left = a.pose * left;
      frame = a.reference;
    } else {
      right = b.pose * right;
      reference = b.reference;
    }
  }
  return inverse(right) * left;
}

std::optional<int> find_joint(const Document& document, int scope, const Name& name, Diagnostics& diagnostics) {
  const auto& joints = [&](const Scope& in) -> const std::map<std::string, int>& {
    return document.scopes[at(in.names)].joints;
  };
  const auto lookup = [&](const Scope& in, const std::string& text) { return index_of(joints(in), text); };
  const std::optional<int> found = find_named(document, scope, name.text, lookup);
  if (!found)
    diagnostics.error("coupled-joint", name.place, fmt::format("joint '{}' is not declared", name.text)).hint =
        did_you_mean(name.text, names_in(joints(document.scopes[at(scope)])));
  return found;
}

}  // namespace robcogen::import::from_sdf
