// Formats a document: its canonical text, including comments.
#include "server/features.h"
#include "server/lookup.h"

namespace robcogen::server {
namespace {

std::string canonical_text_of(const Parsed& document) {
  if (const auto* robot = document.robot()) return language::kinematics::print(*robot);
  if (const auto* list = document.desired()) return language::desired::print(*list);
  if (const auto* motions = document.motions()) return language::motion::print(*motions);
  if (const auto* transforms = document.transforms()) return language::transforms::print(*transforms);
  return "";
}

// Returns the text with the line ends of the document `like`.
std::string with_line_ends(const std::string& text, std::string_view like) {
  if (like.find("\r\n") == std::string_view::npos) return text;
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

}  // namespace

// Returns one edit, which covers the lines that differ. A document with syntax errors is not formatted, because its
// canonical text would lose content.
Json formatting(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  if (lookup.document == nullptr || lookup.document->has_errors) return nullptr;
  const std::string_view before = lookup.document->source->text();
  const std::string after = with_line_ends(canonical_text_of(*lookup.document), before);
  if (after.empty() || after == before) return Json::array();
  std::size_t begin = 0, same_lines = 0;
  while (begin < before.size() && begin < after.size() && before[begin] == after[begin]) {
    ++begin;
    if (before[begin - 1] == '\n') same_lines = begin;
  }
  std::size_t end = 0, same_end = 0;
  while (end < before.size() - same_lines && end < after.size() - same_lines &&
         before[before.size() - 1 - end] == after[after.size() - 1 - end]) {
    if (before[before.size() - 1 - end] == '\n') same_end = end;
    ++end;
  }
  const Span span = {same_lines, before.size() - same_end};
  return Json::array(
      {{{"range", lookup.here().json(span)},
        {"newText", after.substr(same_lines, after.size() - same_end - same_lines)}}});
}

}  // namespace robcogen::server
