#include <algorithm>

#include "language/desired/document.h"
#include "language/desired/keywords.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::language::desired {
namespace {

std::string name(const std::string& text) {
  return is_keyword(text) ? "^" + text : text;
}
// `scope.name`, in which each word is escaped.
std::string escaped(const std::string& dotted) {
  const std::size_t dot = dotted.find('.');
  if (dot == std::string::npos) return name(dotted);
  return name(dotted.substr(0, dot)) + "." + escaped(dotted.substr(dot + 1));
}
std::string name(const Name& n) {
  return name(n.text);
}

// As the name of an instance, these two keywords are not escaped.
std::string instance(const std::string& text) {
  return text == "left" || text == "right" ? text : name(text);
}

std::string frame(const Name& n) {
  return (n.instance.empty() ? "" : instance(n.instance) + ".") + name(n);
}

std::string head(const Loop& loop) {
  std::string instances;
  for (const Name& n : loop.instances) instances += (instances.empty() ? "" : ", ") + instance(n.text);
  return "    for " + name(loop.variable) + " in { " + instances + " } {\n";
}

// Returns the elements of a section, one per line; those of loops are in blocks. `end` separates elements, and also
// follows the block of a loop.
template <class T, class Line>
std::string lines(const std::vector<T>& list, const std::vector<Loop>& loops, const std::string& end, Line line) {
  std::string out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const int loop = loop_of(list[i]);
    const bool in_loop = loop != Name::kNoLoop;
    const bool is_last = i + 1 == list.size();
    if (in_loop && (i == 0 || loop_of(list[i - 1]) != loop)) out += head(loops[static_cast<std::size_t>(loop)]);
    const bool ends_loop = in_loop && (is_last || loop_of(list[i + 1]) != loop);
    out += (in_loop ? "        " : "    ") + line(list[i]) + (ends_loop || is_last ? "" : end) + "\n";
    if (ends_loop) out += "    }" + (is_last ? "" : end) + "\n";
  }
  return out;
}

std::string sides(const Pair& p) {
  return "base = " + frame(p.left) + ", target = " + frame(p.right);
}

std::string pairs(const char* section, const std::vector<Pair>& list, const std::vector<Loop>& loops) {
  return std::string(section) + " {\n" + lines(list, loops, "", sides) + "}\n";
}

std::string task(const Inverse& i) {
  switch (i.task) {
    case Inverse::Task::pose:
      return "";
    case Inverse::Task::point:
      return ", point";
    case Inverse::Task::axis:
      return ", axis";
    case Inverse::Task::swivel:
      return ", swivel";
    case Inverse::Task::given:
      break;
  }
  return ", given " + name(i.given);
}

std::string inverses(const Document& d) {
  const auto line = [](const Inverse& i) {
    return sides(i.pair) + task(i) + (i.tolerance ? ", tolerance = " + print_double(*i.tolerance) : "");
  };
  return "InverseKinematics {\n" + lines(d.inverses, d.loops, "", line) + "}\n";
}

std::string contacts(const Document& d) {
  const auto line = [](const Contact& c) { return (c.is_surface ? "surface " : "point ") + frame(c.frame); };
  return "Contacts {\n" + lines(d.contacts, d.loops, ",", line) + "}\n";
}

// The parts one below another, if they are too long for a line.
std::string function(const Function& f) {
  constexpr std::size_t kColumns = 120;
  std::vector<std::string> parts;
  for (const Name& part : f.parts) parts.push_back(escaped(part.text));
  const std::string head = "    " + name(f.name) + " = ", line = head + joined(parts, " + ") + "\n";
  return line.size() <= kColumns + 1 ? line
                                     : head + joined(parts, "\n" + std::string(head.size() - 2, ' ') + "+ ") + "\n";
}

std::string functions(const Document& d) {
  std::string out = "Functions {\n";
  for (const Function& f : d.functions) out += function(f);
  return out + "}\n";
}

bool same(const Name& a, const Name& b) {
  return a.text == b.text && a.instance == b.instance && a.loop == b.loop;
}
bool same(const Pair& a, const Pair& b) {
  return same(a.left, b.left) && same(a.right, b.right);
}

bool same(const Contact& a, const Contact& b) {
  return same(a.frame, b.frame) && a.is_surface == b.is_surface;
}

bool same(const Inverse& a, const Inverse& b) {
  return same(a.pair, b.pair) && a.task == b.task && a.given.text == b.given.text && a.tolerance == b.tolerance;
}

bool same(const Loop& a, const Loop& b);
bool same(const Function& a, const Function& b);

template <class T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

bool same(const Function& a, const Function& b) {
  return same(a.name, b.name) && all_same(a.parts, b.parts);
}

bool same(const Loop& a, const Loop& b) {
  return same(a.variable, b.variable) && all_same(a.instances, b.instances);
}

}  // namespace

int loop_of(const Name& name) {
  return name.loop;
}
int loop_of(const Pair& pair) {
  return pair.left.loop;
}
int loop_of(const Contact& contact) {
  return contact.frame.loop;
}
int loop_of(const Inverse& inverse) {
  return loop_of(inverse.pair);
}

std::string print(const Document& d) {
  std::string out;
  for (const std::string& comment : d.comments) out += comment + "\n";
  out += "Robot " + name(d.robot) + "\n\nFrames {\n" + lines(d.frames, d.loops, ",", frame) + "}\n\n";
  out += pairs("Transforms", d.transforms, d.loops);
  if (!d.jacobians.empty()) out += "\n" + pairs("Jacobians", d.jacobians, d.loops);
  if (!d.contacts.empty()) out += "\n" + contacts(d);
  if (!d.inverses.empty()) out += "\n" + inverses(d);
  if (!d.functions.empty()) out += "\n" + functions(d);
  return out;
}

bool equal(const Document& a, const Document& b) {
  return same(a.robot, b.robot) && all_same(a.loops, b.loops) && all_same(a.frames, b.frames) &&
         all_same(a.transforms, b.transforms) && all_same(a.jacobians, b.jacobians) &&
         all_same(a.contacts, b.contacts) && all_same(a.inverses, b.inverses) && all_same(a.functions, b.functions) &&
         a.comments == b.comments;
}

}  // namespace robcogen::language::desired
