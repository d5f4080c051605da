// <name>/kernel/<group>.h, which contains the text of the kernels.
#include <algorithm>
#include <optional>

#include "backend/common/cache.h"
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"
#include "backend/cpp/solve_columns.h"
#include "support/index.h"
#include "support/parallel.h"
#include "symbolic/cost.h"

namespace robcogen::backend::cpp {
namespace {

// The namespaces of kernels that are printed twice.
constexpr const char* kInLanes = "in_lanes";
constexpr const char* kOneByOne = "one_by_one";

std::string counts(const symbolic::Cost& c) {
  std::string result = std::to_string(c.mul) + " mul, " + std::to_string(c.add) + " add";
  const auto append = [&](int count, const char* what) {
    if (count) result += ", " + std::to_string(count) + " " + what;
  };
  append(c.div, "div");
  append(c.sqrt, "sqrt");
  append(c.sincos, "sincos");
  append(c.moves, "lane moves");
  if (c.instructions == 0) return result + ".";
  return result + ": " + std::to_string(c.instructions) + " instructions with fused multiply-add; critical path " +
         std::to_string(c.critical_path) + " cycles.";
}

std::string counts(const symbolic::Program& program) {
  return counts(symbolic::cost(program));
}

std::string using_declaration(const std::string& function) {
  const bool is_of_runtime = function == kArcTangent || function == kMagnitude;
  return "  using " + std::string(is_of_runtime ? "robcogen" : "std") + "::" + function + ";\n";
}

}  // namespace

std::string body(const Kernel& kernel) {
  std::string result;
  for (const int width : kernel.widths) result += "  using " + type(width) + " = " + lanes(width) + ";\n";
  if (!kernel.widths.empty() && kernel.functions.empty()) result += "\n";
  for (const std::string& function : kernel.functions) result += using_declaration(function);
  if (!kernel.functions.empty()) result += "\n";
  return result + backend::body(kernel, dialect());
}

namespace {

std::string definition(const Kernel& kernel, const std::string& specifiers = "") {
  const std::string head = specifiers + "void " + kernel.name;
  if (kernel.lines.empty()) return signature(head, kernel.parameters, " noexcept {}");
  return signature(head, kernel.parameters, " noexcept {") + body(kernel) + "}\n";
}

// The namespace of the parts of long kernels.
constexpr const char* kParts = "parts";

// Parts are not inlined: the compiler would merge them into their only caller and undo the split.
std::string print_parts(const SplitKernel& split, const std::string& name) {
  std::vector<std::string> list;
  for (const Kernel& part : split.parts) {
    const std::string number = std::to_string(list.size() + 1);
    list.push_back(
        comment("Part " + number + " of " + std::to_string(split.parts.size()) + " of " + name + ".") +
        definition(part, "[[gnu::noinline]] "));
  }
  return in_namespace(kParts, paragraphs(list));
}

// The kernel that calls the parts.
std::string definition(const Kernel& kernel, const SplitKernel& split) {
  std::string text = signature("void " + kernel.name, kernel.parameters, " noexcept {");
  for (const LiveValues& live : split.live)
    text += "  " + type_of(live.array) + " " + live.array.name + "[" + std::to_string(live.size) + "];\n";
  for (const Kernel& part : split.parts)
    text += call(kParts + ("::" + part.name) + "<Scalar>", names_of(part.parameters), 2);
  return text + "}\n";
}

// The kernel after these comments, preceded by its parts if it is long.
std::string print_whole_or_parts(const std::string& comments, const Kernel& kernel) {
  if (!is_long(kernel, dialect())) return comments + definition(kernel);
  const SplitKernel split = split_kernel(kernel, dialect());
  return paragraphs({print_parts(split, kernel.name), comments + definition(kernel, split)});
}

// `0:HAA, 1:HFE`
std::string numbered(const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) result += (i ? ", " : "") + std::to_string(i) + ":" + names[i];
  return result.empty() ? "none" : result;
}

// The elements of a kernel's arrays, if they differ between functions.
std::string arrays(const Library& library, const symbolic::Program& program) {
  if (library.has_robot()) return "";
  std::string result;
  for (const symbolic::InputArray& input : program.inputs)
    result += comment(input.name + ": " + numbered(input.elements) + ".");
  return result;
}

std::string summary(const Callable& callable) {
  const Function& function = *callable.function;
  std::string result = comment(function.summary);
  if (!function.method.empty()) result += comment(function.method);
  // The rounding error of a transform, which is only a few products, is of no interest.
  if (function.error && function.group != "transforms")
    result += comment(
        "Rounding errors: " + symbolic::print(*function.error) + ", in units of the rounding error of one operation.");
  return result;
}

// The specifiers of functions that are compiled into their caller.
constexpr const char* kInline = "[[gnu::always_inline]] inline ";

// The comments on a kernel whose limbs share lanes.
std::string comments_in_lanes(const Callable& callable) {
  std::string text;
  for (const std::string& limbs : callable.function->limbs_in_lanes)
    text += comment("In lanes: the limbs that start with joints " + limbs + ".");
  return text + comment("Where limbs are mirrored, some lanes of a value are negated.");
}

// The function that chooses between the two kernels.
std::string print_chooser(
    const Callable& callable,
    const std::vector<KernelArray>& parameters,
    const std::string& specifiers = "") {
  const std::vector<std::string> names = names_of(parameters);
  const auto call_in = [&](const char* space) { return call(space + ("::" + callable.kernel), names, 4); };
  return signature(specifiers + "void " + callable.kernel, parameters, " noexcept {") +
         "  if constexpr (robcogen::kPrefersLanes<Scalar>) {\n" + call_in(kInLanes) + "  } else {\n" +
         call_in(kOneByOne) + "  }\n}\n";
}

// The same if the kernel in lanes is for small angles only.
std::string print_chooser_of_small_angles(const Callable& callable) {
  const std::vector<std::string> names = names_of(callable.parameters);
  const std::vector<symbolic::InputArray>& inputs = callable.function->program.inputs;
  const auto q = std::find_if(inputs.begin(), inputs.end(), [](const symbolic::InputArray& array) {
    return array.role == symbolic::Role::joint_position;
  });
  const std::string& name = names[static_cast<std::size_t>(q - inputs.begin())];
  const auto call_in = [&](const char* space, std::size_t indent) {
    return call(space + ("::" + callable.kernel), names, indent);
  };
  return signature("void " + callable.kernel, callable.parameters, " noexcept {") +
         "  if constexpr (robcogen::kPrefersLanes<Scalar>) {\n    if (robcogen::are_small<" +
         std::to_string(q->elements.size()) + ">(" + name + ")) {\n" + call_in(kInLanes, 6) +
         "      return;\n    }\n  }\n" + call_in(kOneByOne, 2) + "}\n";
}

// Both kernels of a function whose congruent limbs share lanes, and the function that chooses between them.
std::string print_both(
    const Callable& callable,
    const std::string& in_lanes,
    const std::string& one_by_one,
    const std::string& chooser) {
  return paragraphs(
      {in_namespace(kInLanes, in_lanes), in_namespace(kOneByOne, one_by_one), summary(callable) + chooser});
}

std::string print_core(const Callable& callable) {
  const auto& [program, in_lanes, read, angles] = *callable.function->core;
  const auto print = [&](const std::string& remarks, const symbolic::Program& printed, bool is_inline) {
    const Kernel kernel = lower(printed, callable.kernel);
    const std::string comments = remarks + comment(counts(printed));
    return is_inline ? comments + definition(kernel, kInline) : print_whole_or_parts(comments, kernel);
  };
  const symbolic::KernelForm& form = callable.function->form;
  if (!in_lanes) return print(summary(callable), program, form.inlines_core);
  return print_both(
      callable, print(comments_in_lanes(callable), *in_lanes, form.inlines_core_in_lanes),
      print("", program, form.inlines_core), print_chooser(callable, callable.core_parameters, kInline));
}

// Computes the sines and cosines of these angles, each into its element of sin_q and cos_q, by functions of this
// namespace.
std::string sines_and_cosines(
    const Library& library,
    const std::vector<int>& read,
    const symbolic::Program& angles,
    const std::string& space) {
  if (read.empty()) return "";
  std::vector<std::string> places;
  for (const int k : read) places.push_back(std::to_string(k));
  if (read.back() >= library.tree.dof()) {
    const Kernel kernel = lower_values(angles);
    return body(kernel) + numbered_list("const Scalar angles[]", kernel.results.front(), 2) +
           template_call(space + "::sincos_to", places, "(angles, sin_q, cos_q)", 2);
  }
  if (!symbolic::are_together(read)) return template_call(space + "::sincos_at", places, "(q, sin_q, cos_q)", 2);
  const int first = read.front(), count = read.back() - first + 1;
  const auto from = [&](const std::string& array) {
    return first == 0 ? array : array + " + " + std::to_string(first);
  };
  const std::string name = space + "::sincos_of<" + std::to_string(count) + ">";
  return call(name, {from("q"), from("sin_q"), from("cos_q")}, 2);
}

// A kernel that computes sines and cosines and calls its core.
std::string print_caller(const Library& library, const Callable& callable) {
  const symbolic::Core& core = *callable.function->core;
  std::string text = comment("Computes sines and cosines of the positions, then calls core::" + callable.kernel + ".") +
                     comment(counts(callable.count));
  const bool is_in_lanes = callable.function->in_lanes && !callable.function->form.has_own_lanes;
  if (is_in_lanes) text += comment("In lanes: " + counts(*callable.function->in_lanes));
  if (const int sums = symbolic::cost(core.angles).add; sums > 0)
    text += comment("Additions for sums of angles: " + std::to_string(sums) + ".");
  text += signature("void " + callable.kernel, callable.parameters, " noexcept {");
  const std::string size = std::to_string(library.trigonometry->angle_count);
  // The arrays are stored as vectors and read one by one: a load from a vector across two cache lines would stall.
  text += (is_in_lanes ? "  alignas(64) Scalar sin_q[" : "  Scalar sin_q[") + size + "], cos_q[" + size + "];\n";
  text += sines_and_cosines(
      library, core.read, core.angles, callable.function->form.calls_sines ? "robcogen::called" : "robcogen");
  return text + call("core::" + callable.kernel, names_of(callable.core_parameters), 2) + "}\n";
}

// The kernel without lanes, after these comments.
std::string print_one_by_one(const Library& library, const Callable& callable, const std::string& comments = "") {
  if (callable.function->core) return comments + print_caller(library, callable);
  const symbolic::Program& program = callable.function->program;
  return print_whole_or_parts(
      comments + comment(counts(callable.count)) + arrays(library, program), lower(program, callable.kernel));
}

// A kernel that calls a function of the right-hand sides, and solves for them column by column.
std::string print_solver(const Callable& callable) {
  return summary(callable) + signature("void " + callable.kernel, callable.parameters, " noexcept {") +
         solve_columns(callable) + "}\n";
}

// The functions with which these kernels solve for one column. Overloads share them.
std::string print_solutions(const std::vector<const Callable*>& callables) {
  std::vector<std::string> names, texts;
  for (const Callable* c : callables) {
    if (!c->function->solved) continue;
    const symbolic::Program& solution = c->function->solved->solution;
    if (std::find(names.begin(), names.end(), solution.name) != names.end()) continue;
    const auto& limbs = c->function->solved->limbs;
    names.push_back(solution.name);
    texts.push_back(
        comment("Solves for one column of the results of " + c->name + ".") + comment(counts(solution)) +
        definition(lower(solution, solution.name)));
    if (!limbs) continue;
    texts.push_back(
        comment("Solves for one column per limb, one limb per lane: `own` and `b` are those of the lane's limb, and "
                "`is_limb` is 1 for this limb.") +
        comment(counts(limbs->solution)) + definition(lower(limbs->solution, limbs->solution.name)));
  }
  return paragraphs(texts);
}

std::string print_kernel(const Library& library, const Callable& callable) {
  const Function& function = *callable.function;
  if (function.solved) return print_solver(callable);
  if (!function.form.has_own_lanes) return print_one_by_one(library, callable, function.core ? "" : summary(callable));
  const symbolic::Program& program = *function.in_lanes;
  const Kernel kernel = lower(program, callable.kernel);
  const std::string comments = comments_in_lanes(callable) + comment(counts(program));
  const std::string one_by_one = print_one_by_one(library, callable);
  if (function.form.has_small_angles && !is_long(kernel, dialect()))
    if (const std::optional<Kernel> small = of_small_angles(kernel))
      return print_both(
          callable, comments + definition(*small, kInline), one_by_one, print_chooser_of_small_angles(callable));
  return print_both(
      callable, print_whole_or_parts(comments, kernel), one_by_one, print_chooser(callable, callable.parameters));
}

// The sines and cosines of all angles. For prismatic joints these are the sine and cosine of zero.
std::string print_joint_trigonometry(const Library& library) {
  symbolic::Program angles = library.trigonometry->angles;
  const std::vector<int> joints = library.tree.coordinates();
  std::vector<symbolic::Operand> values;
  std::vector<int> turning;
  std::string rest;
  for (int k = 0; k < library.trigonometry->angle_count; ++k) {
    const auto index = static_cast<std::size_t>(k);
    if (index < joints.size() && !model::turns(library.tree.joints[at(joints[index])].type)) {
      const std::string place = "[" + std::to_string(k) + "] = ";
      rest += "  sin_q" + place + "Scalar(0.0);\n  cos_q" + place + "Scalar(1.0);\n";
      continue;
    }
    turning.push_back(k);
    values.push_back(angles.outputs.front().values[index]);
  }
  angles.outputs.front().rows = static_cast<int>(values.size());
  angles.outputs.front().values = values;
  std::vector<KernelArray> list = lower_values(angles).parameters;
  list.back() = {"sin_q", true, library.trigonometry->angle_count > 0};
  list.push_back({"cos_q", true, library.trigonometry->angle_count > 0});
  const std::string body = sines_and_cosines(library, turning, angles, "robcogen") + rest;
  return comment(
             "Sines and cosines of all angles: of the joints, then of sums of joint angles. For prismatic joints they "
             "are sin(0) and cos(0).") +
         signature("void joint_trigonometry", list, body.empty() ? " noexcept {}" : " noexcept {") +
         (body.empty() ? "" : body + "}\n");
}

// The conventions that hold for all kernels.
std::string conventions(const Library& library) {
  const std::string overlap = "Outputs must not overlap inputs.";
  if (!library.has_robot()) return overlap;
  return overlap + " Joints: " + numbered(model::names_of(library.tree, library.tree.coordinates())) + ".";
}

// The legend of the names of values, for kernels of the dynamics.
std::string legend(const std::string& group) {
  if (is_kinematics(group) || group == kParameters || group == kTrigonometry) return "";
  const std::string text = comment(
      "Names consist of link, quantity and axis. w, wd: angular velocity and acceleration; v: velocity; a: "
      "acceleration of the link's origin minus gravity; f, n: force and moment; h, S: first and second moments of "
      "mass; A, B, M: blocks of an articulated inertia; U: elements of [wd]x + [w]x [w]x. _P: in the parent's axes; "
      "_neg: negated; _by_J: rotated by joint J; s2_J, sc_J, c_2J: sin^2, sin cos, cosine of twice its angle; x_to_y: "
      "partial sum of x, up to its term in y.");
  return "//\n" + text;
}

// One function that makes all three updates.
std::string whole_update(const Api& api) {
  std::string result =
      "// Computes the whole cache from values in the order of kParameterNames. For scalar types that Parameters does "
      "not\n// support.\n"
      "template <class Scalar>\nvoid update(const Scalar* parameters, Scalar* cache) noexcept {\n";
  const std::vector<CachePart> parts = cache_parts(*api.library);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const int begin = parts[k].begin;
    const std::string part = begin == 0 ? "cache" : "cache + " + std::to_string(begin);
    result += "  " + api.updates[k].kernel + "(parameters, " + part + ");\n";
  }
  return result + "}\n";
}

}  // namespace

