// The requests that the server answers, by the name of their method.
#pragma once

#include <functional>
#include <string>

#include "server/json.h"
#include "server/workspace.h"

namespace robcogen::server {

// Computes the result of a request from its parameters. Throws an exception of the JSON library if the parameters are
// malformed.
using Answer = std::function<Json(Workspace&, const Json& parameters)>;

// Returns nullptr for an unknown method.
const Answer* find_answer(const std::string& method);

// The capabilities that the result of `initialize` lists for these requests.
Json capabilities_of_answers();

}  // namespace robcogen::server
