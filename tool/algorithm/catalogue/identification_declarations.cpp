// Functions for identification and adaptive control: regressors, and the parameters that they multiply.
#include <string>
#include <vector>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/identification/base_regressor.h"
#include "algorithm/identification/drive_regressor.h"
#include "algorithm/identification/regressor.h"

namespace robcogen::algorithm::catalogue {
namespace {

constexpr const char* kParameters =
    "Ten per moving link, in link axes about its origin: mass m, first moment hx hy hz (mass times centre of mass), "
    "moments of inertia Ixx Iyy Izz, products Ixy Ixz Iyz of positive sign.";
constexpr const char* kRegressorRows =
    "{floating? (6 + n) rows: those of the base wrench first, in base coordinates, moment first. The motion of the "
    "base is an argument, as in inverse_dynamics_fully_actuated.}";
constexpr const char* kCoupled =
    "{coupled? The base parameters are computed as if no joints were coupled: some may be dependent.}";

// `what` is a name in `base_regressor` or `base_regressor_any_gravity`.
#define BASE_REGRESSOR(suffix)                                                                                \
  "Regressor Y of base parameters, the combinations of inertial parameters that forces depend on: Y times "   \
  "base_parameters" suffix                                                                                    \
  "(inertial_parameters) gives the joint forces, without those of drives (Khalil and Dombre 2002, sec. 9.4; " \
  "Wensing, Niemeyer and Slotine 2017).",                                                                     \
      "base_regressor" suffix "_columns lists the columns.", kRegressorRows
#define BASE_PARAMETERS(suffix) \
  "Base parameters, which the columns of base_regressor" suffix " multiply, from inertial parameters.", kParameters

std::vector<std::string> labels_of_links(const Subject& s) {
  return inertial_parameter_names(s.tree);
}
std::vector<std::string> labels_of_drives(const Subject& s) {
  return drive_parameter_names(s.tree);
}
std::vector<std::string> labels_of_base(const Subject& s) {
  return base_parameter_names(s.tree, s.loads);
}
std::vector<std::string> labels_under_any_gravity(const Subject& s) {
  return base_parameter_names(s.tree, Loads::gravity);
}

template <std::vector<std::string> (*labels)(const Subject&)>
int count(const Subject& s) {
  return static_cast<int>(labels(s).size());
}
constexpr Size of_links = count<labels_of_links>, of_drives = count<labels_of_drives>, of_base = count<labels_of_base>,
               under_any_gravity = count<labels_under_any_gravity>;

Tracing under_gravity(Tracing t) {
  t.loads = Loads::gravity;
  return t;
}

}  // namespace

Declarations identification_declarations() {
  return {
      {"regressor",
       {{.name = "regressor",
         .summary =
             {"Regressor Y of inverse dynamics: Y times inertial_parameters() gives the joint forces, without those of "
              "drives (Khalil and Dombre 2002, ch. 12).",
              "regressor_columns lists the columns.", kRegressorRows},
         .signature = {motion, {matrix("Y", velocities, of_links)}, Overloads::gravity},
         .program = {by<regressor>},
         .labels = labels_of_links},
        {.name = "inertial_parameters",
         .summary =
             {"The inertial parameters of the document (kg, kg m, kg m^2), which the columns of regressor multiply.",
              kParameters},
         .signature = {{}, {value("pi", of_links)}},
         .program = {by<inertial_parameters>}},
        {.name = "drive_regressor",
         .summary =
             {"Regressor of drives: Y times drive_parameters() gives the joint forces of drives.",
              "drive_regressor_columns lists the columns. For each joint: inertia that only this joint moves, damping, "
              "friction, spring stiffness, constant force. {tendons? For each tendon: stiffness, damping, constant "
              "force. }For each rotor on a moving link: inertia times ratio.",
              kRegressorRows},
         .signature = {motion, {matrix("Y", velocities, of_drives)}},
         .program = {by<drive_regressor>},
         .labels = labels_of_drives},
        {.name = "drive_parameters",
         .summary =
             {"The parameters of the document's drives, which the columns of drive_regressor multiply.",
              "{passive? Inverse dynamics includes all of them.}"
              "{not passive? Inverse dynamics does not include damping, friction and springs{tendons?  of joints}.}"},
         .signature = {{}, {value("pi", of_drives)}},
         .program = {by<drive_parameters>}}}},
      {"base_regressor",
       {{.name = "base_regressor",
         .summary =
             {BASE_REGRESSOR(""),
              "{fixed? Gravity is (0, 0, -9.81) m/s^2 in base coordinates: under any other gravity, forces may depend "
              "on more parameters, those of base_regressor_any_gravity.}"
              "{floating? `gravity` (m/s^2) is in base coordinates.}",
              kCoupled},
         .signature = {{q, qd, qdd, base_velocity, base_acceleration, gravity}, {matrix("Y", velocities, of_base)}},
         .program = {by<base_regressor>},
         .labels = labels_of_base},
        {.name = "base_parameters",
         .summary = {BASE_PARAMETERS("")},
         .signature = {{value("inertial_parameters", of_links)}, {value("beta", of_base)}},
         .program = {by<base_parameters>}},
        {.name = "base_regressor_any_gravity",
         .exists = is_fixed,
         .summary =
             {BASE_REGRESSOR("_any_gravity"),
              "`gravity` (m/s^2) is in base coordinates and may have any direction. If all measurements have the same "
              "direction, some parameters may be dependent.",
              kCoupled},
         .signature = {{q, qd, qdd, {"gravity", Role::gravity, rows<3>}}, {matrix("Y", velocities, under_any_gravity)}},
         .program = {[](const Tracing& t) { return by<base_regressor>(under_gravity(t)); }},
         .labels = labels_under_any_gravity},
        {.name = "base_parameters_any_gravity",
         .exists = is_fixed,
         .summary = {BASE_PARAMETERS("_any_gravity")},
         .signature = {{value("inertial_parameters", of_links)}, {value("beta", under_any_gravity)}},
         .program = {[](const Tracing& t) { return by<base_parameters>(under_gravity(t)); }}}}},
      {"energy_regressor",
       {{.name = "energy_regressor",
         .summary =
             {"Regressor Y of the energies (J): Y times the inertial parameters, in the order of the columns of "
              "regressor, gives the kinetic energy (first row) and the potential energy (second row), without those of "
              "drives.",
              "{floating? `base_velocity` is in base coordinates, angular first.}"},
         .signature = {{q, qd, base_velocity}, {matrix("Y", rows<2>, of_links)}, Overloads::gravity},
         .program = {by<energy_regressor>}}}},
      {"slotine_li_regressor",
       {{.name = "slotine_li_regressor",
         .summary =
             {"Regressor Y of a reference motion, for adaptive control: Y times the inertial parameters, in the order "
              "of the columns of regressor, is H qdd_r + C qd_r + gravity forces, with the Coriolis matrix C of "
              "coriolis_matrix, for which dH/dt - 2 C is skew symmetric (Slotine and Li 1987; Niemeyer and Slotine "
              "1991).",
              "{floating? (6 + n) rows: those of the base wrench first, moment first; the base also has a reference "
              "velocity and the rate of its coordinates. All are in base coordinates, angular first.}"},
         .signature =
             {{q,
               qd,
               {"qd_r", Role::joint_velocity, coordinates},
               {"qdd_r", Role::joint_acceleration, coordinates},
               base_velocity,
               {"base_velocity_r", Role::base_velocity, rows<6>, nullptr, is_floating},
               {"base_acceleration_r", Role::base_acceleration, rows<6>, nullptr, is_floating}},
              {matrix("Y", velocities, of_links)},
              Overloads::gravity},
         .program = {by<slotine_li_regressor>}}}}};
}

}  // namespace robcogen::algorithm::catalogue
