#include "import/sdf.h"

#include <fmt/format.h>

#include <utility>

#include "import/sdf/describe.h"
#include "import/sdf/frames.h"
#include "import/sdf/read.h"
#include "import/xml/frame_names.h"

namespace robcogen::import {

namespace {

using namespace from_sdf;

void note_ignored(const Document& document, Diagnostics& diagnostics) {
  std::string list;
  for (const auto& [name, count] : document.ignored)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, name);
  if (!list.empty())
    diagnostics.note("ignored-elements", document.name.place, fmt::format("elements that are not read: {}", list));
}

void note_floating_base(const model::Description& description, Diagnostics& diagnostics) {
  if (!description.floating_base) return;
  diagnostics
      .note(
          "base-floats", description.base.place,
          fmt::format("no joint connects '{}' to the world: it is a floating base", description.base.name))
      .hint = "to fix it, write a joint of type \"fixed\" with <parent>world</parent>";
}

}  // namespace

std::optional<Sdf> sdf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const SdfOptions& options,
    Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto failed = [&] { return diagnostics.error_count() > errors_before; };
  Sdf result;
  const std::optional<xml::Element> root = xml::read(source, diagnostics);
  if (!root) return std::nullopt;
  if (root->name != "sdf") {
    diagnostics.error(
        "not-sdf", {source, root->span}, fmt::format("the root element of SDF is 'sdf', not '{}'", root->name));
    return std::nullopt;
  }
  Document document = read_document(xml::located(*root, source), file, options, result.included, diagnostics);
  if (failed()) return std::nullopt;
  resolve_frames(document, diagnostics);
  if (failed()) return std::nullopt;
  const std::optional<Topology> topology = connect(document, diagnostics);
  if (!topology) return std::nullopt;
  const Identifiers identifiers = identifiers_of(document, *topology, diagnostics);
  if (failed()) return std::nullopt;
  model::Description description = describe(document, *topology, identifiers, options, diagnostics);
  if (failed()) return std::nullopt;
  note_ignored(document, diagnostics);
  note_floating_base(description, diagnostics);
  rename_hidden_frames(description, diagnostics);
  std::optional<model::KinematicTree> tree = model::build(description, options.changes, diagnostics);
  if (!tree) return std::nullopt;
  result.tree = std::move(*tree);
  return result;
}

}  // namespace robcogen::import
