// Reads imported documents from files.
#include <fmt/format.h>

#include <map>
#include <system_error>
#include <utility>

#include "import/mjcf.h"
#include "import/sdf.h"
#include "import/parts.h"
#include "import/urdf.h"
#include "language/common/content.h"
#include "support/files.h"

namespace robcogen::import {
namespace {

namespace fs = std::filesystem;
namespace kinematics = language::kinematics;
using DocumentPtr = std::shared_ptr<const kinematics::Document>;

class Files {
 public:
  Files(const ImportOptions& options, Diagnostics& diagnostics) : options_(options), diagnostics_(diagnostics) {}

  DocumentPtr operator()(const kinematics::Document& from, const kinematics::Import& import) {
    const Place place = {from.source, import.span};
    const std::optional<fs::path> path = find(from, import.file, place);
    if (!path) return nullptr;
    std::error_code ignored;
    const auto [known, is_new] = documents_.insert({fs::weakly_canonical(*path, ignored), nullptr});
    if (is_new) known->second = read(*path, place);
    return known->second;
  }

  const std::vector<fs::path>& read_files() const { return read_; }

 private:
  const ImportOptions& options_;
  Diagnostics& diagnostics_;
  std::map<fs::path, DocumentPtr> documents_;
  std::vector<fs::path> read_;

  std::shared_ptr<const Source> open_text(const fs::path& path) const {
    return options_.open_texts ? options_.open_texts(path.lexically_normal()) : nullptr;
  }

  std::optional<fs::path> find(const kinematics::Document& from, const std::string& file, const Place& place) {
    std::vector<fs::path> candidates = {fs::path(from.source->name()).parent_path() / file};
    for (const fs::path& folder : options_.folders) candidates.push_back(folder / file);
    std::error_code ignored;
    for (const fs::path& candidate : candidates)
      if (!file.empty() && (open_text(candidate) || fs::exists(candidate, ignored)))
        return candidate.lexically_normal();
    Diagnostic& error = diagnostics_.error("unknown-file", place, fmt::format("cannot find file '{}'", file));
    error.hint = options_.folders.empty()
                     ? "it is looked for in the folder of this document; '-I FOLDER' adds a folder to search"
                     : "it is looked for in the folder of this document and in the folders of '-I'";
    return std::nullopt;
  }

  DocumentPtr read(const fs::path& path, const Place& place) {
    std::string fault;
    const std::shared_ptr<const Source> open = open_text(path);
    const std::optional<std::string> text = open ? std::string(open->text()) : read_file(path, fault);
    if (!text || text->find('\0') != std::string::npos) {
      const std::string reason = text ? "not a text file" : fault.substr(fault.find("error: ") + 7);
      diagnostics_.error("unreadable-import", place, fmt::format("'{}': {}", path.string(), reason));
      return nullptr;
    }
    read_.push_back(path);
    const std::size_t errors_before = diagnostics_.error_count();
    DocumentPtr document = parse(path, open ? open : std::make_shared<const Source>(path.string(), *text), place);
    return diagnostics_.error_count() > errors_before ? nullptr : document;
  }

  DocumentPtr parse(const fs::path& path, const std::shared_ptr<const Source>& source, const Place& place) {
    const language::Content content = language::content_of(source->text());
    if (content == language::Content::urdf) {
      const auto tree = urdf(source, {}, diagnostics_);
      return tree ? written(*tree, source, place) : nullptr;
    }
    if (content == language::Content::mjcf) {
      const std::optional<Mjcf> read = mjcf(source, path, {}, diagnostics_);
      if (!read) return nullptr;
      read_.insert(read_.end(), read->included.begin(), read->included.end());
      return written(read->tree, source, place);
    }
    if (content == language::Content::sdf) {
      const std::optional<Sdf> read = sdf(source, path, {.folders = options_.folders}, diagnostics_);
      if (!read) return nullptr;
      read_.insert(read_.end(), read->included.begin(), read->included.end());
      return written(read->tree, source, place);
    }
    return std::make_shared<const kinematics::Document>(kinematics::parse(source, diagnostics_));
  }

  // Converts a robot to a document, in which names keep their places in the file.
  DocumentPtr written(const model::KinematicTree& tree, const std::shared_ptr<const Source>& source, const Place& place)
      const {
    if (!options_.write) {
      diagnostics_.error("unreadable-import", place, "URDF, MJCF and SDF cannot be imported here");
      return nullptr;
    }
    kinematics::Document document = options_.write(tree);
    document.source = source;
    const auto span_of = [&](const Place& known) { return known.source == source ? known.span : Span{}; };
    std::map<std::string, Span> places;
    for (const model::Link& link : tree.links) places.insert({link.name, span_of(link.place)});
    for (kinematics::Link& link : document.links) link.name.span = places[link.name.text];
    for (const model::Joint& joint : tree.joints) places.insert({joint.name, span_of(joint.place)});
    for (kinematics::Joint& joint : document.joints) joint.name.span = places[joint.name.text];
    return std::make_shared<const kinematics::Document>(std::move(document));
  }
};

}  // namespace

std::optional<RobotDocument> robot_document(
    const std::shared_ptr<const Source>& source,
    const ImportOptions& options,
    Diagnostics& diagnostics) {
  const auto document = std::make_shared<const kinematics::Document>(kinematics::parse(source, diagnostics));
  if (diagnostics.has_errors()) return std::nullopt;
  Files files(options, diagnostics);
  std::optional<kinematics::Document> expanded = expand(
      document, [&](const auto& from, const auto& import) { return files(from, import); }, diagnostics);
  if (!expanded) return std::nullopt;
  return RobotDocument{std::move(*expanded), files.read_files()};
}

}  // namespace robcogen::import
