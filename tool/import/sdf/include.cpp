#include "import/sdf/include.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "import/resource.h"
#include "import/sdf/check.h"
#include "support/files.h"

namespace robcogen::import::from_sdf {

namespace fs = std::filesystem;

namespace {

// More than any robot needs, and few enough that files which include others many times over are refused in time.
constexpr std::size_t kMaxIncludes = 1000;

fs::path target_of(const fs::path& path) {
  std::error_code fault;
  const fs::path canonical = fs::weakly_canonical(path, fault);
  return fault ? path : canonical;
}

// Returns the file that `model.config` of the folder names for the newest version, or else `model.sdf`.
fs::path model_in(const fs::path& folder, std::vector<fs::path>& included) {
  const fs::path config = folder / "model.config";
  std::string fault;
  Diagnostics ignored;
  std::optional<std::string> text = read_file(config, fault);
  if (!text) return folder / "model.sdf";
  included.push_back(config);
  const auto source = std::make_shared<const Source>(config.string(), std::move(*text));
  const std::optional<xml::Element> root = xml::read(source, ignored);
  std::string newest = "model.sdf";
  int version = -1;
  for (const xml::Element& child : root ? root->children : std::vector<xml::Element>()) {
    if (child.name != "sdf" || child.text.empty()) continue;
    const int own = read_version(xml::located(child, source), ignored).value_or(0);
    if (own > version) version = own, newest = child.text;
  }
  return folder / newest;
}

}  // namespace

Includer::Includer(
    const fs::path& file,
    const std::vector<fs::path>& folders,
    std::vector<fs::path>& included,
    Diagnostics& diagnostics)
    : open_({target_of(file)}), folders_(folders), included_(included), diagnostics_(diagnostics) {}

std::optional<fs::path> Includer::path_of(const Attribute& uri, const fs::path& folder) {
  const std::optional<fs::path> found = find_resource(uri.value, folder, folders_);
  std::error_code fault;
  if (found && fs::is_directory(*found, fault)) return model_in(*found, included_);
  return found;
}

std::shared_ptr<const IncludedFile> Includer::open(
    const Element& include,
    const fs::path& folder,
    bool may_fail,
    ElementReader& reader) {
  const Element* element = reader.require_child(include, "uri");
  if (element == nullptr) return nullptr;
  const Attribute uri = xml::text_of(*element);
  const std::optional<fs::path> path = path_of(uri, folder);
  if (!path) {
    const std::string message = fmt::format("'{}' is not found", uri.value);
    Diagnostic& diagnostic = may_fail ? diagnostics_.warning("include-not-found", uri.place, message + ": it is left out")
                                      : diagnostics_.error("include-not-found", uri.place, message);
    diagnostic.hint = "-I (IMPORT_DIRS in CMake) names folders with models; those around the file are searched too";
    return nullptr;
  }
  if (std::find(open_.begin(), open_.end(), target_of(*path)) != open_.end()) {
    diagnostics_.error("include-cycle", uri.place, fmt::format("file '{}' includes itself", path->filename().string()));
    return nullptr;
  }
  if (++count_ > kMaxIncludes) {
    if (count_ == kMaxIncludes + 1)
      diagnostics_.error("too-many-includes", uri.place, fmt::format("more than {} models are included", kMaxIncludes));
    return nullptr;
  }
  std::shared_ptr<const IncludedFile> result = read(*path, uri, may_fail);
  if (result) reopen(*result);
  return result;
}

void Includer::reopen(const IncludedFile& file) {
  open_.push_back(target_of(file.path));
}

std::shared_ptr<const IncludedFile> Includer::read(const fs::path& path, const Attribute& uri, bool may_fail) {
  std::string fault;
  std::optional<std::string> text = read_file(path, fault);
  if (!text) {
    const std::string message = fmt::format("file '{}' cannot be read", path.string());
    if (may_fail)
      diagnostics_.warning("unreadable-include", uri.place, message + ": it is left out");
    else
      diagnostics_.error("unreadable-include", uri.place, message);
    return nullptr;
  }
  included_.push_back(path);
  const auto source = std::make_shared<const Source>(path.string(), std::move(*text));
  const std::optional<xml::Element> root = xml::read(source, diagnostics_);
  if (!root) return nullptr;
  auto result = std::make_shared<IncludedFile>();
  result->root = xml::located(*root, source);
  if (root->name != "sdf") {
    diagnostics_
        .error(
            "not-sdf", result->root.place,
            fmt::format("the root element of an included file is 'sdf', not '{}'", root->name))
        .notes.push_back({uri.place, "included here"});
    return nullptr;
  }
  const std::optional<int> version = read_version(result->root, diagnostics_);
  if (!version) return nullptr;
  if (checked_.insert(path).second) check_names(result->root, diagnostics_);
  result->context = {*version, path.parent_path()};
  result->path = path;
  for (const Element& child : result->root.children) {
    if (child.name == "model" && result->model == nullptr) result->model = &child;
    if (child.name == "world") {
      diagnostics_
          .error("included-world", child.place, "an included file has a model, not a world")
          .notes.push_back({uri.place, "included here"});
      return nullptr;
    }
  }
  return result;
}

}  // namespace robcogen::import::from_sdf
