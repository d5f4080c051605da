// Robot documents with parts: finds what they import, and puts the parts in.
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

// The document that an import names; nullptr after reporting why there is none.
using Resolver = std::function<std::shared_ptr<const language::kinematics::Document>(
    const language::kinematics::Document& from,
    const language::kinematics::Import& import)>;

// The plain document, without imports, parts and instances. First its own links and joints, then those of each
// instance, in the order of the text. Links of parts get the ids after those of the robot. Places in parts remember
// which instance met them (Source::Use). A document without parts is returned as it is. Reports unknown and repeated
// parts, wrong arguments, names that a part does not declare, parts in themselves, roots with parents; nullopt then.
std::optional<language::kinematics::Document> expand(
    const std::shared_ptr<const language::kinematics::Document>& document,
    const Resolver& resolve,
    Diagnostics& diagnostics);

// The text of a file that an editor holds, which is read in place of the one on disk; nullptr for other files.
using OpenTexts = std::function<std::shared_ptr<const Source>(const std::filesystem::path&)>;

struct ImportOptions {
  std::vector<std::filesystem::path> folders = {};  // searched after that of the document
  // How a robot in URDF or MJCF is written as a document. Without it such robots are refused.
  std::function<language::kinematics::Document(const model::KinematicTree&)> write = {};
  OpenTexts open_texts = {};
};

struct RobotDocument {
  language::kinematics::Document document;           // expanded
  std::vector<std::filesystem::path> imported = {};  // every file that was read for it, but its own
};

// Parses and expands. nullopt when an error was reported.
std::optional<RobotDocument> robot_document(
    const std::shared_ptr<const Source>& source,
    const ImportOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
