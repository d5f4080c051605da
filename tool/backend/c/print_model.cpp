// Names, limits and parameters.
#include <algorithm>

#include "backend/c/printers.h"
#include "backend/common/constants.h"

namespace robcogen::backend::c {
namespace {

// Lists of names end with a null pointer: a list of none is legal.
std::vector<std::string> values(const Table& table) {
  std::vector<std::string> items;
  for (const std::string& text : table.texts) items.push_back(quoted(text));
  for (const double value : table.numbers) items.push_back(number(value, kDouble));
  if (!table.is_numeric) items.emplace_back("0");
  return items;
}

std::string head(const Names& names, const Table& table) {
  return std::string("const ") + (table.is_numeric ? "double " : "char *const ") + names.prefix + "_" + table.name +
         "[" + std::to_string(values(table).size()) + "]";
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
  for (const auto& [scalar, f] : kPrecisions) {
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

// Of the limbs: types, and the declaration of the list.
std::string limb_types(const Names& names) {
  if (names.library.limbs.empty()) return "";
  const std::string element = names.prefix + "_limb_element", limb = names.prefix + "_limb";
  return "\n" + comment("A link, joint or user frame of a limb: its name in the part, and its index in the robot.") +
         "typedef struct {\n  const char *own;\n  int index;\n} " + element + ";\n\n" +
         comment(
             "An instance of a part in the document. Elements without a name end lists; joints are in the order of "
             "joint_names.") +
         "typedef struct {\n  const char *name, *part;\n  int first_link;\n  const " + element +
         " *links, *joints, *frames;\n} " + limb + ";\n\n" + comment("A limb without a name ends them.") +
         "extern const " + limb + " " + names.prefix + "_limbs[" + std::to_string(names.library.limbs.size() + 1) +
         "];\n";
}

// The elements of all limbs stand in one list.
std::string limb_tables(const Names& names) {
  if (names.library.limbs.empty()) return "";
  const std::string elements = names.prefix + "_limb_elements";
  std::vector<std::string> values, limbs;
  const auto add = [&](const std::vector<LimbData::Element>& list) {
    const std::string begin = elements + " + " + std::to_string(values.size());
    for (const LimbData::Element& e : list)
      values.push_back("{" + quoted(e.own) + ", " + std::to_string(e.index) + "}");
    values.emplace_back("{0, -1}");
    return begin;
  };
  for (const LimbData& l : names.library.limbs) {
    const std::string links = add(l.links), joints = add(l.joints), frames = add(l.frames);
    limbs.push_back(
        "{" + quoted(l.name) + ", " + quoted(l.part) + ", " + std::to_string(l.first_link) + ", " + links + ", " +
        joints + ", " + frames + "}");
  }
  limbs.emplace_back("{0, 0, -1, 0, 0, 0}");
  return "\n" + wrapped("static const " + names.prefix + "_limb_element " + elements + "[] = {", values, "};") + "\n" +
         wrapped(
             "const " + names.prefix + "_limb " + names.prefix + "_limbs[" + std::to_string(limbs.size()) +
                 "] = {\n    ",
             limbs, "};");
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
            head(names, table) + ";\n";
  text += limb_types(names) + structures(names) + "\n#ifdef __cplusplus\n}\n#endif\n";
  return header(names, "model.h", "names, limits, parameters", text);
}

std::string print_model(const Names& names) {
  std::string text = opening(names, "model.c", "names, limits, parameters");
  text += "#include \"" + names.folder + "/model.h\"\n\n#include <math.h>\n";
  for (const Table& table : tables(names.library))
    text += "\n" + wrapped(head(names, table) + " = {", values(table), "};");
  text += limb_tables(names);
  if (names.members.empty()) return text;
  for (const Precision& precision : kPrecisions) {
    const std::string& f = precision.suffix;
    std::vector<std::string> defaults;
    for (const ParameterData& p : names.library.parameters) defaults.push_back(number(p.default_value, precision));
    text += "\n" +
            wrapped(
                "const " + names.prefix + "_parameters" + f + " " + names.prefix + "_default_parameters" + f + " = {",
                defaults, "};");
  }
  return text;
}

}  // namespace robcogen::backend::c
