// Names, limits and parameters.
#include <algorithm>

#include "backend/c/printers.h"
#include "backend/common/cache.h"
#include "backend/common/constants.h"
#include "backend/common/layout.h"
#include "support/concat.h"

namespace robcogen::backend::c {
namespace {

constexpr const char* kContent = "names, limits, parameters";

constexpr const char* kOpening =
    R"(// Pure functions: no state, no allocation, no recursion. Results must not overlap inputs.
#ifdef __cplusplus
#define @_restrict
extern "C" {
#elif defined(_MSC_VER)
#define @_restrict __restrict
#else
#define @_restrict restrict
#endif
)";

constexpr const char* kLimbTypes = R"(
// Limbs have gaps between members, which -fpack-struct in a user's file would remove.
typedef struct {
  char first;
  void *second;
} @__gap;
typedef char @__compile_this_file_without_fpack_struct
    [sizeof(@__gap) == 2 * sizeof(void *) || sizeof(void *) == 2 ? 1 : -1];

// A link, joint or user frame of a limb: its name in the part, and its index in the robot.
typedef struct {
  const char *own;
  int index;
} @_limb_element;

// An instance of a part in the document. An element without a name ends a list; indices of joints refer to joint_names.
typedef struct {
  const char *name, *part;
  int first_link;
  const @_limb_element *links, *joints, *frames;
} @_limb;

// A limb without a name ends the array.
)";

// A constant that model.c defines: `const double hyl_joint_lower[3]`, and its values.
struct Constant {
  std::string before;  // its comment and type in model.h; empty: not declared there
  std::string head;
  std::vector<std::string> values;
  std::string open = " = {";
};

// A list of names ends with a null pointer, so that an empty list is legal.
Constant constant(const Names& names, const Table& table) {
  std::vector<std::string> values;
  for (const std::string& text : table.texts) values.push_back(quoted(text));
  for (const double value : table.numbers) values.push_back(number(value, kDouble));
  if (!table.is_numeric) values.emplace_back("0");
  const std::string type = table.is_numeric ? "const double " : "const char *const ";
  return {
      "\n" + comment(table.what + (table.is_numeric ? "" : "; a null pointer ends the list.")),
      type + names.prefix + "_" + subscripted(table.name, values.size()), values};
}

// The elements of all limbs, in one list, and the limbs.
std::vector<Constant> limbs(const Names& names) {
  const std::string limb = names.prefix + "_limb", elements = limb + "_elements";
  std::vector<std::string> values, rows;
  for (const model::Limb& l : model::listed_limbs(names.library.tree)) {
    std::vector<std::string> row = {quoted(l.name), quoted(l.part), std::to_string(l.first_link)};
    for (const std::vector<model::Limb::Element>* list : {&l.links, &l.joints, &l.frames}) {
      row.push_back(elements + " + " + std::to_string(values.size()));
      for (const model::Limb::Element& e : *list) values.push_back(braced({quoted(e.own), std::to_string(e.index)}));
      values.emplace_back("{0, -1}");
    }
    rows.push_back(braced(row));
  }
  rows.emplace_back("{0, 0, -1, 0, 0, 0}");
  return {
      {"", "static const " + limb + "_element " + elements + "[]", values},
      {names.in(kDouble, kLimbTypes), "const " + limb + " " + subscripted(limb + "s", rows.size()), rows,
       " = {\n    "}};
}

Constant default_parameters(const Names& names, const Precision& precision) {
  const std::vector<std::string> members = dialect(kDouble, false).members(model::names_of(names.library.parameters()));
  Constant result{
      names.in(precision, "typedef struct {\n  % " + joined(members, ";\n  % ") + ";\n} @_parameters$;\n"),
      names.in(precision, "const @_parameters$ @_default_parameters$"),
      {}};
  for (const model::Parameter& p : names.library.parameters())
    result.values.push_back(number(model::default_of(p), precision));
  return result;
}

std::vector<Constant> constants(const Names& names) {
  std::vector<Constant> list;
  for (const Table& table : tables(names.library)) list.push_back(constant(names, table));
  if (!names.library.tree.limbs.empty())
    for (const Constant& c : limbs(names)) list.push_back(c);
  if (names.library.parameters().empty()) return list;
  const std::size_t first = list.size();
  for (const Precision& precision : kPrecisions) list.push_back(default_parameters(names, precision));
  list[first].before.insert(
      0, "\n// The parameters, with their declared values; NAN for a parameter without a value.\n");
  return list;
}

std::string caches(const Names& names) {
  if (names.library.updates.empty()) return "";
  const std::string what = "Values that depend on the parameters. Functions read them, and @_update computes them.";
  const std::string size = std::to_string(std::max(cache_size(names.library), 1));
  std::string text = "\n" + comment(names.in(kDouble, what));
  for (const Precision& precision : kPrecisions)
    text += names.in(precision, "typedef struct {\n  % values[" + size + "];\n} @_cache$;\n");
  return text;
}

}  // namespace

std::string enumeration(const Names& names) {
  std::vector<std::string> entries;
  for (const auto& [name, size] : sizes(names.library))
    entries.push_back(names.prefix + "_" + name + " = " + std::to_string(size));
  return entries.empty() ? "" : "\n" + wrapped("enum { ", entries, " };");
}

std::string header(const Names& names, const std::string& file, const std::string& what, const std::string& body) {
  std::string guard = names.folder + "_" + file;
  guard.replace(guard.size() - 2, 1, "_");
  return banner(names.library, names.folder + "/" + file, what) + "#ifndef " + guard + "\n#define " + guard + "\n\n" +
         body + "\n#endif\n";
}

std::string print_model_header(const Names& names) {
  std::string text = names.in(kDouble, kOpening) + enumeration(names);
  for (const Constant& c : constants(names))
    if (!c.before.empty()) text += c.before + "extern " + c.head + ";\n";
  return header(names, "model.h", kContent, text + caches(names) + "\n#ifdef __cplusplus\n}\n#endif\n");
}

std::string print_model(const Names& names) {
  const std::string path = names.folder + "/model";
  std::string text = banner(names.library, path + ".c", kContent);
  text += "#include \"" + path + ".h\"\n\n#include <math.h>\n";
  for (const Constant& c : constants(names)) text += "\n" + wrapped(c.head + c.open, c.values, "};");
  return text;
}

}  // namespace robcogen::backend::c
