#include <algorithm>

#include "language/transforms/document.h"

namespace robcogen::language::transforms {
namespace {

bool same(const Transform& a, const Transform& b) {
  const bool same_name = a.name.has_value() == b.name.has_value() && (!a.name || a.name->text == b.name->text);
  return a.left.text == b.left.text && a.right.text == b.right.text && language::equal(a.primitives, b.primitives) &&
         same_name && a.comments == b.comments;
}

}  // namespace

// Prints `TransformedFramePos`, because the first RobCoGen reads only this word.
std::string print(const Document& d) {
  std::string out = print_frames_header(d.header, keywords());
  out += print_comments(d.position_comments);
  out += d.position == MovedFramePosition::left ? "TransformedFramePos = left\n\n" : "TransformedFramePos = right\n\n";
  for (const Transform& t : d.transforms) {
    out += print_comments(t.comments);
    out += "{" + print_name(t.left, keywords()) + "}_X_{" + print_name(t.right, keywords()) + "} =";
    out += print_steps(t.primitives, primitive_words());
    if (t.name) out += " [" + print_name(*t.name, keywords()) + "]";
    out += "\n";
  }
  return out + print_comments(d.trailing_comments);
}

bool equal(const Document& a, const Document& b) {
  return language::equal(a.header, b.header) && a.position == b.position &&
         a.position_comments == b.position_comments &&
         std::equal(
             a.transforms.begin(), a.transforms.end(), b.transforms.begin(), b.transforms.end(),
             [](const Transform& x, const Transform& y) { return same(x, y); }) &&
         a.trailing_comments == b.trailing_comments;
}

}  // namespace robcogen::language::transforms
