// Each answers one request of the protocol about a document, which is named in its parameters. Of a document that is
// not open, or where there is nothing to say, the result is null or an empty list.
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

// The robot that a document of this path describes, also a URDF; nullopt where it has errors.
std::optional<model::KinematicTree> tree_of(Workspace& workspace, const std::filesystem::path& path);

Json code_actions(Workspace& workspace, const Json& parameters);
Json completion(Workspace& workspace, const Json& parameters);
Json definition(Workspace& workspace, const Json& parameters);
Json document_symbols(Workspace& workspace, const Json& parameters);
Json folding_ranges(Workspace& workspace, const Json& parameters);
// The canonical print; null for a document with errors of syntax.
Json formatting(Workspace& workspace, const Json& parameters);
Json highlights(Workspace& workspace, const Json& parameters);
Json hover(Workspace& workspace, const Json& parameters);
Json inlay_hints(Workspace& workspace, const Json& parameters);
Json prepare_rename(Workspace& workspace, const Json& parameters);
Json references(Workspace& workspace, const Json& parameters);
// RequestError for a name that is not valid, or that makes a document wrong.
Json rename(Workspace& workspace, const Json& parameters);

Json semantic_tokens(Workspace& workspace, const Json& parameters);
// The names of their types, in the order of the numbers.
Json semantic_token_types();

}  // namespace robcogen::server
