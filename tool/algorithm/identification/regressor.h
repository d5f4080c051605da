// Regressors: matrices that give forces and energies of a robot as linear functions of its inertial parameters.
// Rows are those of a floating base (moment, force), then coordinates. (Atkeson, An, Hollerbach 1986; Khalil and Dombre
// 2002, ch. 12.)
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algorithm/dynamics/loads.h"
#include "algorithm/dynamics/traced_robot.h"
#include "algorithm/identification/inertial_parameters.h"

namespace robcogen::algorithm {

// q, qd, qdd [, base_velocity, base_acceleration] -> Y. Y times the inertial parameters are the forces (base wrench,
// tau) of inverse dynamics, fully actuated, without the contribution of drives.
symbolic::Program regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative = {});

// q, qd, qd_r, qdd_r [, base_velocity, base_velocity_r, base_acceleration_r] -> Y. Y times the inertial parameters is
// H qdd_r + C qd_r + the gravity forces, with the Coriolis matrix C of coriolis_matrix, for which dH/dt - 2 C is skew
// symmetric (Slotine and Li 1987; Niemeyer and Slotine 1991).
symbolic::Program slotine_li_regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative = {});

// q, qd [, base_velocity] -> Y, two rows: Y times the inertial parameters is (kinetic energy, potential energy),
// without the contribution of drives (Gautier and Khalil 1988).
symbolic::Program energy_regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative = {});

// The elements of Y, by link and inertial parameter: rows of the base, then of joints.
using RegressorColumn = std::vector<Expression>;
using LinkColumns = std::array<RegressorColumn, kParametersOfLink>;

// The columns of inverse dynamics, by link; empty for a fixed base. Declares the inputs of `regressor`.
std::vector<LinkColumns> regressor_columns(
    Trace& trace,
    Loads loads,
    const RepresentativeLinks& representative,
    Moments moments = Moments::of_inertia);

// The columns one after the other, with rows of coordinates in place of those of joints.
std::vector<Expression> flat_by_coordinate(Trace& trace, const std::vector<RegressorColumn>& columns);

}  // namespace robcogen::algorithm
