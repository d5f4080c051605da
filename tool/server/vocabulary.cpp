#include "server/vocabulary.h"

#include <algorithm>
#include <set>

#include "language/desired/keywords.h"
#include "language/kinematics/keywords.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"

namespace robcogen::server {
namespace {

using driver::Language;
using Words = std::vector<std::string_view>;

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<BlockWords> blocks_of_robots() {
  const Words joints = {"r_joint", "p_joint", "h_joint", "c_joint", "u_joint", "planar_joint", "s_joint"};
  const Words placement = {"translation", "rotation"};
  const Words inertia = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame"};
  const Words drive = {"damping", "friction", "armature", "spring", "elastic", "rotor", "limits", "assembled"};
  const Words joint = {"id", "ref_frame"};
  return {
      {"", {"Robot", "Part", "import"}},
      {"Robot", Words{"RobotBase", "link", "couplings", "loops", "independent", "actuators", "tendons"} + joints},
      {"Part", Words{"root", "link", "couplings", "loops", "independent", "actuators", "tendons"} + joints},
      {"RobotBase", {"inertia_params", "children", "frames"}},
      {"link", {"id", "inertia_params", "children", "frames"}},
      {"inertia_params", inertia},
      {"inertia_properties", inertia},
      {"r_joint", joint + drive},
      {"p_joint", joint + drive},
      {"h_joint", joint + Words{"pitch"} + drive},
      {"c_joint", joint + Words{"slide", "turn"}},
      {"u_joint", joint + Words{"turn_x", "turn_z"}},
      {"planar_joint", joint + Words{"slide_x", "slide_y", "turn"}},
      {"s_joint", joint + Words{"damping", "armature", "limits"}},
      {"ref_frame", placement},
      {"at", placement},
      {"slide", drive},
      {"turn", drive},
      {"turn_x", drive},
      {"turn_z", drive},
      {"slide_x", drive},
      {"slide_y", drive},
      {"friction", {"force", "velocity"}},
      {"spring", {"stiffness", "rest"}},
      {"elastic", {"stiffness", "damping"}},
      {"rotor", {"inertia", "ratio", "axis", "carrier"}},
      {"limits", {"position", "velocity", "effort"}},
      // Blocks of names.
      {"children", {}},
      {"frames", {}},
      {"couplings", {"for"}},
      {"loops", {}},
      {"loop", {"frames", "type", "distance", "branch"}},
      {"independent", {}},
      {"actuators", {}},
      {"actuator", {"from", "to"}},
      {"tendons", {}},
      {"tendon", {"length", "stiffness", "damping", "rest"}},
      {"sense", {}}};
}

// Words other than those that begin an item.
const Words kOtherWordsOfRobots = {"as",    "at",    "mirrored", "x",    "y",        "z",
                                   "same",  "sense", "keep",     "base", "floating", "via",
                                   "point", "hinge", "slider",   "weld", "drawn",    "other"};

}  // namespace

const std::vector<BlockWords>& block_words(Language language) {
  static const std::vector<BlockWords> robots = blocks_of_robots();
  static const std::vector<BlockWords> lists = {
      {"", {"Robot", "Model", "Frames", "Transforms", "Jacobians", "Contacts", "InverseKinematics", "Functions"}},
      {"Frames", {"for"}},
      {"Transforms", {"base", "target", "left", "right", "left_frame", "right_frame", "for"}},
      {"Jacobians", {"base", "target", "left", "right", "left_frame", "right_frame", "for"}},
      {"Contacts", {"point", "surface", "for"}},
      {"InverseKinematics",
       {"base", "target", "left", "right", "left_frame", "right_frame", "point", "axis", "given", "swivel", "tolerance",
        "for"}},
      {"Functions", {}}};
  static const std::vector<BlockWords> motions = {
      {"", {"Model", "Params", "Frames", "Convention"}},
      {":", {"trx", "try", "trz", "rotx", "roty", "rotz"}},
      {"Convention", {"local", "fixed", "currentFrame", "fixedFrame"}},
      {"Frames", {}},
      {"Params", {}}};
  static const std::vector<BlockWords> transforms = {
      {"", {"Model", "Params", "Frames", "MovedFramePos", "TransformedFramePos"}},
      {"=", {"Tx", "Ty", "Tz", "Rx", "Ry", "Rz"}},
      {"MovedFramePos", {"left", "right"}},
      {"TransformedFramePos", {"left", "right"}},
      {"Frames", {}},
      {"Params", {}}};
  static const std::vector<BlockWords> none;
  switch (language) {
    case Language::robot:
      return robots;
    case Language::desired:
      return lists;
    case Language::motions:
      return motions;
    case Language::transforms:
      return transforms;
    default:
      return none;
  }
}

const std::vector<std::string_view>& words_of_block(Language language, std::string_view block) {
  static const Words none;
  for (const BlockWords& known : block_words(language))
    if (known.block == block) return known.words;
  return none;
}

const std::vector<std::string>& keywords(Language language) {
  static const std::vector<std::string> none;
  switch (language) {
    case Language::robot:
      return language::kinematics::keywords();
    case Language::desired:
      return language::desired::keywords();
    case Language::motions:
      return language::motion::keywords();
    case Language::transforms:
      return language::transforms::keywords();
    default:
      return none;
  }
}

std::vector<std::string> contextual_words(Language language) {
  std::set<std::string> words;
  for (const BlockWords& block : block_words(language)) words.insert(block.words.begin(), block.words.end());
  if (language == Language::robot) words.insert(kOtherWordsOfRobots.begin(), kOtherWordsOfRobots.end());
  if (language == Language::robot || language == Language::desired) words.insert("in");  // of a loop
  for (const std::string& keyword : keywords(language)) words.erase(keyword);
  return {words.begin(), words.end()};
}

}  // namespace robcogen::server
