#include "urdf_text.h"

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <vector>

namespace robcogen::peers {

namespace {

// Erases the text from each `begin` to the next `end`.
void erase_all(std::string& text, const std::string& begin, const std::string& end) {
  std::size_t from = 0;
  while ((from = text.find(begin, from)) != std::string::npos) {
    const std::size_t to = text.find(end, from);
    if (to == std::string::npos) return;
    text.erase(from, to + end.size() - from);
  }
}

void erase_elements(std::string& urdf, const std::string& name) {
  for (const char* after : {">", " ", "\n"}) erase_all(urdf, "<" + name + after, "</" + name + ">");
}

// The position of a start tag in the text, without its `>`.
struct Tag {
  std::size_t begin, end;
  std::string value;  // of the requested attribute
};

// All start tags of this name that have the attribute.
std::vector<Tag> tags(const std::string& urdf, const std::string& name, const std::string& attribute) {
  std::vector<Tag> found;
  const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; };
  const std::string open = "<" + name;
  for (std::size_t begin = urdf.find(open); begin != std::string::npos; begin = urdf.find(open, begin + 1)) {
    const std::size_t end = urdf.find('>', begin);
    if (end == std::string::npos || !is_space(urdf[begin + open.size()])) continue;
    const std::string tag = urdf.substr(begin, end - begin);
    for (const char quote : {'"', '\''}) {
      const std::size_t at = tag.find(attribute + "=" + quote);
      if (at == std::string::npos || !is_space(tag[at - 1])) continue;
      const std::size_t value = at + attribute.size() + 2;
      found.push_back({begin, end, tag.substr(value, tag.find(quote, value) - value)});
    }
  }
  return found;
}

}  // namespace

std::string dynamics_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string text(std::istreambuf_iterator<char>(file), {});
  erase_all(text, "<!--", "-->");
  erase_elements(text, "visual");
  erase_elements(text, "collision");
  return text;
}

std::string with_elements(std::string urdf, const std::string& elements) {
  const std::vector<Tag> robots = tags(urdf, "robot", "name");
  if (robots.empty()) throw std::runtime_error("no element <robot>");
  return urdf.insert(robots.front().end + 1, elements);
}

std::string with_link_elements(std::string urdf, const std::string& link, const std::string& elements) {
  for (const Tag& tag : tags(urdf, "link", "name")) {
    if (tag.value != link) continue;
    const bool is_empty = urdf[tag.end - 1] == '/';
    if (is_empty) return urdf.replace(tag.end - 1, 2, ">" + elements + "</link>");
    return urdf.insert(tag.end + 1, elements);
  }
  throw std::runtime_error("no link " + link);
}

std::string child_link(const std::string& urdf, const std::string& joint) {
  for (const Tag& tag : tags(urdf, "joint", "name")) {
    if (tag.value != joint) continue;
    for (const Tag& child : tags(urdf, "child", "link")) {
      if (child.begin > tag.begin) return child.value;
    }
  }
  throw std::runtime_error("no joint " + joint);
}

std::string root_link(const std::string& urdf) {
  std::set<std::string> children;
  for (const Tag& tag : tags(urdf, "child", "link")) children.insert(tag.value);
  for (const Tag& tag : tags(urdf, "link", "name")) {
    if (children.count(tag.value) == 0) return tag.value;
  }
  throw std::runtime_error("no root link");
}

}  // namespace robcogen::peers
