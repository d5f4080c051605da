// The part of <name>/types.h for the sines and cosines of all joints: a value that functions take in the place of q.
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

// A constructor with these arguments, and the names of those that the kernel reads.
std::string constructor(
    const Api& api,
    const std::string& explicitly,
    std::vector<std::string> arguments,
    const std::string& kernel,
    const std::vector<std::string>& read) {
  std::vector<std::string> inputs;
  if (api.is_parametric()) {
    arguments.insert(arguments.begin(), std::string("const ") + kParametersType + "& parameters");
    inputs.push_back("parameters.data()");
  }
  for (const std::string& array : read) inputs.push_back(array + ".data()");
  inputs.insert(inputs.end(), {"sin_.data()", "cos_.data()"});
  const std::string type = "Basic" + std::string(kTrigonometryType);
  const std::string initializer = " noexcept : q_(q) {";
  std::string head = declaration(explicitly + type, arguments, initializer, 2);
  if (head.find('\n') + 1 < head.size()) head.replace(head.size() - initializer.size() - 1, 11, " noexcept\n      :");
  return head + call("kernel::" + kernel, inputs, 4) + "  }\n";
}

std::string class_of(const Api& api) {
  const std::string type = kTrigonometryType, size = std::to_string(api.library->trigonometry->angle_count);
  const auto vector = [](const std::string& name) { return "const JointVector<Scalar>& " + name; };
  const auto getter = [](const std::string& name, const std::string& array) {
    return "  JointVector<Scalar> " + name + "() const noexcept { return Eigen::Map<const JointVector<Scalar>>(" +
           array + ".data()); }\n";
  };
  const std::vector<std::string> parts = {
      "  // Computes all sines and cosines.\n" +
          constructor(api, "explicit ", {vector("q")}, "joint_trigonometry", {"q"}),
      "  // Takes the sine and cosine of each joint. Elements of prismatic joints are not read.\n" +
          constructor(
              api, "", {vector("q"), vector("sin_q"), vector("cos_q")}, api.trigonometry.front().kernel,
              {"sin_q", "cos_q"}),
      "  const JointVector<Scalar>& q() const noexcept { return q_; }\n" + getter("sin_q", "sin_") +
          getter("cos_q", "cos_"),
      "  // In the layout that kernels take: of the joints, then of sums of joint angles.\n"
      "  const Scalar* sin_data() const noexcept { return sin_.data(); }\n"
      "  const Scalar* cos_data() const noexcept { return cos_.data(); }\n"};
  return "template <class Scalar>\nclass ROBCOGEN_ALIGNED Basic" + type + " {\n public:\n" + paragraphs(parts) +
         "\n private:\n  JointVector<Scalar> q_;\n  std::array<Scalar, " + size + "> sin_;\n  std::array<Scalar, " +
         size + "> cos_;\n};\n";
}

}  // namespace

std::string trigonometry_type(const Api& api) {
  if (!api.takes_sines()) return "";
  const std::string stale =
      api.is_parametric() ? " It depends on the parameters: construct another one when they change." : "";
  return comment(
             "Joint positions (rad, m) with their sines and cosines. Every function of q also takes this in place of "
             "q: computed once per state, it serves all functions." +
             stale) +
         class_of(api);
}

}  // namespace robcogen::backend::cpp
