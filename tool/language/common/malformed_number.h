// Text that begins like a number but is not one: `0x1F`, `1_000`, `1e`, `1d0`, `1.0f`, `O.5`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robcogen::language {

// Returns where such text ends. `at` is inside or behind its first digits; letters, digits, points and the sign of an
// exponent belong to it.
std::size_t end_of_malformed_number(std::string_view text, std::size_t at);

// Returns the hint for a number with letters at its end, as other languages write numbers; empty if no letters follow,
// or if they are a name. `rest` is the text after the number.
std::string hint_to_malformed_number(std::string_view number, std::string_view rest, bool has_exponent);

}  // namespace robcogen::language
