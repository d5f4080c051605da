// Programs as text, and back: what pass tests read and write.
#pragma once

#include <optional>
#include <string>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Reads back: print(parse(print(p))) == print(p). Text keeps of a constant its double, and whether it is a multiple of
// PI; constants that nothing reads are left out.
std::string print(const Program& program);

// nullopt with a message `line N: …` in `error` when the text is no program.
std::optional<Program> parse(const std::string& text, std::string& error);

// Internal consistency: operands before users, indices in range, names unique, identifiers and no operation, constants
// finite and not negative, output sizes right.
// Empty when sound, else what is wrong first.
std::string verify(const Program& program);

}  // namespace robcogen::symbolic
