#include "import/xml/xml.h"

#include <fmt/format.h>
#include <tinyxml.h>

#include <algorithm>

namespace robcogen::import::xml {

namespace {

// Returns the text for TinyXML: without a byte order mark, and with one kind of line end, so that its rows and columns
// are those of the source. Each byte keeps its offset.
std::string with_plain_line_ends(std::string_view text) {
  std::string plain(text);
  if (text.starts_with(kByteOrderMark)) plain.replace(0, kByteOrderMark.size(), kByteOrderMark.size(), ' ');
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (plain[i] == '\r') plain[i] = i + 1 < plain.size() && plain[i + 1] == '\n' ? ' ' : '\n';
  }
  return plain;
}

std::vector<std::size_t> line_starts_of(std::string_view text) {
  std::vector<std::size_t> starts = {0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts.push_back(i + 1);
  return starts;
}

class Converter {
 public:
  explicit Converter(std::string_view text) : text_(text), line_starts_(line_starts_of(text)) {}

  // Returns the end of the text if TinyXML gives no place.
  std::size_t offset_of(int row, int column) const {
    if (row < 1 || column < 1 || static_cast<std::size_t>(row) > line_starts_.size()) return text_.size();
    return line_starts_[static_cast<std::size_t>(row - 1)] + static_cast<std::size_t>(column - 1);
  }

  Element convert(const TiXmlElement& element) const {
    Element result;
    result.name = element.ValueStr();
    const std::size_t begin = offset_of(element.Row(), element.Column());
    result.span = {begin, std::min(text_.size(), begin + 1 + result.name.size())};
    for (auto a = element.FirstAttribute(); a != nullptr; a = a->Next())
      result.attributes.push_back({a->Name(), a->ValueStr(), value_span(offset_of(a->Row(), a->Column()))});
    read_text(element, result);
    for (auto child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
      result.children.push_back(convert(*child));
    return result;
  }

 private:
  // Returns the span of the value in `name = "value"`, which begins at `at`.
  Span value_span(std::size_t at) const {
    const std::size_t equals = text_.find('=', at);
    if (equals == std::string_view::npos) return {at, at};
    const std::size_t begin = text_.find_first_not_of(" \t\n\v\f", equals + 1);
    if (begin == std::string_view::npos) return {at, at};
    const bool is_quoted = text_[begin] == '"' || text_[begin] == '\'';
    const std::size_t first = is_quoted ? begin + 1 : begin;
    const std::size_t end = is_quoted ? text_.find(text_[begin], first) : text_.find_first_of(" \t\n\v\f/>", first);
    return {first, std::min(end, text_.size())};
  }

  // TinyXML condenses blanks; the text is as it is written, unless it contains entities.
  void read_text(const TiXmlElement& element, Element& result) const {
    const TiXmlNode* node = element.FirstChild();
    while (node != nullptr && node->ToText() == nullptr) node = node->NextSibling();
    if (node == nullptr) return;
    const std::size_t begin = offset_of(node->Row(), node->Column());
    const std::size_t next = std::min(text_.find('<', begin), text_.size());
    const std::string_view written = text_.substr(begin, next - begin);
    result.text_span = {begin, begin + written.find_last_not_of(" \t\n\v\f") + 1};
    const bool is_plain = !node->ToText()->CDATA() && written.find('&') == std::string_view::npos;
    result.text = is_plain ? std::string(written.substr(0, result.text_span.end - begin)) : node->ValueStr();
  }

  std::string_view text_;
  std::vector<std::size_t> line_starts_;
};

const char* reason(const TiXmlDocument& document) {
  switch (document.ErrorId()) {
    case TiXmlBase::TIXML_ERROR_READING_ATTRIBUTES:
      return "expected an attribute name=\"value\"";
    case TiXmlBase::TIXML_ERROR_PARSING_ELEMENT:
    case TiXmlBase::TIXML_ERROR_PARSING_EMPTY:
      return "this tag has a stray character";
    default:
      return document.ErrorDesc();
  }
}

}  // namespace

std::optional<Element> read(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  const std::string text = with_plain_line_ends(source->text());
  const auto fault = [&](const Span& span, const std::string& message) {
    diagnostics.error("not-xml", {source, span}, message);
    return std::nullopt;
  };
  if (text.find_first_not_of(" \t\n") == std::string::npos)
    return fault({0, 0}, "not an XML document: the file is empty");
  if (!check_tags(source, text, diagnostics)) return std::nullopt;

  TiXmlDocument document;
  document.SetTabSize(1);
  // Parse without decoding: columns count bytes, and names keep their spelling.
  const char* end = document.Parse(text.c_str(), nullptr, TIXML_ENCODING_LEGACY);
  const Converter converter(text);
  if (document.Error() && document.ErrorId() != TiXmlBase::TIXML_ERROR_DOCUMENT_EMPTY) {
    const std::size_t at = converter.offset_of(document.ErrorRow(), document.ErrorCol());
    return fault({at, at + 1}, fmt::format("not well-formed XML: {}", reason(document)));
  }
  const TiXmlElement* root = document.RootElement();
  if (root == nullptr) return fault({0, 0}, "not an XML document: no root element");
  Element element = converter.convert(*root);
  if (const TiXmlElement* second = root->NextSiblingElement()) {
    const std::size_t at = converter.offset_of(second->Row(), second->Column());
    return fault(
        {at, at + 1 + second->ValueStr().size()},
        fmt::format("not well-formed XML: '{}' is a second root element", second->ValueStr()));
  }
  if (end != nullptr && *end != '\0') {
    const auto at = static_cast<std::size_t>(end - text.c_str());
    return fault({at, at + 1}, "not well-formed XML: text after the root element");
  }
  return element;
}

}  // namespace robcogen::import::xml
