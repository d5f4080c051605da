#include "server/analysis.h"

#include <fmt/format.h>

#include <exception>

#include "driver/failure.h"
#include "driver/fused_functions.h"
#include "import/frames.h"

namespace robcogen::server {
namespace {

namespace fs = std::filesystem;

// Returns options with which open documents are read instead of their files. Every requested path is recorded in
// `read`.
driver::LoadOptions load_options(const Documents& documents, std::set<fs::path>& read) {
  driver::LoadOptions options;
  options.import_folders = documents.import_folders;
  options.prints_canonical = false;
  options.open_texts = [&](const fs::path& path) {
    read.insert(path);
    const OpenDocument* open = documents.find(path);
    return open != nullptr ? open->source : nullptr;
  };
  return options;
}

void check_list(const OpenDocument& list, const Documents& documents, RobotFinder& robots, Analysis& analysis) {
  const language::desired::Document document = language::desired::parse(list.source, analysis.diagnostics);
  if (analysis.diagnostics.has_errors()) return;
  const std::optional<fs::path> robot = robots.find(list, document.robot.text);
  if (!robot) {
    analysis.diagnostics
        .note(
            "unchecked-list", {list.source, document.robot.span},
            fmt::format(
                "no document, or more than one, declares '{}': the frames of this list are not checked",
                document.robot.text))
        .hint =
        "it is looked for by its name in the folder of this document, then by the name of the robot in the folders of "
        "the workspace";
    return;
  }
  Diagnostics of_robot;
  const driver::LoadOptions options = load_options(documents, analysis.read);
  const driver::Language language = *driver::language_of_suffix(*robot);
  if (language == driver::Language::motions || language == driver::Language::transforms) {
    if (const auto motions = driver::load_motions_of(*robot, of_robot, options.open_texts))
      import::desired_frame_pairs(document, *motions, analysis.diagnostics);
  } else if (const auto model = driver::load(*robot, options, of_robot)) {
    driver::checked_desired_transforms(document, model->robot()->tree, analysis.diagnostics);
  }
}

// Zero bytes come from binary files and from UTF-16.
bool is_text(const OpenDocument& document, Diagnostics& diagnostics) {
  const std::size_t zero = document.source->text().find('\0');
  if (zero == std::string_view::npos) return true;
  diagnostics
      .error("not-text", {document.source, {zero, zero + 1}}, fmt::format("not a text file: byte {} is zero", zero + 1))
      .hint = "documents are UTF-8";
  return false;
}

}  // namespace

std::shared_ptr<const Analysis> analyse(const OpenDocument& document, const Documents& documents, RobotFinder& robots) {
  auto analysis = std::make_shared<Analysis>();
  if (!is_text(document, analysis->diagnostics)) return analysis;
  try {
    if (document.language == driver::Language::desired) {
      check_list(document, documents, robots, *analysis);
    } else {
      driver::LoadOptions options = load_options(documents, analysis->read);
      options.may_be_library = true;
      analysis->model = driver::load(document.path, options, analysis->diagnostics);
    }
  } catch (const driver::Failure& failure) {
    analysis->diagnostics.error("unreadable", {document.source, {}}, failure.message);
  } catch (const std::exception& fault) {
    analysis->diagnostics.error(
        "internal-fault", {document.source, {}}, fmt::format("internal fault: {}", fault.what()));
  }
  return analysis;
}

std::optional<model::RigidMotions> motions_in(const fs::path& path, const Documents& documents) {
  const std::optional<driver::Language> language = driver::language_of_suffix(path);
  if (language != driver::Language::motions && language != driver::Language::transforms) return std::nullopt;
  try {
    Diagnostics ignored;
    std::set<fs::path> read;
    return driver::load_motions_of(path, ignored, load_options(documents, read).open_texts);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace robcogen::server
