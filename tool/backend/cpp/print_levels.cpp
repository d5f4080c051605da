// <name>/<group>.cpp, if the kernels of a group are compiled for several processors, and
// <name>/kernels_<level>_<part>.cpp, which compile the kernels of all groups for one processor level. A program chooses
// the level when it starts.
#include <algorithm>
#include <array>
#include <utility>

#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

// The namespace around the unnamed one into which the kernels are included. Code that is compiled for one processor
// then has no name under which the linker could take it for the code of another.
constexpr const char* kAround = "robcogen_level";

// The highest level that is expected to be faster; AVX2 for the sines and cosines of all joints.
symbolic::Level highest_level(const CompiledKernel& kernel) {
  return kernel.callable == nullptr ? symbolic::Level::avx2 : kernel.callable->function->form.level;
}

bool gains(const CompiledKernel& kernel) {
  return highest_level(kernel) != symbolic::Level::baseline;
}

// The kernels of which a program chooses a version.
std::vector<CompiledKernel> chosen(const Api& api, const std::string& group) {
  std::vector<CompiledKernel> result = compiled_kernels(api, group);
  std::erase_if(result, [](const CompiledKernel& k) { return !gains(k); });
  return result;
}

// Those that are compiled for this level. All are for the lowest of a library.
std::vector<CompiledKernel> compiled_for(const Api& api, const std::string& level, const std::string& group) {
  std::vector<CompiledKernel> result = chosen(api, group);
  if (level == api.library->levels.front()) return result;
  const auto rank = std::find(std::begin(kLevels), std::end(kLevels), level) - std::begin(kLevels);
  std::erase_if(result, [&](const CompiledKernel& k) { return static_cast<std::ptrdiff_t>(highest_level(k)) < rank; });
  return result;
}

// The texts that `print` makes of the kernels, with those of `core` in that namespace.
template <class Print>
std::string in_their_namespaces(const std::vector<CompiledKernel>& kernels, Print print) {
  std::vector<std::string> cores, others;
  for (const CompiledKernel& k : kernels) (k.is_core ? cores : others).push_back(print(k));
  return paragraphs({in_namespace("core", paragraphs(cores)), paragraphs(others)});
}

// A kernel that passes its arguments to the same kernel in `space`.
std::string forwarder(const CompiledKernel& kernel, const std::string& space) {
  return signature("void " + kernel.name, kernel.parameters, " noexcept {") +
         call(space + "::" + qualified(kernel) + "<Scalar>", names_of(kernel.parameters), 2) + "}\n";
}

// Includes the text of the kernels for this translation unit alone. The headers that they need are included before.
std::string own_kernels(const Api& api, const std::vector<std::string>& groups) {
  std::vector<std::string> files;
  for (const std::string& group : groups) files.push_back("\"" + kernel_path(folder(*api.library), group) + "\"");
  return in_namespace(kAround, "namespace {\n" + includes(files) + "}  // namespace\n");
}

// Whether kernels may call a function of <robcogen/magnitude.h>.
bool is_root_of_square(const std::vector<symbolic::Statement>& statements, const symbolic::Statement& s) {
  if (s.op != symbolic::Op::square_root || s.a.kind != symbolic::Operand::Kind::statement) return false;
  const symbolic::Statement& square = statements[static_cast<std::size_t>(s.a.index)];
  return square.op == symbolic::Op::multiply && square.a == square.b;
}

template <class Condition>
bool has(const Api& api, const Condition& is) {
  return std::any_of(api.callables.begin(), api.callables.end(), [&](const Callable& c) {
    const std::vector<symbolic::Statement>& statements = c.function->program.statements;
    return std::any_of(
        statements.begin(), statements.end(), [&](const symbolic::Statement& s) { return is(statements, s); });
  });
}

std::string includes_of_kernels(const Api& api, const std::vector<std::string>& more) {
  std::vector<std::string> headers = {
      "\"robcogen/lane_blocks.h\"", "\"robcogen/level.h\"", "\"robcogen/sincos_of.h\"", "\"robcogen/version.h\""};
  if (!api.right_sides.empty()) headers.insert(headers.begin(), "\"robcogen/column_solver.h\"");
  const auto is_arc_tangent = [](const auto&, const symbolic::Statement& s) {
    return s.op == symbolic::Op::arc_tangent;
  };
  if (has(api, is_arc_tangent)) headers.emplace_back("\"robcogen/arc_tangent.h\"");
  if (has(api, is_root_of_square)) headers.emplace_back("\"robcogen/magnitude.h\"");
  headers.insert(headers.end(), more.begin(), more.end());
  return paragraphs({includes({"<cmath>"}), includes(headers)});
}

