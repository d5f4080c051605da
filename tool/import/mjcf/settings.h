// The settings that the elements `compiler` and `option` give for the whole model.
#pragma once

#include <string>

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

enum class InertiaFromGeoms { never, always, where_absent };

struct Settings {
  bool degrees = true;
  std::string euler_sequence = "xyz";  // axes of the rotations; capitals are fixed axes
  InertiaFromGeoms inertia_from_geoms = InertiaFromGeoms::where_absent;
  bool limits_follow_ranges = true;  // a joint with a range is limited unless it says otherwise
  bool balances_inertias = false;
  bool constraints = true, equalities = true, friction = true;  // false: disabled by a flag
  Number least_mass, least_moment;                              // MuJoCo raises smaller values
  Number total_mass;                                            // if positive, MuJoCo scales all masses to it
  bool aligns_free_bodies = false;                              // with their principal axes, if they are alone
  Place alignment_place;                                        // of the attribute
  std::string mesh_folder;                                      // relative to that of the model
  bool strips_paths = false;                                    // of files of meshes
  bool has_exact_meshes = false;                                // by default
  Number first_group, last_group = Number(5.0);                 // of the geoms from which bodies take their mass

  bool scales_masses() const { return total_mass.value() > 0.0; }
  // Equalities and friction are constraints, too.
  bool has_equalities() const { return constraints && equalities; }
  bool has_friction() const { return constraints && friction; }
  // Converts an angle in the unit of the document to radians.
  Number angle(const Number& written) const { return degrees ? written * Number::pi_multiple(1, 180) : written; }
  // Warns about an angle in radians of this many turns or more, which is probably in degrees.
  void check_angle(const Number& written, double turns, const Place& place, Diagnostics& diagnostics) const;
};

// Later elements override earlier ones. Reports malformed values and global coordinates, which are not
// supported. Notes or warns about gravity other than (0, 0, -9.81), forces of a medium, and flags that
// disable forces other than those of constraints.
Settings read_settings(const Element& root, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
