#include "import/sdf/elements.h"

#include <algorithm>
#include <vector>

#include "support/words.h"

namespace robcogen::import::from_sdf {

namespace {

struct Row {
  const char* kind;
  const char* attributes;
  const char* children;
  const char* without_effect;
};

constexpr Row kRows[] = {
    {"sdf", "version", "model world", "light actor"},
    {"world", "name", "model include joint frame gravity",
     "actor atmosphere audio gui light magnetic_field physics plugin population road scene spherical_coordinates state "
     "wind"},
    {"model", "canonical_link name namespace placement_frame", "frame include joint link model pose static",
     "allow_auto_disable drake:collision_filter_group enable_wind gripper joint_state model_state plugin self_collide"},
    {"include", "merge", "name placement_frame pose static uri", "model_state namespace plugin"},
    {"frame", "attached_to name", "pose", ""},
    {"pose", "degrees frame relative_to rotation_format", "", ""},
    {"inertial/pose", "degrees rotation_format", "", ""},
    {"link", "name", "gravity inertial kinematic pose velocity_decay",
     "audio_sink audio_source battery collision enable_wind light must_be_base_link particle_emitter plugin projector "
     "self_collide sensor visual"},
    {"inertial", "auto", "fluid_added_mass inertia mass pose", "auto_inertia_params density"},
    {"inertia", "", "ixx ixy ixz iyy iyz izz", ""},
    {"joint", "name type",
     "axis axis2 child drake:gear_ratio drake:rotor_inertia gearbox_ratio gearbox_reference_body parent pose "
     "screw_thread_pitch thread_pitch",
     "drake:controller_gains physics plugin sensor"},
    {"axis", "", "dynamics limit mimic use_parent_model_frame xyz", "initial_position"},
    {"xyz", "expressed_in", "", ""},
    {"limit", "", "effort lower upper velocity", "dissipation drake:acceleration drake:jerk stiffness"},
    {"dynamics", "", "damping friction spring_reference spring_stiffness", ""},
    {"mimic", "axis joint", "multiplier offset reference", ""},
    {"velocity_decay", "", "angular linear", ""},
};

// Parts of the names of plugins, in lower case without `-` and `_`.
constexpr const char* kPluginsWithForces =
    "addedmass buoyan drag hydrodynamic liftdrag mimic spring thruster wind wheelslip";
// Those of Gazebo and of ROS that control, sense and show.
constexpr const char* kPluginsWithoutEffect =
    "ackermann altimeter battery bumper camera contact control detachable diffdrive differential drive dvl effort "
    "forcetorque ft gimbal gps gripper ground imu joint jointstate label laser lidar logical mavlink magnetometer "
    "motor "
    "navsat odometry p3d pose projector publish range ray rgbd ros scene sensor servo skid sonar state thermal touch "
    "trajectory tricycle usercommands vacuum velocity video wheel";

xml::KnownElements table() {
  xml::KnownElements result;
  for (const Row& row : kRows)
    result[row.kind] = {words(row.attributes), {}, words(row.children), words(row.without_effect)};
  result["axis2"] = result["axis"];
  return result;
}

bool contains_any(const std::string& text, const std::vector<std::string>& parts) {
  return std::any_of(
      parts.begin(), parts.end(), [&](const std::string& part) { return text.find(part) != std::string::npos; });
}

}  // namespace

const KnownElement* known_element(const std::string& kind) {
  static const xml::KnownElements known = table();
  return xml::find(known, kind);
}

PluginEffect effect_of_plugin(const std::string& file, const std::string& name) {
  static const std::vector<std::string> forces = words(kPluginsWithForces), none = words(kPluginsWithoutEffect);
  std::string text = file + " " + name;
  std::erase_if(text, [](char c) { return c == '-' || c == '_'; });
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (contains_any(text, forces)) return PluginEffect::forces;
  return contains_any(text, none) ? PluginEffect::none : PluginEffect::unknown;
}

}  // namespace robcogen::import::from_sdf
