#include "algorithm/catalogue/phrases.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/kinematics/inverse_kinematics.h"
#include "algorithm/kinematics/loop_functions.h"
#include "model/loops.h"
#include "model/named_frame.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::algorithm::catalogue {
namespace {

using model::KinematicTree;

// `fr_LF_foot, fr_sole (surface)`
std::string contacts(const Subject& s) {
  std::vector<std::string> names;
  for (const model::ContactFrame& contact : s.contacts)
    names.push_back(contact.frame.name + (contact.is_surface ? " (surface)" : ""));
  return joined(names);
}

// `bar (5 rows), rod (1)`
std::string list_of_rows(const Subject& s) {
  std::string text;
  for (const model::LoopJoint& loop : s.tree.loops)
    text += (text.empty() ? "" : ", ") + loop.name + " (" + std::to_string(rows_of(loop.type)) +
            (text.empty() ? rows_of(loop.type) == 1 ? " row)" : " rows)" : ")");
  return text;
}

// `bar (3), rod (1)`
std::string forces_of_loops(const Subject& s) {
  const std::vector<int> counts = force_counts(s.tree);
  std::vector<std::string> loops;
  for (std::size_t k = 0; k < counts.size(); ++k)
    loops.push_back(s.tree.loops[k].name + " (" + std::to_string(counts[k]) + ")");
  return joined(loops);
}

template <bool only_declared>
std::string coupled_joints(const Subject& s) {
  std::vector<std::string> names;
  for (const model::Coupling& coupling : s.tree.couplings)
    if (!only_declared || is_declared(coupling)) names.push_back(s.tree.joints[at(coupling.joint)].name);
  return joined(names);
}

std::string chain_joints(const Subject& s) {
  std::vector<std::string> names;
  const std::vector<int> joints = s.tree.coordinates();
  for (const int coordinate : chain_coordinates(s.tree, s.frames))
    names.push_back(s.tree.joints[at(joints[at(coordinate)])].name);
  return joined(names);
}

std::string target_of_inverse(const Subject& s) {
  std::string text;
  switch (s.task.kind) {
    case model::InverseTask::Kind::pose:
      text = "{A}_X_{B}, the pose of {B} in {A}";
      break;
    case model::InverseTask::Kind::point:
      text = "the position p (m) of the origin of {B} in {A}";
      break;
    case model::InverseTask::Kind::orientation:
      text = "{A}_X_{B}, of which the orientation of {B} counts";
      break;
    case model::InverseTask::Kind::axis:
      text = "{A}_X_{B}, of which the origin and the z axis of {B} count";
      break;
  }
  if (s.task.by_swivel) text += "; `swivel` (rad) is as inverse_kinematics::redundancy returns it";
  if (s.task.given >= 0)
    text += "; joint " + s.tree.joints[at(s.task.given)].name + " keeps its position in `reference`";
  return filled(text, s);
}

std::string determinant_of_inverse(const Subject& s) {
  const InverseKinematicsSize size = inverse_kinematics_size(s.tree, s.frames, s.task);
  return std::string(
             size.has_determinant ? "that of the Jacobian, with the sign of the branch"
                                  : "the product of the roots of the equations: 0 where branches meet") +
         (size.newton_steps > 0 ? " (of the nominal chain)" : "");
}

std::string steps_of_inverse(const Subject& s) {
  std::string text = "Steps:";
  for (const std::string& step : inverse_kinematics_steps(s.tree, s.frames, s.task)) text += " " + step + ";";
  text.back() = '.';
  return text;
}

// The chapter of the chosen algorithm.
std::string source(const Subject& s) {
  if (!s.method) return "";
  return *s.method == ForwardDynamicsMethod::inertia_matrix ? " (Featherstone 2008, ch. 6)"
                                                            : " (Featherstone 2008, ch. 7)";
}

constexpr std::array kConditions = {
    std::pair<const char*, Condition>("floating", is_floating),
    std::pair<const char*, Condition>("fixed", is_fixed),
    std::pair<const char*, Condition>("external", takes_external),
    std::pair<const char*, Condition>("spherical", has_spherical_joints),
    std::pair<const char*, Condition>("no spherical", [](const Subject& s) { return !has_spherical_joints(s); }),
    std::pair<const char*, Condition>("coupled", [](const Subject& s) { return !s.tree.couplings.empty(); }),
    std::pair<const char*, Condition>("passive", [](const Subject& s) { return s.tree.uses_passive_forces; }),
    std::pair<const char*, Condition>("not passive", [](const Subject& s) { return !s.tree.uses_passive_forces; }),
    std::pair<const char*, Condition>("tendons", [](const Subject& s) { return !s.tree.tendons.empty(); }),
    std::pair<const char*, Condition>(
        "has passive forces",
        [](const Subject& s) {
          const auto is_passive = [](const model::Joint& joint) { return joint.drive.is_passive(); };
          const bool of_joints = std::any_of(s.tree.joints.begin(), s.tree.joints.end(), is_passive);
          return !s.tree.tendons.empty() || (s.tree.uses_passive_forces && of_joints);
        }),
    std::pair<const char*, Condition>("couplings", has_declared_couplings),
    std::pair<const char*, Condition>("free joints", lacks_inertia_with_cut_loops)};

struct Phrase {
  const char* name;
  std::string (*text)(const Subject&);
};

constexpr std::array kPhrases = {
    Phrase{"A", [](const Subject& s) { return s.frames.left.name; }},
    Phrase{"B", [](const Subject& s) { return s.frames.right.name; }},
    Phrase{
        "what moves", [](const Subject& s) { return std::string(is_floating(s) ? "the robot" : "the moving links"); }},
    Phrase{
        "accelerations",
        [](const Subject& s) { return std::string(is_floating(s) ? "(spatial base acceleration, qdd)" : "qdd"); }},
    Phrase{"source", source},
    Phrase{"contacts", contacts},
    Phrase{"coupled joints", coupled_joints<false>},
    Phrase{"declared couplings", coupled_joints<true>},
    Phrase{"rows of loops", list_of_rows},
    Phrase{"forces of loops", forces_of_loops},
    Phrase{"chain", chain_joints},
    Phrase{"target of inverse", target_of_inverse},
    Phrase{"determinant of inverse", determinant_of_inverse},
    Phrase{"steps of inverse", steps_of_inverse},
    Phrase{"actuators", [](const Subject& s) { return joined(model::names_of(s.tree.actuators)); }}};

std::string text_of(const std::string& placeholder, const Subject& subject) {
  const std::size_t mark = placeholder.find('?');
  if (mark == std::string::npos) {
    for (const Phrase& phrase : kPhrases)
      if (placeholder == phrase.name) return phrase.text(subject);
  } else {
    for (const auto& [name, is_met] : kConditions)
      if (placeholder.substr(0, mark) == name)
        return is_met(subject) ? filled(placeholder.substr(mark + 2), subject) : std::string();
  }
  throw std::logic_error("no phrase for {" + placeholder + "}");
}

// The place of the brace that closes the one at `open`.
std::size_t closing(const std::string& text, std::size_t open) {
  int depth = 0;
  std::size_t place = open;
  do {
    depth += text.at(place) == '{' ? 1 : text.at(place) == '}' ? -1 : 0;
    ++place;
  } while (depth > 0);
  return place - 1;
}

}  // namespace

std::string filled(const std::string& text, const Subject& subject) {
  std::string result;
  for (std::size_t place = 0; place < text.size(); ++place) {
    if (text[place] != '{') {
      result += text[place];
      continue;
    }
    const std::size_t end = closing(text, place);
    result += text_of(text.substr(place + 1, end - place - 1), subject);
    place = end;
  }
  return result;
}

}  // namespace robcogen::algorithm::catalogue
