// Each answers one request of the protocol about a document, which is named in its parameters. Of a document that is
// not open, or where there is nothing to say, the result is null or an empty list.
#pragma once

#include <string>

#include "server/json.h"
#include "server/workspace.h"

namespace robcogen::server {

inline std::string uri_in(const Json& parameters) {
  return parameters.at("textDocument").at("uri").get<std::string>();
}

Json code_actions(Workspace& workspace, const Json& parameters);

}  // namespace robcogen::server