std::string print_kernels(const Api& api, const std::string& group, const std::string& path) {
  if (group == kParameters && !api.is_parametric())
    return paragraphs(
        {banner(*api.library, path, "no kernels, because the robot has no parameters"), "#pragma once\n"});
  if (group == kTrigonometry && !api.takes_sines())
    return paragraphs({banner(*api.library, path, "no kernels for sines and cosines"), "#pragma once\n"});
  const std::vector<const Callable*> callables = kernels_of(api, group);
  const bool has_lanes = std::any_of(
      callables.begin(), callables.end(), [](const Callable* c) { return c->function->in_lanes.has_value(); });
  const bool solves = std::any_of(
      callables.begin(), callables.end(), [](const Callable* c) { return c->function->solved.has_value(); });
  std::vector<std::string> cores(callables.size()), kernels(callables.size());
  for_each_index(callables.size(), [&](std::size_t i) {
    if (callables[i]->function->core) cores[i] = print_core(*callables[i]);
    kernels[i] = print_kernel(*api.library, *callables[i]);
  });
  if (solves) kernels.insert(kernels.begin(), print_solutions(callables));
  std::erase(cores, std::string());  // cores that read no angles
  if (group == kParameters) kernels.push_back(whole_update(api));
  if (group == kTrigonometry) kernels.push_back(print_joint_trigonometry(*api.library));
  std::vector<std::string> headers = {"\"robcogen/sincos_of.h\"", "\"robcogen/version.h\""};
  if (has_lanes) headers.insert(headers.begin(), "\"robcogen/lane_blocks.h\"");
  if (solves) headers.insert(headers.begin(), "\"robcogen/column_solver.h\"");
  for (const char* function : {kMagnitude, kArcTangent}) {
    const auto calls_it = [function, declared = using_declaration(function)](const std::string& text) {
      const bool calls_together = function == kArcTangent && text.find(kArcTangents) != std::string::npos;
      return calls_together || text.find(declared) != std::string::npos;
    };
    if (std::any_of(cores.begin(), cores.end(), calls_it) || std::any_of(kernels.begin(), kernels.end(), calls_it))
      headers.push_back("\"robcogen/" + std::string(function) + ".h\"");
  }
  const std::string remark =
      "// Kernels that take precomputed sin(q) and cos(q), in the layout of joint_trigonometry.\n";
  if (!cores.empty()) kernels.insert(kernels.begin(), remark + in_namespace("core", paragraphs(cores)));
  return paragraphs(
      {banner(*api.library, path, "kernels for any scalar type, without Eigen") + comment(conventions(*api.library)) +
           (api.library->has_robot() ? legend(group) : ""),
       "#pragma once\n", includes({"<cmath>"}), includes(headers), runtime_check(api),
       in_namespace(api.space + "::kernel", paragraphs(kernels))});
}

}  // namespace robcogen::backend::cpp
