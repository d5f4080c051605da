// Each function answers one request of the protocol about a document, which the parameters name. If the document is not
// open, or there is nothing to report, the result is null or an empty list.
#pragma once

#include <optional>
#include <string>

#include "model/kinematic_tree.h"
#include "server/json.h"
#include "server/workspace.h"

namespace robcogen::server {

inline std::string uri_in(const Json& parameters) {
  return parameters.at("textDocument").at("uri").get<std::string>();
}

// Returns the robot that the document at this path describes, which may be a URDF; nullopt if it has errors.
std::optional<model::KinematicTree> tree_of(Workspace& workspace, const std::filesystem::path& path);

Json code_actions(Workspace& workspace, const Json& parameters);
Json completion(Workspace& workspace, const Json& parameters);
Json definition(Workspace& workspace, const Json& parameters);
Json document_symbols(Workspace& workspace, const Json& parameters);
Json folding_ranges(Workspace& workspace, const Json& parameters);
// Returns the edits that make the text canonical; null for a document with syntax errors.
Json formatting(Workspace& workspace, const Json& parameters);
Json highlights(Workspace& workspace, const Json& parameters);
Json hover(Workspace& workspace, const Json& parameters);
Json inlay_hints(Workspace& workspace, const Json& parameters);
Json prepare_rename(Workspace& workspace, const Json& parameters);
Json references(Workspace& workspace, const Json& parameters);
// Throws RequestError for a name that is not valid, or that causes an error in a document.
Json rename(Workspace& workspace, const Json& parameters);

Json semantic_tokens(Workspace& workspace, const Json& parameters);
// The names of the token types, in the order of their numbers.
Json semantic_token_types();

}  // namespace robcogen::server
