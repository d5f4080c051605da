// Robot documents with parts: finds the imported documents and inserts the parts.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "language/kinematics/document.h"
#include "model/kinematic_tree.h"

namespace robcogen::import {

// Returns the document that an import names; nullptr after reporting why there is none.
using Resolver = std::function<std::shared_ptr<const language::kinematics::Document>(
    const language::kinematics::Document& from,
    const language::kinematics::Import& import)>;

// Returns the plain document, without imports, parts and instances: first its own links and joints, then those of each
// instance, in the order of the text. Links of parts get the ids after those of the robot. Places in parts record the
// instance to which they belong (Source::Use). A document without parts is returned unchanged. Reports unknown and
// repeated parts, wrong arguments, names that a part does not declare, parts that contain themselves, and roots with
// parents; the result is then nullopt.
std::optional<language::kinematics::Document> expand(
    const std::shared_ptr<const language::kinematics::Document>& document,
    const Resolver& resolve,
    Diagnostics& diagnostics);

// Returns the text of a file that is open in an editor, which is read instead of the file on disk; nullptr for other
// files.
using OpenTexts = std::function<std::shared_ptr<const Source>(const std::filesystem::path&)>;

struct ImportOptions {
  std::vector<std::filesystem::path> folders = {};  // searched after the document's own folder
  // Converts a robot in URDF or MJCF to a document. If absent, such robots are refused.
  std::function<language::kinematics::Document(const model::KinematicTree&)> write = {};
  OpenTexts open_texts = {};
};

struct RobotDocument {
  language::kinematics::Document document;           // expanded
  std::vector<std::filesystem::path> imported = {};  // every other file that was read for it
};

// Parses and expands a robot document. nullopt if an error was reported.
std::optional<RobotDocument> robot_document(
    const std::shared_ptr<const Source>& source,
    const ImportOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