std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// Compiles the text only if the build has the translation units of this level.
std::string if_compiled(const std::string& level, const std::string& text) {
  return "#ifdef ROBCOGEN_WITH_" + upper_case(level) + "\n" + text + "#endif\n";
}

// The name of the function that sets all pointers to the kernels of a level. Like all names that are local to a
// translation unit, it contains the group, because unity builds compile several units at once.
std::string name_of_setter(const std::string& group, const std::string& level) {
  return "use_" + level + "_" + group;
}

std::string setter(const std::vector<CompiledKernel>& kernels, const std::string& group, const std::string& level) {
  std::string text = "template <class Scalar>\nvoid " + name_of_setter(group, level) + "() noexcept {\n";
  for (const CompiledKernel& k : kernels) {
    const std::string name = "chosen::" + qualified(k) + "<Scalar> =",
                      value = "&" + level + "::" + qualified(k) + "<Scalar>;";
    const bool fits = name.size() + value.size() + 3 <= kColumns;
    text += "  " + name + (fits ? " " : "\n      ") + value + "\n";
  }
  return text + "}\n";
}

// The levels that kernels of the group are compiled for.
std::vector<std::string> levels_of(const Api& api, const std::string& group) {
  std::vector<std::string> levels = api.library->levels;
  std::erase_if(levels, [&](const std::string& level) { return compiled_for(api, level, group).empty(); });
  return levels;
}

// The function `levels::<group>`, and its call before main.
std::string choice(const Api& api, const std::string& group) {
  std::string body = "  [[maybe_unused]] const robcogen::Level level = robcogen::available(most);\n";
  const auto use = [&](const std::string& level, const std::string& indent) {
    const std::string name = indent + name_of_setter(group, level);
    std::string uses;
    for (const std::string& scalar : api.scalars()) uses += name + "<" + scalar + ">();\n";
    return uses;
  };
  // The highest level comes last and prevails.
  body += use(kLevels[0], "  ");
  for (const std::string& level : levels_of(api, group))
    body += if_compiled(level, "  if (level >= robcogen::Level::" + level + ") {\n" + use(level, "    ") + "  }\n");
  const std::string function = "void " + group + "(robcogen::Level most) noexcept {\n" + body + "}\n";
  return paragraphs(
      {in_namespace("levels", function),
       "namespace {\n\n// Runs before objects of static storage duration are constructed, because their constructors "
       "may call kernels.\n"
       "[[gnu::constructor(101)]] void choose_" +
           group + "() noexcept {\n  __builtin_cpu_init();\n  levels::" + group +
           "(robcogen::Level::avx512);\n}\n\n}  // namespace\n"});
}

std::string baseline_of(const Api& api) {
  return std::string("::") + kAround + "::" + api.space + "::kernel";
}

// The pointers to the kernels in use, and the kernels that call through them.
std::string chosen_kernels(const Api& api, const std::string& group) {
  const std::vector<CompiledKernel> kernels = chosen(api, group);
  const std::string pointers = in_their_namespaces(kernels, [](const CompiledKernel& k) {
    const std::string head = "auto* " + k.name + " =", value = "&baseline::" + qualified(k) + "<Scalar>;";
    const bool fits = head.size() + value.size() + 1 <= kColumns;
    return "template <class Scalar>\n" + head + (fits ? " " : "\n    ") + value + "\n";
  });
  std::vector<std::string> setters = {setter(kernels, group, kLevels[0])};
  std::string declarations;
  for (const std::string& level : levels_of(api, group)) {
    const std::vector<CompiledKernel> compiled = compiled_for(api, level, group);
    setters.push_back(if_compiled(level, setter(compiled, group, level)));
    declarations += if_compiled(level, in_namespace(level, in_their_namespaces(compiled, [](const CompiledKernel& k) {
                                                      return signature("void " + k.name, k.parameters, " noexcept;");
                                                    })));
  }
  const std::string forwarders = in_their_namespaces(compiled_kernels(api, group), [](const CompiledKernel& k) {
    return forwarder(k, gains(k) ? "chosen" : "baseline");
  });
  const std::string own = paragraphs(
      {"namespace baseline = " + baseline_of(api) + ";\n",
       "// The kernels in use.\n" + in_namespace("chosen", pointers), paragraphs(setters)});
  return in_namespace(
      api.space + "::kernel",
      paragraphs({declarations, "namespace {\n\n" + own + "\n}  // namespace\n", forwarders, choice(api, group)}));
}

