// The requests that the server answers, by the name of their method.
#pragma once

#include <functional>
#include <string>

#include "server/json.h"
#include "server/workspace.h"

namespace robcogen::server {

// From the parameters of a request to its result; an exception of the JSON library where they are not as they should
// be.
using Answer = std::function<Json(Workspace&, const Json& parameters)>;

// nullptr for an unknown method.
const Answer* find_answer(const std::string& method);

// What `initialize` says of them.
Json capabilities_of_answers();

}  // namespace robcogen::server
