// Any robot document: from text to model, from model to programs, through all passes, and into the interpreter.
#include "algorithm/catalogue/catalogue.h"
#include "check.h"
#include "import/kinematics.h"

namespace robcogen::fuzz {
namespace {

// Larger robots take more time, and find nothing that these do not.
constexpr int kMaxJoints = 8;
constexpr std::size_t kMaxFrames = 30;

void check_robot(const std::shared_ptr<const Source>& text) {
  Diagnostics diagnostics;
  const language::kinematics::Document document = language::kinematics::parse(text, diagnostics);
  if (diagnostics.has_errors()) return;
  const std::optional<model::KinematicTree> tree = import::kinematic_tree(document, diagnostics);
  const std::string messages = diagnostics.render();
  require(tree.has_value() != diagnostics.has_errors(), "neither a robot nor an error, or both", messages);
  if (!tree || tree->dof() > kMaxJoints || tree->frames().size() > kMaxFrames) return;
  const model::DesiredTransforms desired = model::all_desired(*tree);
  for (const std::string& group : algorithm::groups())
    for (const symbolic::Function& f : algorithm::functions(*tree, desired, group))
      is_sound_through_passes(f.program);
}

}  // namespace
}  // namespace robcogen::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using robcogen::Source;
  robcogen::fuzz::check_robot(std::make_shared<Source>("fuzz", std::string(reinterpret_cast<const char*>(data), size)));
  return 0;
}
