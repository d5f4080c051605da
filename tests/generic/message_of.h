// What a call says about its arguments.
#pragma once

#include <stdexcept>
#include <string>

namespace robcogen::test {

// The text of the std::invalid_argument that it throws; `no error` where it throws none.
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
