// The inertial parameters of a robot, on which its dynamics depend linearly.
//
// The parameters of a link are ten numbers in link axes about the link's origin, as documents have them: mass m (kg),
// first moment m c (kg m), moments of inertia Ixx, Iyy, Izz, and products Ixy, Ixz, Iyz of positive sign (kg m^2). The
// parameters of a robot are those of its moving links, in the order of the document: all links, or all but a fixed
// base.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algorithm/spatial/mass_properties.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

inline constexpr int kParametersOfLink = 10;
using InertialNumbers = std::array<Expression, kParametersOfLink>;

// What the places of Ixx, Iyy, Izz hold: the moments of inertia, or the integrals of x^2, y^2, z^2 dm, which cost less.
enum class Moments { of_inertia, of_mass };

MassProperties mass_properties(const InertialNumbers& numbers, Moments moments = Moments::of_inertia);
InertialNumbers inertial_numbers(const MassProperties& body, Moments moments = Moments::of_inertia);

// The first link that moves, and the number of parameters of all links that move.
int first_moving_link(const model::KinematicTree& tree);
int inertial_parameter_count(const model::KinematicTree& tree);
// `lowerarm_m`, `lowerarm_hx`, …, `lowerarm_Ixx`, …: labels of these parameters.
std::vector<symbolic::QuantityRef> inertial_parameter_quantities(const model::KinematicTree& tree);
std::vector<std::string> inertial_parameter_names(const model::KinematicTree& tree);

// -> pi: the numbers of the document; they depend on its parameters alone.
symbolic::Program inertial_parameters(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
