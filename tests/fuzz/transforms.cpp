// Any list of desired transforms, on a robot with the frames that the seeds often name: traced, through all passes, and
// into the interpreter.
#include <algorithm>

#include "algorithm/catalogue/catalogue.h"
#include "check.h"
#include "import/kinematics.h"

namespace robcogen::fuzz {
namespace {

const char* const kRobot = R"(
Robot HyL {
  RobotBase base {
    children { slider via SLIDE }
    frames { target { translation = (0.1, 0.2, 0.3) rotation = (0.4, 0.5, 0.6) } }
  }
  link slider {
    id = 1
    inertia_params { mass = 1.0 CoM = (0.1, 0.0, 0.0) Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { leg via HFE }
  }
  link leg {
    id = 2
    inertia_params { mass = 1.0 CoM = (0.0, 0.1, 0.0) Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.1 Ixz=0.0 Iyz=0.0 }
    children { }
    frames { foot { translation = (0.35, 0.0, 0.0) rotation = (0.0, PI/2.0, 0.0) } }
  }
  p_joint SLIDE { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
  r_joint HFE { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (PI/2.0, 0.0, 0.3) } }
})";

model::KinematicTree robot() {
  Diagnostics diagnostics;
  const auto text = std::make_shared<Source>("robot", std::string(kRobot));
  const auto tree = import::kinematic_tree(language::kinematics::parse(text, diagnostics), diagnostics);
  require(tree.has_value(), "the robot is refused", diagnostics.render());
  return *tree;
}

// True if the list refers to things that must exist: contacts, chains, functions, instances of parts.
bool asks_by_name(const language::desired::Document& document) {
  const auto names_instance = [](const language::desired::Name& name) { return !name.instance.empty(); };
  const auto has_instance = [&](const language::desired::Pair& pair) {
    return names_instance(pair.left) || names_instance(pair.right);
  };
  return !document.contacts.empty() || !document.loops.empty() || !document.inverses.empty() ||
         !document.functions.empty() ||
         std::any_of(document.frames.begin(), document.frames.end(), names_instance) ||
         std::any_of(document.transforms.begin(), document.transforms.end(), has_instance) ||
         std::any_of(document.jacobians.begin(), document.jacobians.end(), has_instance);
}

void check_list(const std::shared_ptr<const Source>& text) {
  static const model::KinematicTree tree = robot();
  constexpr std::size_t kMaxPairs = 20;
  Diagnostics diagnostics;
  const language::desired::Document document = language::desired::parse(text, diagnostics);
  if (diagnostics.has_errors()) return;
  const model::DesiredTransforms desired = import::desired_transforms(document, tree, diagnostics);
  const std::string messages = diagnostics.render();
  // Transforms may be in a list for several robots, so missing ones cause only a warning.
  require(!diagnostics.has_errors() || asks_by_name(document), "what the robot lacks is more than a warning", messages);
  if (diagnostics.has_errors()) return;
  if (desired.transforms.size() + desired.jacobians.size() > kMaxPairs) return;
  for (const char* group : {"transforms", "jacobians"})
    for (const symbolic::Function& f : algorithm::functions(tree, desired, group))
      is_sound_through_passes(f.program);
}

}  // namespace
}  // namespace robcogen::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using robcogen::Source;
  robcogen::fuzz::check_list(std::make_shared<Source>("fuzz", std::string(reinterpret_cast<const char*>(data), size)));
  return 0;
}
