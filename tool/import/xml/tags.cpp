// A scanner of tags. It gives clearer messages than TinyXML, and protects it from deep nesting, which it parses
// recursively.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "import/xml/xml.h"

namespace robcogen::import::xml {

namespace {

constexpr std::size_t kMaxDepth = 100;
constexpr std::size_t kMaxAttributes = 1000;
constexpr std::size_t kNone = std::string_view::npos;
constexpr std::size_t kMaxTextSize = std::size_t{64} << 20;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool starts_name(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' || byte == ':' || byte >= 127;
}

// Whether declarations in brackets follow, as in `<!DOCTYPE robot [<!ENTITY m "1">]>`.
bool has_internal_subset(std::string_view declaration) {
  return declaration[std::min(declaration.find_first_of("[>"), declaration.size() - 1)] == '[';
}

class TagScanner {
 public:
  TagScanner(const std::shared_ptr<const Source>& source, std::string_view text, Diagnostics& diagnostics)
      : source_(source), text_(text), diagnostics_(diagnostics) {}

  bool scan() {
    while (is_sound_ && next_tag()) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("<!--")) {
        skip_past("-->", 4, "comment");
      } else if (rest.starts_with("<![CDATA[")) {
        skip_past("]]>", 9, "section of character data");
      } else if (rest.starts_with("<!DOCTYPE") && has_internal_subset(rest)) {
        is_sound_ = false;
        diagnostics_
            .error("unsupported-dtd", place({at_, at_ + 9}), "this document type definition (DTD) is not supported")
            .hint = "replace the entities by their texts, and remove <!DOCTYPE ...>";
      } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
        skip_past(">", 2, "declaration");
      } else if (rest.starts_with("</")) {
        close();
      } else if (rest.size() > 1 && starts_name(rest[1])) {
        open();
      } else {
        fault({at_, at_ + 1}, "'<' does not begin a tag here").hint = "in a text or a value, write &lt; instead of '<'";
      }
    }
    if (is_sound_ && !open_.empty()) {
      fault(open_.back(), fmt::format("element '{}' is not closed", name_of(open_.back())));
    }
    return is_sound_;
  }

 private:
  bool next_tag() {
    at_ = text_.find('<', at_);
    return at_ != std::string_view::npos;
  }

  Place place(const Span& span) const { return {source_, span}; }

  Diagnostic& fault(const Span& span, const std::string& message) {
    is_sound_ = false;
    return diagnostics_.error("not-xml", place(span), fmt::format("not well-formed XML: {}", message));
  }

  // Returns the name within the span of `<name`.
  std::string_view name_of(const Span& span) const { return text_.substr(span.begin + 1, span.end - span.begin - 1); }

  void skip_past(std::string_view end, std::size_t length_of_begin, const char* what) {
    const std::size_t found = text_.find(end, at_ + length_of_begin);
    if (found == std::string_view::npos) {
      fault({at_, at_ + length_of_begin}, fmt::format("this {} does not end", what));
    } else {
      at_ = found + end.size();
    }
  }

  // Returns the end of the name that begins at `at`.
  std::size_t end_of_name(std::size_t at) const {
    while (at < text_.size() && !is_blank(text_[at]) && text_[at] != '/' && text_[at] != '>' && text_[at] != '<') ++at;
    return at;
  }

  // Returns the last word between `begin` and the `=` at `end`.
  Span name_before(std::size_t begin, std::size_t end) const {
    while (end > begin && is_blank(text_[end - 1])) --end;
    std::size_t first = end;
    while (first > begin && !is_blank(text_[first - 1]) && text_[first - 1] != '"' && text_[first - 1] != '\'') --first;
    return {first, end};
  }

  // Reports a character that cannot follow the closing quote of a value.
  bool check_after_value(std::size_t opening, std::size_t closing) {
    const char next = closing + 1 < text_.size() ? text_[closing + 1] : '>';
    if (is_blank(next) || next == '/' || next == '>' || next == '<' || starts_name(next)) return true;
    const std::string_view value = text_.substr(opening, closing + 1 - opening);
    if (value.find('=') != std::string_view::npos) {
      fault({opening, closing + 1}, fmt::format("a {} is missing in this attribute value", text_[opening]));
    } else {
      fault({closing + 1, closing + 2}, fmt::format("unexpected '{}' after the value of an attribute", next));
    }
    return false;
  }

  void open() {
    const Span tag = {at_, end_of_name(at_ + 1)};
    std::set<std::string_view> attributes;
    std::size_t quote = kNone;  // the quote that is open
    std::size_t end = tag.end;
    for (; end < text_.size() && (quote != kNone || text_[end] != '>'); ++end) {
      const char c = text_[end];
      if (quote != kNone) {
        if (c != text_[quote]) continue;
        if (!check_after_value(quote, end)) return;
        quote = kNone;
      } else if (c == '"' || c == '\'') {
        quote = end;
      } else if (c == '=') {
        const Span name = name_before(tag.end, end);
        const std::string_view text = text_.substr(name.begin, name.end - name.begin);
        if (!text.empty() && !attributes.insert(text).second) {
          fault(name, fmt::format("attribute '{}' is given twice", text));
          return;
        }
      } else if (c == '<') {
        break;
      }
    }
    if (quote != kNone) {
      fault({quote, quote + 1}, fmt::format("the attribute value that begins here has no closing {}", text_[quote]));
      return;
    }
    if (end == text_.size() || text_[end] != '>') {
      fault(tag, fmt::format("the tag of element '{}' does not end", name_of(tag)));
      return;
    }
    if (attributes.size() > kMaxAttributes) {
      fault(tag, fmt::format("element '{}' has more than {} attributes", name_of(tag), kMaxAttributes));
      return;
    }
    at_ = end + 1;
    if (text_[end - 1] == '/') return;
    open_.push_back(tag);
    if (open_.size() <= kMaxDepth) return;
    is_sound_ = false;
    diagnostics_.error(
        "nesting-too-deep", place(tag), fmt::format("elements are nested more than {} levels deep", kMaxDepth));
  }

  void close() {
    const Span tag = {at_, end_of_name(at_ + 2)};
    const std::string_view name = text_.substr(tag.begin + 2, tag.end - tag.begin - 2);
    if (open_.empty()) {
      fault(tag, fmt::format("'</{}>' has no opening tag", name));
    } else if (name != name_of(open_.back())) {
      fault(tag, fmt::format("expected '</{}>', found '</{}>'", name_of(open_.back()), name))
          .notes.push_back({place(open_.back()), "opened here"});
    } else {
      open_.pop_back();
      skip_past(">", tag.end - tag.begin, "closing tag");
    }
  }

  const std::shared_ptr<const Source>& source_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::vector<Span> open_;
  bool is_sound_ = true;
};

}  // namespace

bool check_tags(const std::shared_ptr<const Source>& source, std::string_view text, Diagnostics& diagnostics) {
  if (text.size() > kMaxTextSize) {
    diagnostics.error(
        "too-large", {source, {}},
        fmt::format(
            "the text is too large for a robot: {} MiB, the limit is {} MiB", text.size() >> 20, kMaxTextSize >> 20));
    return false;
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    diagnostics.error("not-xml", {source, {nul, nul + 1}}, "not an XML document: it has a zero byte");
    return false;
  }
  return TagScanner(source, text, diagnostics).scan();
}

}  // namespace robcogen::import::xml
