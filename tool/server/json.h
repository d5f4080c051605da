// The JSON values of the protocol.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace robcogen::server {

using Json = nlohmann::json;

// Returns the text of a value on one line. Bytes that are not UTF-8 become U+FFFD.
inline std::string text_of(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Returns the member of an object, or null.
inline const Json& member(const Json& object, const char* name) {
  static const Json null;
  if (!object.is_object()) return null;
  const auto found = object.find(name);
  return found == object.end() ? null : *found;
}

}  // namespace robcogen::server
