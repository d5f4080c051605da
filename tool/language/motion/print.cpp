#include <algorithm>

#include "language/motion/document.h"

namespace robcogen::language::motion {
namespace {

bool same(const Motion& a, const Motion& b) {
  const bool same_name = a.name.has_value() == b.name.has_value() && (!a.name || a.name->text == b.name->text);
  return a.from.text == b.from.text && a.to.text == b.to.text && language::equal(a.steps, b.steps) && same_name &&
         a.comments == b.comments;
}

}  // namespace

std::string print(const Document& d) {
  std::string out = print_frames_header(d.header, keywords());
  out += print_comments(d.convention_comments);
  out += d.convention == Convention::local ? "Convention = local\n\n" : "Convention = fixed\n\n";
  for (const Motion& m : d.motions) {
    out += print_comments(m.comments);
    out += print_name(m.from, keywords()) + " -> " + print_name(m.to, keywords()) + " :";
    out += print_steps(m.steps, step_words());
    if (m.name) out += " [" + print_name(*m.name, keywords()) + "]";
    out += "\n";
  }
  return out + print_comments(d.trailing_comments);
}

bool equal(const Document& a, const Document& b) {
  return language::equal(a.header, b.header) && a.convention == b.convention &&
         a.convention_comments == b.convention_comments &&
         std::equal(
             a.motions.begin(), a.motions.end(), b.motions.begin(), b.motions.end(),
             [](const Motion& x, const Motion& y) { return same(x, y); }) &&
         a.trailing_comments == b.trailing_comments;
}

}  // namespace robcogen::language::motion
