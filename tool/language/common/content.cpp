#include "language/common/content.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "language/common/characters.h"

namespace robcogen::language {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

std::string_view without_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
}

// Whether the character may be part of a name in XML.
bool is_of_name(char c) {
  return is_word(c) || c == '-' || c == '.' || c == ':';
}

std::string_view name_at(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_of_name);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

// Returns the name of the root element of XML, after declarations, comments and processing instructions. Empty if the
// text is not XML.
std::string_view root_element(std::string_view text) {
  for (text = without_blanks(text); text.starts_with('<'); text = without_blanks(text)) {
    const std::string_view end = text.starts_with("<?") ? "?>" : text.starts_with("<!--") ? "-->" : ">";
    if (text.size() > 1 && is_letter(text[1])) return name_at(text.substr(1));
    if (!text.starts_with("<?") && !text.starts_with("<!")) return {};
    const std::size_t at = text.find(end);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + end.size());
  }
  return {};
}

// Whether more than one byte in eight is a control character.
bool is_binary(std::string_view text) {
  constexpr std::size_t kExamined = 512, kMinSize = 16;
  const std::string_view beginning = text.substr(0, kExamined);
  const auto controls = std::count_if(beginning.begin(), beginning.end(), [](char c) {
    return c == '\x7f' || (static_cast<unsigned char>(c) < 0x20 && kBlanks.find(c) == std::string_view::npos);
  });
  return beginning.size() >= kMinSize && static_cast<std::size_t>(controls) * 8 > beginning.size();
}

bool is_json(std::string_view text) {
  if (text.starts_with('[')) return true;
  if (!text.starts_with('{')) return false;
  const std::string_view inside = without_blanks(text.substr(1));
  return inside.starts_with('"') || inside.starts_with('}');
}

// Whether a line `key: …` or a marker of YAML follows the comments.
bool is_yaml(std::string_view text) {
  while (text.starts_with('#')) text = without_blanks(text.substr(std::min(text.find('\n'), text.size())));
  if (text.starts_with("---") || text.starts_with("%YAML")) return true;
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const std::size_t key = std::min(line.find(':'), line.size());
  const bool is_key = key > 0 && is_letter(line[0]) && name_at(line.substr(0, key)).size() == key;
  const bool ends = key + 1 == line.size() || (key + 1 < line.size() && line[key + 1] == ' ');
  return is_key && ends && line.find('{') == std::string_view::npos;
}

// Returns what the text is, for a message.
std::string description(Content content, std::string_view text) {
  switch (content) {
    case Content::urdf:
      return "a URDF";
    case Content::sdf:
      return "an SDF document (root element 'sdf')";
    case Content::mjcf:
      return "an MJCF model of MuJoCo (root element 'mujoco')";
    case Content::xml:
      return fmt::format("an XML document with root element {}", quote(root_element(text)));
    case Content::json:
      return "a JSON document";
    case Content::yaml:
      return "a YAML document";
    case Content::binary:
      return "a binary file";
    case Content::unknown:
      break;
  }
  return "";
}

void refuse(const std::shared_ptr<const Source>& source, Content content, Diagnostics& diagnostics) {
  const std::string_view text = source->text();
  const std::string_view root = root_element(text);
  Span span = {0, 0};
  if (!root.empty() && content != Content::binary) {
    span.end = static_cast<std::size_t>(root.data() - text.data()) + root.size();
    span.begin = span.end - root.size() - 1;
  }
  diagnostics
      .error(
          "other-format", {source, span},
          fmt::format("this is {}, not a robcogen document", description(content, text)))
      .hint =
      content == Content::urdf || content == Content::mjcf || content == Content::sdf
          ? "'robcogen convert' turns it into a robot document"
          : "robots are read from URDF (.urdf), MJCF (.xml), SDF (.sdf) and robot documents (.kindsl); convert it to one "
            "of these";
}

}  // namespace

Content content_of(std::string_view text) {
  if (is_utf16(text)) return Content::unknown;  // the lexer reports it
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (is_binary(text)) return Content::binary;
  const std::string_view root = root_element(text);
  if (root == "robot") return Content::urdf;
  if (root == "sdf") return Content::sdf;
  if (root == "mujoco" || root == "mujocoinclude") return Content::mjcf;
  if (!root.empty()) return Content::xml;
  text = without_blanks(text);
  if (is_json(text)) return Content::json;
  return is_yaml(text) ? Content::yaml : Content::unknown;
}

bool refuse_foreign(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  const Content content = content_of(source->text());
  if (content == Content::unknown || content == Content::urdf) return false;
  refuse(source, content, diagnostics);
  return true;
}

TokenList tokenize_document(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  const Content content = content_of(source->text());
  if (content == Content::unknown) return tokenize(std::move(source), diagnostics);
  refuse(source, content, diagnostics);
  TokenList list;
  list.tokens.push_back({});
  list.cut = true;
  list.source = std::move(source);
  return list;
}

}  // namespace robcogen::language
