#include <algorithm>

#include "language/desired/document.h"
#include "language/desired/keywords.h"

namespace robcogen::language::desired {
namespace {

std::string name(const Name& n) {
  return is_keyword(n.text) ? "^" + n.text : n.text;
}

std::string pairs(const char* section, const std::vector<Pair>& list) {
  std::string out = std::string(section) + " {\n";
  for (const Pair& pair : list) out += "    base = " + name(pair.left) + ", target = " + name(pair.right) + "\n";
  return out + "}\n";
}

std::string contacts(const std::vector<Contact>& list) {
  std::string out = "Contacts {\n";
  for (std::size_t i = 0; i < list.size(); ++i)
    out += std::string("    ") + (list[i].is_surface ? "surface " : "point ") + name(list[i].frame) +
           (i + 1 < list.size() ? ",\n" : "\n");
  return out + "}\n";
}

bool same(const Name& a, const Name& b) {
  return a.text == b.text;
}
bool same(const Pair& a, const Pair& b) {
  return same(a.left, b.left) && same(a.right, b.right);
}

bool same(const Contact& a, const Contact& b) {
  return same(a.frame, b.frame) && a.is_surface == b.is_surface;
}

template <class T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

}  // namespace

std::string print(const Document& d) {
  std::string out;
  for (const std::string& comment : d.comments) out += comment + "\n";
  out += "Robot " + name(d.robot) + "\n\nFrames {\n";
  for (std::size_t i = 0; i < d.frames.size(); ++i)
    out += "    " + name(d.frames[i]) + (i + 1 < d.frames.size() ? ",\n" : "\n");
  out += "}\n\n" + pairs("Transforms", d.transforms);
  if (!d.jacobians.empty()) out += "\n" + pairs("Jacobians", d.jacobians);
  if (!d.contacts.empty()) out += "\n" + contacts(d.contacts);
  return out;
}

bool equal(const Document& a, const Document& b) {
  return same(a.robot, b.robot) && all_same(a.frames, b.frames) && all_same(a.transforms, b.transforms) &&
         all_same(a.jacobians, b.jacobians) && all_same(a.contacts, b.contacts) && a.comments == b.comments;
}

}  // namespace robcogen::language::desired
