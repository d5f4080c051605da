#include "server/urdf_names.h"

#include <algorithm>
#include <iterator>

namespace robcogen::server {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// `<name a="…" b='…'>`, `<name … />` or `</name>`.
struct Tag {
  struct Attribute {
    std::string_view name;
    UrdfName value;
  };
  std::string_view name;
  std::vector<Attribute> attributes;
  bool opens = true, closes = false;
  Span span;

  UrdfName operator[](std::string_view wanted) const {
    for (const Attribute& attribute : attributes)
      if (attribute.name == wanted) return attribute.value;
    return {};
  }
};

// Reads the tags of a text one after the other; skips comments and the like.
class Tags {
 public:
  explicit Tags(std::string_view text) : text_(text) {}

  bool next(Tag& tag) {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) {
      const std::size_t begin = at_;
      if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>") || skip("<!", ">")) continue;
      ++at_;
      read(tag);
      tag.span = {begin, at_};
      return true;
    }
    return false;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;

  bool skip(std::string_view opening, std::string_view closing) {
    if (text_.substr(at_, opening.size()) != opening) return false;
    const std::size_t end = text_.find(closing, at_ + opening.size());
    at_ = end == std::string_view::npos ? text_.size() : end + closing.size();
    return true;
  }

  char here() const { return at_ < text_.size() ? text_[at_] : '>'; }

  void skip_blanks() {
    while (is_blank(here())) ++at_;
  }

  std::string_view word() {
    const std::size_t begin = at_;
    while (!is_blank(here()) && here() != '>' && here() != '/' && here() != '=') ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void read(Tag& tag) {
    tag = {};
    if (here() == '/') {
      tag.opens = false;
      tag.closes = true;
      ++at_;
    }
    tag.name = word();
    for (skip_blanks(); here() != '>'; skip_blanks()) {
      if (here() == '/' || here() == '=') {
        tag.closes = tag.closes || here() == '/';
        ++at_;
        continue;
      }
      const std::string_view name = word();
      skip_blanks();
      if (here() != '=') continue;
      ++at_;
      skip_blanks();
      const char quote = here();
      if (quote != '"' && quote != '\'') continue;
      const std::size_t begin = at_ + 1, end = std::min(text_.find(quote, begin), text_.size());
      tag.attributes.push_back({name, {std::string(text_.substr(begin, end - begin)), {begin, end}}});
      at_ = std::min(end + 1, text_.size());
    }
    if (at_ < text_.size()) ++at_;
  }
};

}  // namespace

UrdfNames urdf_names(std::string_view text) {
  UrdfNames names;
  std::vector<std::string_view> open;  // elements that enclose the tag
  Tags tags(text);
  for (Tag tag; tags.next(tag);) {
    if (!tag.opens) {
      const auto opened = std::find(open.rbegin(), open.rend(), tag.name);
      if (opened != open.rend()) open.erase(std::prev(opened.base()), open.end());
      if (open.size() == 1 && tag.name == "link" && !names.links.empty()) names.links.back().element.end = tag.span.end;
      if (open.size() == 1 && tag.name == "joint" && !names.joints.empty())
        names.joints.back().element.end = tag.span.end;
      continue;
    }
    const std::string_view parent = open.empty() ? "" : open.back();
    const bool in_robot = open.size() == 1 && parent == "robot", in_joint = open.size() == 2 && parent == "joint";
    if (open.empty() && tag.name == "robot") names.robot = tag["name"];
    if (in_robot && tag.name == "link") names.links.push_back({tag["name"], tag.span});
    if (in_robot && tag.name == "joint") names.joints.push_back({tag["name"], {}, {}, tag.span});
    if (in_robot && tag.name == "gazebo") names.uses.push_back(tag["reference"]);
    if (in_joint && !names.joints.empty()) {
      if (tag.name == "parent") names.joints.back().parent = tag["link"];
      if (tag.name == "child") names.joints.back().child = tag["link"];
      if (tag.name == "mimic") names.uses.push_back(tag["joint"]);
    }
    if ((parent == "loop" || parent == "coupling") && (tag.name == "predecessor" || tag.name == "successor"))
      names.uses.push_back(tag["link"]);
    if (parent == "transmission" && tag.name == "joint") names.uses.push_back(tag["name"]);
    if (!tag.closes) open.push_back(tag.name);
  }
  return names;
}

}  // namespace robcogen::server
