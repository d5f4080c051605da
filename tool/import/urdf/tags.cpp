// Tags only, and no more of XML than it takes to find them: it stands before a parser that recurses.
#include <fmt/format.h>

#include "import/urdf/xml.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr std::size_t kDeepest = 100;
constexpr int kMostAttributes = 1000;
constexpr std::size_t kLargestText = std::size_t{64} << 20;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool starts_name(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' || byte == ':' || byte >= 127;
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
      } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
        skip_past(">", 2, "declaration");
      } else if (rest.starts_with("</")) {
        close();
      } else if (rest.size() > 1 && starts_name(rest[1])) {
        open();
      } else {
        fault({at_, at_ + 1}, "a '<' that begins no tag").hint = "in a text or a value, '<' is spelled &lt;";
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
    return diagnostics_.error("not-xml", place(span), fmt::format("this is no well-formed XML: {}", message));
  }

  // Of the span of `<name`.
  std::string_view name_of(const Span& span) const { return text_.substr(span.begin + 1, span.end - span.begin - 1); }

  void skip_past(std::string_view end, std::size_t length_of_begin, const char* what) {
    const std::size_t found = text_.find(end, at_ + length_of_begin);
    if (found == std::string_view::npos) {
      fault({at_, at_ + length_of_begin}, fmt::format("a {} does not end", what));
    } else {
      at_ = found + end.size();
    }
  }

  // The end of the name that begins here.
  std::size_t end_of_name(std::size_t at) const {
    while (at < text_.size() && !is_blank(text_[at]) && text_[at] != '/' && text_[at] != '>' && text_[at] != '<') ++at;
    return at;
  }

  void open() {
    const Span tag = {at_, end_of_name(at_ + 1)};
    int attributes = 0;
    char quote = 0;
    std::size_t end = tag.end;
    for (; end < text_.size() && (quote != 0 || text_[end] != '>'); ++end) {
      const char c = text_[end];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '=') {
        ++attributes;
      } else if (c == '<') {
        break;
      }
    }
    if (end == text_.size() || text_[end] != '>') {
      fault(tag, fmt::format("the tag of element '{}' does not end", name_of(tag)));
      return;
    }
    if (attributes > kMostAttributes) {
      fault(tag, fmt::format("element '{}' has more than {} attributes", name_of(tag), kMostAttributes));
      return;
    }
    at_ = end + 1;
    if (text_[end - 1] == '/') return;
    open_.push_back(tag);
    if (open_.size() <= kDeepest) return;
    is_sound_ = false;
    diagnostics_.error("nesting-too-deep", place(tag), fmt::format("elements are nested more than {} deep", kDeepest));
  }

  void close() {
    const Span tag = {at_, end_of_name(at_ + 2)};
    const std::string_view name = text_.substr(tag.begin + 2, tag.end - tag.begin - 2);
    if (open_.empty()) {
      fault(tag, fmt::format("'</{}>' closes nothing", name));
    } else if (name != name_of(open_.back())) {
      fault(tag, fmt::format("'</{}>' where element '{}' is open", name, name_of(open_.back())))
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
  if (text.size() > kLargestText) {
    diagnostics.error(
        "too-large", {source, {}},
        fmt::format(
            "this text of {} MiB is no robot: {} MiB is the most that is read", text.size() >> 20, kLargestText >> 20));
    return false;
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    diagnostics.error("not-xml", {source, {nul, nul + 1}}, "this is no XML: it holds a byte that is zero");
    return false;
  }
  return TagScanner(source, text, diagnostics).scan();
}

}  // namespace robcogen::import::from_urdf
