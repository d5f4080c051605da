#include "import/mjcf.h"

#include <fmt/format.h>

#include <utility>

#include "import/mjcf/check.h"
#include "import/mjcf/describe.h"
#include "import/mjcf/describe_loops.h"
#include "import/xml/frame_names.h"

namespace robcogen::import {

namespace {

using namespace from_mjcf;

// Warns about ignored constraints between bodies, which change how the robot moves; other ignored elements, which add
// forces or nothing, get a note.
void mention_ignored(const Document& document, Diagnostics& diagnostics) {
  std::string list, constraints, forces;
  for (const auto& [name, count] : document.ignored) {
    std::string& to = name.starts_with("equality/") ? constraints : name == "deformable/flex" ? forces : list;
    to += fmt::format("{}{} {}", to.empty() ? "" : ", ", count, name);
  }
  if (!constraints.empty())
    diagnostics.warning(
        "constraints-ignored", document.name.place,
        fmt::format("constraints are ignored, and the bodies move without them: {}", constraints));
  if (!forces.empty())
    diagnostics.warning(
        "flex-forces", document.name.place,
        fmt::format("elastic bodies are ignored, and the bodies move without their forces: {}", forces));
  if (!list.empty())
    diagnostics.note("ignored-elements", document.name.place, fmt::format("elements that are not read: {}", list));
}

bool can_be_built(const model::Description& description, const MjcfOptions& options) {
  Diagnostics diagnostics;
  return model::build(description, options.changes, diagnostics).has_value();
}

}  // namespace

std::optional<Mjcf> mjcf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const MjcfOptions& options,
    Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto failed = [&] { return diagnostics.error_count() > errors_before; };
  Mjcf result;
  const std::optional<Element> root = read_with_includes(source, file, result.included, diagnostics);
  if (!root) return std::nullopt;
  if (root->name != "mujoco") {
    diagnostics
        .error("not-mjcf", root->place, fmt::format("the root element of a model is 'mujoco', not '{}'", root->name))
        .hint = "another file includes this one: read that file";
    return std::nullopt;
  }
  check_names(*root, diagnostics);
  Document document = read_document(*root, file, options, result.included, diagnostics);
  const Identifiers identifiers = identifiers_of(document, diagnostics);
  if (failed()) return std::nullopt;
  model::Description description = describe(document, identifiers, diagnostics);
  if (failed()) return std::nullopt;
  mention_ignored(document, diagnostics);
  rename_hidden_frames(description, diagnostics);
  if (document.has_key && !can_be_built(description, options)) {
    diagnostics.note(
        "key-not-used", document.key_place, "the loops cannot be closed in this 'key': they are assembled as drawn");
    Diagnostics repeated;
    document.has_key = false;
    description = describe(document, identifiers, repeated);
    rename_hidden_frames(description, repeated);
  }
  if (!document.has_key) check_drawn_loops(document, diagnostics);
  std::optional<model::KinematicTree> tree = model::build(description, options.changes, diagnostics);
  if (!tree && !document.loops.empty())
    diagnostics.note(
        "loops-can-be-left-open", document.loops.front().place, "--free-mimic-joints leaves the loops of MJCF open");
  if (!tree) return std::nullopt;
  if (options.shapes.collisions) tree->geometry.may_touch = excluded_pairs(document, identifiers);
  result.tree = std::move(*tree);
  return result;
}

}  // namespace robcogen::import
