// Functions with the results of several others, their parts, in one program: what the parts have in common is computed
// once, and all parts are traced in the link frames in which they together cost least.
#pragma once

#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"

namespace robcogen::algorithm {

// The group of the functions that the list of desired transforms defines.
inline constexpr const char* kFusedGroup = "fused";

// These functions, each with its overloads. Their parts must be functions of the robot.
std::vector<std::vector<Declared>> fused_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);

namespace catalogue {

// The overloads of a function with these parts; `parts` has the overloads of each. The function has the overloads that
// any part has, with the most loads that each part takes.
std::vector<Declared> fused_overloads(
    const Declaration& declaration,
    const Subject& subject,
    const std::string& name,
    const std::vector<std::vector<Declared>>& parts);

// The same as the functions of catalogue.h, for a function with parts.
symbolic::Program fused_outline(const Declared& function);
symbolic::Function fused_description(const Declared& function);
symbolic::Function fused_trace(const Declared& function, FormulationChoices& choices);

}  // namespace catalogue
}  // namespace robcogen::algorithm
