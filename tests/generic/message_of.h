// The message of a call about its arguments.
#pragma once

#include <stdexcept>
#include <string>

namespace robcogen::test {

// Returns the text of the std::invalid_argument that the call throws, or `no error` if it throws none.
template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace robcogen::test