// The groups of a part of a level: about as many statements as in the other parts.
std::vector<std::string> groups_in(const Api& api, const std::string& level, int part) {
  std::vector<std::pair<std::size_t, std::string>> sizes;
  for (const std::string& group : groups_with_levels(api)) {
    const std::vector<CompiledKernel> kernels = compiled_for(api, level, group);
    if (kernels.empty()) continue;
    std::size_t size = 0;
    for (const CompiledKernel& k : kernels)
      if (k.callable) size += k.callable->function->program.statements.size();
    sizes.emplace_back(size, group);
  }
  std::stable_sort(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::array<std::size_t, kLevelParts> sums = {};
  std::vector<std::string> result;
  for (const auto& [size, group] : sizes) {
    const auto shortest = std::min_element(sums.begin(), sums.end());
    *shortest += size;
    if (shortest - sums.begin() == part - 1) result.push_back(group);
  }
  return result;
}

}  // namespace

bool chooses_level(const Api& api, const std::string& group) {
  return !api.library->levels.empty() && !chosen(api, group).empty();
}

std::vector<std::string> groups_with_levels(const Api& api) {
  std::vector<std::string> groups = {kParameters, kTrigonometry};
  groups.insert(groups.end(), api.library->groups.begin(), api.library->groups.end());
  std::erase_if(groups, [&](const std::string& group) { return !chooses_level(api, group); });
  return groups;
}

std::string print_choice(const Api& api, const std::string& group, const std::string& path) {
  const std::string name = folder(*api.library);
  const std::string nothing_to_choose =
      in_namespace(api.space + "::kernel::levels", "void " + group + "(robcogen::Level) noexcept {}\n");
  return paragraphs(
      {banner(
           *api.library, path,
           "kernels compiled for " + api.scalars_in_words() + ", and their selection for the processor"),
       includes_of_kernels(api, {"\"" + kernels_path(name) + "\""}), "#if ROBCOGEN_CHOOSES_LEVEL\n",
       own_kernels(api, {group}), chosen_kernels(api, group), "#else  // ROBCOGEN_CHOOSES_LEVEL\n",
       includes({"\"" + kernel_path(name, group) + "\""}), nothing_to_choose, "#endif  // ROBCOGEN_CHOOSES_LEVEL\n",
       instantiations(api, group)});
}

std::string print_level(const Api& api, const std::string& level, int part, const std::string& path) {
  const std::string guard = "#if ROBCOGEN_HAS_LEVELS && defined(ROBCOGEN_WITH_" + upper_case(level) + ")\n";
  const std::vector<std::string> groups = groups_in(api, level, part);
  const std::string head = banner(*api.library, path, "kernels for one processor level");
  if (groups.empty()) return paragraphs({head, "// No kernel is expected to gain.\n"});
  std::string instantiated;
  std::vector<CompiledKernel> kernels;
  for (const std::string& group : groups)
    for (const CompiledKernel& k : compiled_for(api, level, group)) {
      kernels.push_back(k);
      instantiated += explicit_instantiations(api, qualified(k));
    }
  const std::string forwarders =
      in_their_namespaces(kernels, [&](const CompiledKernel& k) { return forwarder(k, baseline_of(api)); });
  return paragraphs(
      {head, includes_of_kernels(api, {}), guard, own_kernels(api, groups),
       in_namespace(api.space + "::kernel::" + level, paragraphs({forwarders, instantiated})), "#endif\n"});
}

std::string use_level(const Api& api) {
  std::string declarations, calls;
  for (const std::string& group : groups_with_levels(api)) {
    declarations += "void " + group + "(robcogen::Level most) noexcept;\n";
    calls += "  kernel::levels::" + group + "(most);\n";
  }
  const std::string remark = comment(
      "Selects the kernels for this processor level, or for the highest one that the machine has and the library is "
      "compiled for, if that is lower. A program starts with the highest one. Results of levels differ by rounding. Do "
      "not call this while another thread calls a function of the robot.");
  const std::string function =
      "inline void use_level([[maybe_unused]] robcogen::Level most) noexcept {\n" + calls + "}\n";
  return paragraphs({in_namespace("kernel::levels", declarations), in_namespace("reflection", remark + function)});
}

}  // namespace robcogen::backend::cpp
