// Any SDF: either it is refused with messages, or its robot can be written as a document and read back from there.
#include "import/sdf.h"
#include "export/kinematics.h"
#include "import/kinematics.h"
#include "survives_printing.h"

namespace robcogen::fuzz {
namespace {

void check_sdf(const std::string& text) {
  // Every combination of options, chosen by the length of the text.
  import::SdfOptions options;
  options.snap_angles = text.size() / 2 % 2 != 0;
  options.free_mimic_joints = text.size() / 4 % 2 != 0;

  Diagnostics diagnostics;
  const auto robot = import::sdf(std::make_shared<Source>("fuzz", text), "no_folder/fuzz", options, diagnostics);
  const std::string messages = diagnostics.render();
  require(messages.empty() == diagnostics.all().empty(), "messages and diagnostics differ", messages);
  require(robot.has_value() != diagnostics.has_errors(), "neither a robot nor an error, or both", messages);
  if (!robot) return;

  Diagnostics of_document;
  const std::string document = print(exporting::kinematics_document(robot->tree));
  const auto again = import::kinematic_tree(
      language::kinematics::parse(std::make_shared<Source>("print", document), of_document), of_document);
  require(again.has_value(), "the robot's document is refused", document + of_document.render());
  require(again->dof() == robot->tree.dof(), "the robot's document is another robot", document);
}

}  // namespace
}  // namespace robcogen::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  robcogen::fuzz::check_sdf(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
