// Text that begins like a number and is none: `0x1F`, `1_000`, `1e`, `1d0`, `1.0f`, `O.5`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robcogen::language {

// Where it ends, from `at` on, inside or behind its first digits: behind letters, digits and points, and the sign of an
// exponent.
std::size_t end_of_malformed_number(std::string_view text, std::size_t at);

// The hint for a number with letters at its end, as other languages write numbers; empty when no letters follow, or
// when they are a name. `rest` is the text behind the number.
std::string hint_to_malformed_number(std::string_view number, std::string_view rest, bool has_exponent);

}  // namespace robcogen::language
