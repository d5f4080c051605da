// Finds what is wrong with a document, as `robcogen check` reports it.
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
  std::optional<driver::Model> model;    // of a document without errors; absent for a list
  std::set<std::filesystem::path> read;  // other documents that were read, or looked for
};

// Loads the document as the commands do, except that open documents are read instead of their files. A list is checked
// against its robot, if a robot without errors is found. A document that cannot be read gets a diagnostic too.
std::shared_ptr<const Analysis> analyse(const OpenDocument& document, const Documents& documents, RobotFinder& robots);

// Returns the motions of a document of motions or transforms, with all frames that it names; nullopt for another
// document, or if it has errors.
std::optional<model::RigidMotions> motions_in(const std::filesystem::path& path, const Documents& documents);

}  // namespace robcogen::server
