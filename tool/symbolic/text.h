// Programs as text and back: the format that pass tests read and write. One item a line:
//     program inverse_dynamics
//     input q joint_position SLIDE HFE
//     output tau joint_force 2 1
//     section upperleg link upperleg: velocity
//     in 0
//     let upperleg_wz = q[0] * 0.35        (let: a statement of its own; tmp: others)
//     tmp upperleg_t0 = sin q[1]
//     tmp legs_qd = gather qd[0] qd[3]     (lanes; legs_qd@1 is one of them)
//     return tau upperleg_wz -upperleg_t0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// The text reads back: print(parse(print(p))) == print(p). It keeps the double of a constant and whether it is a
// multiple of PI; constants that nothing reads are left out.
std::string print(const Program& program);

// The names in the text, all distinct: those of the quantities, otherwise a number within the section. A program that
// was read from text keeps its names.
std::vector<std::string> statement_names(const Program& program);

// nullopt, with a message `line N: …` in `error`, when the text is not a program.
std::optional<Program> parse(const std::string& text, std::string& error);

}  // namespace robcogen::symbolic
