#include <algorithm>

#include "language/desired/document.h"
#include "language/desired/keywords.h"

namespace robcogen::language::desired {
namespace {

std::string name(const std::string& text) {
  return is_keyword(text) ? "^" + text : text;
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

std::string pairs(const char* section, const std::vector<Pair>& list, const std::vector<Loop>& loops) {
  const auto line = [](const Pair& p) { return "base = " + frame(p.left) + ", target = " + frame(p.right); };
  return std::string(section) + " {\n" + lines(list, loops, "", line) + "}\n";
}

std::string contacts(const Document& d) {
  const auto line = [](const Contact& c) { return (c.is_surface ? "surface " : "point ") + frame(c.frame); };
  return "Contacts {\n" + lines(d.contacts, d.loops, ",", line) + "}\n";
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

bool same(const Loop& a, const Loop& b);

template <class T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
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

std::string print(const Document& d) {
  std::string out;
  for (const std::string& comment : d.comments) out += comment + "\n";
  out += "Robot " + name(d.robot) + "\n\nFrames {\n" + lines(d.frames, d.loops, ",", frame) + "}\n\n";
  out += pairs("Transforms", d.transforms, d.loops);
  if (!d.jacobians.empty()) out += "\n" + pairs("Jacobians", d.jacobians, d.loops);
  if (!d.contacts.empty()) out += "\n" + contacts(d);
  return out;
}

bool equal(const Document& a, const Document& b) {
  return same(a.robot, b.robot) && all_same(a.loops, b.loops) && all_same(a.frames, b.frames) &&
         all_same(a.transforms, b.transforms) && all_same(a.jacobians, b.jacobians) &&
         all_same(a.contacts, b.contacts) && a.comments == b.comments;
}

}  // namespace robcogen::language::desired
