// Constants of the robot.
#include "backend/common/constants.h"
#include "backend/javascript/text.h"

namespace robcogen::backend::javascript {
namespace {

// In an object literal, the key `__proto__` would set the prototype.
std::string key(const std::string& name) {
  return name == "__proto__" ? "[" + quoted(name) + "]" : name;
}

// `name: value`, in pieces between which a line may end.
struct Pieces {
  std::vector<std::string>& list;
  const std::string name;

  void add(const std::string& value) { list.push_back(key(name) + ": " + value); }
  void operator()(const std::string& value) { add(quoted(value)); }
  void operator()(double value) { add(number(value)); }
  void operator()(int value) { add(std::to_string(value)); }
  void operator()(const std::vector<double>& values) {
    std::vector<std::string> items;
    for (const double value : values) items.push_back(number(value));
    add("[" + joined(items) + "]");
  }
  void operator()(const Record& rows) {
    if (rows.empty()) return add("{}");
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::vector<std::string> members;
      for (const Constant& member : rows[r]) std::visit(Pieces{members, member.name}, member.value);
      const std::string row = joined(members) + (r + 1 == rows.size() ? " }" : "");
      r == 0 ? add("{ " + row) : list.push_back(row);
    }
  }
};

}  // namespace

std::string print_model(const Library& library) {
  std::string text = "\n/**\n" + comment_lines(describe_constants(library), " * ") + " */\nexport const model = {\n";
  text += "  name: " + quoted(library.title()) + ",\n";
  text += "  dof: " + std::to_string(library.tree.dof()) + ",\n";
  if (model::has_own_positions(library.tree)) {
    std::vector<std::string> names;
    for (const std::string& name : model::position_names(library.tree)) names.push_back(quoted(name));
    text += wrapped("  positions: [", names, "],");
  }
  text += std::string("  floating_base: ") + (library.tree.floating_base ? "true" : "false") + ",\n";
  for (const ConstantList& list : constants(library)) {
    text += "  " + list.name + ": [\n";
    for (const std::vector<Constant>& item : list.items) {
      std::vector<std::string> members;
      for (const Constant& member : item) std::visit(Pieces{members, member.name}, member.value);
      text += wrapped("    {", members, " },");
    }
    text += "  ],\n";
  }
  return text + "};\n";
}

}  // namespace robcogen::backend::javascript
