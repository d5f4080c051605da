// What is wrong with a document, as `robcogen check` reports it.
#pragma once

#include <memory>
#include <optional>
#include <set>

#include "driver/load.h"
#include "server/documents.h"
#include "server/robots.h"
#include "support/diagnostics.h"

namespace robcogen::server {

struct Analysis {
  Diagnostics diagnostics;
  std::optional<driver::Model> model;    // of a document without errors; none of a list
  std::set<std::filesystem::path> read;  // other documents that were read, or searched for, for it
};

// Loads the document as the commands do; open documents are read in place of their files. A list is checked against its
// robot, if one is found that has no errors itself. What cannot be read is a diagnostic, too.
std::shared_ptr<const Analysis> analyse(const OpenDocument& document, const Documents& documents, RobotFinder& robots);

// Those of a document of motions or of transforms, all that it names; nullopt of another one, or where it has errors.
std::optional<model::RigidMotions> motions_in(const std::filesystem::path& path, const Documents& documents);

}  // namespace robcogen::server
