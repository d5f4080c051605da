// Names, limits and parameters.
#include <algorithm>

#include "backend/c/printers.h"
#include "backend/common/constants.h"
#include "backend/common/layout.h"
#include "support/concat.h"

namespace robcogen::backend::c {
namespace {

// What model.c defines: `const double hyl_joint_lower[3]`, and its values.
struct Constant {
  std::string head;
  std::vector<std::string> values;
  std::string open = " = {";
};

// Lists of names end with a null pointer: a list of none is legal.
Constant constant(const Names& names, const Table& table) {
  std::vector<std::string> values;
  for (const std::string& text : table.texts) values.push_back(quoted(text));
  for (const double value : table.numbers) values.push_back(number(value, kDouble));
  if (!table.is_numeric) values.emplace_back("0");
  const std::string type = table.is_numeric ? "const double " : "const char *const ";
  return {type + names.prefix + "_" + subscripted(table.name, values.size()), values};
}

std::string enumeration(const Names& names) {
  const Library& library = names.library;
  const auto entry = [&](const char* name, std::size_t value) {
    return names.prefix + "_" + name + " = " + std::to_string(value);
  };
  std::vector<std::string> entries;
  if (library.has_robot()) entries = {entry("dof", library.joints.size()), entry("link_count", library.links.size())};
  if (library.has_own_positions()) entries.push_back(entry("positions", library.positions.size()));
  if (!library.parameters.empty()) entries.push_back(entry("parameter_count", library.parameters.size()));
  return entries.empty() ? "" : "\n" + wrapped("enum { ", entries, " };");
}

// The structures of parameters and their declarations.
std::string structures(const Names& names) {
  if (names.members.empty()) return "";
  std::string text, caches;
  int size = 0;
  for (const Function& update : names.library.updates) size += update.program.outputs.front().rows;
  for (const Precision& precision : kPrecisions) {
    const std::string &scalar = precision.scalar, &f = precision.suffix;
    const std::string type = names.prefix + "_parameters" + f;
    if (f.empty()) text += "\n" + comment("The parameters, and their values as declared; NAN where there is none.");
    text += "typedef struct {\n";
    for (const std::string& member : names.members) text += "  " + scalar + " " + member + ";\n";
    text += "} " + type + ";\nextern const " + type + " " + names.prefix + "_default_parameters" + f + ";\n";
    caches += "typedef struct {\n  " + scalar + " values[" + std::to_string(std::max(size, 1)) + "];\n} " +
              names.prefix + "_cache" + f + ";\n";
  }
  if (names.library.updates.empty()) return text;
  return text + "\n" +
         comment(
             "What functions read: values that follow from the parameters. " + names.prefix +
             "_update computes them.") +
         caches;
}

constexpr const char* kLimbTypes = R"(
// A link, joint or user frame of a limb: its name in the part, and its index in the robot.
typedef struct {
  const char *own;
  int index;
} @_limb_element;

// An instance of a part in the document. Elements without a name end lists; joints are in the order of joint_names.
typedef struct {
  const char *name, *part;
  int first_link;
  const @_limb_element *links, *joints, *frames;
} @_limb;

// A limb without a name ends them.
)";

// The elements of all limbs, which stand in one list, and the limbs; none where the robot has none.
std::vector<Constant> limbs(const Names& names) {
  if (names.library.limbs.empty()) return {};
  const std::string limb = names.prefix + "_limb", elements = limb + "_elements";
  std::vector<std::string> values, rows;
  for (const LimbData& l : names.library.limbs) {
    std::string row = "{" + quoted(l.name) + ", " + quoted(l.part) + ", " + std::to_string(l.first_link);
    for (const std::vector<LimbData::Element>* list : {&l.links, &l.joints, &l.frames}) {
      row += ", " + elements + " + " + std::to_string(values.size());
      for (const LimbData::Element& e : *list)
        values.push_back("{" + quoted(e.own) + ", " + std::to_string(e.index) + "}");
      values.emplace_back("{0, -1}");
    }
    rows.push_back(row + "}");
  }
  rows.emplace_back("{0, 0, -1, 0, 0, 0}");
  return {
      {"static const " + limb + "_element " + elements + "[]", values},
      {"const " + limb + " " + subscripted(limb + "s", rows.size()), rows, " = {\n    "}};
}

std::vector<Constant> default_parameters(const Names& names) {
  std::vector<Constant> list;
  for (const Precision& precision : kPrecisions) {
    const std::string& f = precision.suffix;
    list.push_back({"const " + names.prefix + "_parameters" + f + " " + names.prefix + "_default_parameters" + f, {}});
    for (const ParameterData& p : names.library.parameters)
      list.back().values.push_back(number(p.default_value, precision));
  }
  return list;
}

}  // namespace

std::string opening(const Names& names, const std::string& file, const std::string& what) {
  return comment(names.folder + "/" + file + ": generated by robcogen from " + names.library.model_file + ".") +
         comment(
             (names.library.has_robot() ? "Robot " : "Model ") + names.library.robot + ": " + what +
             ". Edit the model, not this file.");
}

std::string header(const Names& names, const std::string& file, const std::string& what, const std::string& body) {
  std::string guard = names.folder + "_" + file;
  guard.replace(guard.size() - 2, 1, "_");
  return opening(names, file, what) + "#ifndef " + guard + "\n#define " + guard + "\n\n" + body + "\n#endif\n";
}

std::string print_model_header(const Names& names) {
  const std::string restrict = names.prefix + "_restrict";
  std::string text = comment("Pure functions: no state, no allocation, no recursion. Results must not overlap inputs.");
  text += "#ifdef __cplusplus\n#define " + restrict + "\nextern \"C\" {\n#else\n#define " + restrict +
          " restrict\n#endif\n" + enumeration(names);
  for (const Table& table : tables(names.library))
    text += "\n" + comment(table.what + (table.is_numeric ? "" : "; a null pointer ends them.")) + "extern " +
            constant(names, table).head + ";\n";
  if (const std::vector<Constant> list = limbs(names); !list.empty())
    text += replaced(kLimbTypes, "@", names.prefix) + "extern " + list.back().head + ";\n";
  text += structures(names) + "\n#ifdef __cplusplus\n}\n#endif\n";
  return header(names, "model.h", "names, limits, parameters", text);
}

std::string print_model(const Names& names) {
  std::vector<Constant> list;
  for (const Table& table : tables(names.library)) list.push_back(constant(names, table));
  for (const Constant& c : limbs(names)) list.push_back(c);
  if (!names.members.empty())
    for (const Constant& c : default_parameters(names)) list.push_back(c);
  std::string text = opening(names, "model.c", "names, limits, parameters");
  text += "#include \"" + names.folder + "/model.h\"\n\n#include <math.h>\n";
  for (const auto& [head, values, open] : list) text += "\n" + wrapped(head + open, values, "};");
  return text;
}

}  // namespace robcogen::backend::c
