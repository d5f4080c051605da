#include "driver/changes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "driver/option_text.h"
#include "import/parameters.h"
#include "language/common/cursor.h"
#include "language/common/lexer.h"
#include "language/common/parse_expression.h"

namespace robcogen::driver {
namespace {

// Reads a constant, such as 0.3 or PI/2.
model::Quantity constant(const std::string& text, Diagnostics& diagnostics) {
  const auto source = std::make_shared<const Source>("--lock", text);
  const std::size_t errors_before = diagnostics.error_count();
  try {
    language::Cursor cursor(language::tokenize(source, diagnostics), {}, diagnostics);
    const language::ExpressionPtr expression = language::parse_expression(cursor);
    if (!cursor.at_end()) cursor.unexpected("the end of the number", "");
    import::QuantityReader reader(source, diagnostics);
    model::Quantity value = reader.read(*expression, model::ParameterKind::angle);
    if (value.is_constant()) return value;
    if (diagnostics.error_count() == errors_before)
      diagnostics.error("lock-value", {source, expression->span}, fmt::format("'{}' is not a number", text));
  } catch (const language::SyntaxError&) {
  }
  return model::Quantity();
}

// Splits `hand_* = 0  elbow = 0.3` into pairs of a name and a value. A value with blanks is in parentheses.
class LockReader {
 public:
  LockReader(const std::vector<std::string>& words, Diagnostics& diagnostics)
      : source_(std::make_shared<const Source>("--lock", fmt::format("{}", fmt::join(words, " ")))),
        text_(source_->text()),
        diagnostics_(diagnostics) {}

  std::vector<model::Lock> read() {
    std::vector<model::Lock> locks;
    for (skip_blanks(); next_ < text_.size(); skip_blanks()) {
      const Span name = word(" \t\n,=");
      skip_blanks();
      if (name.begin == name.end || next_ == text_.size() || text_[next_] != '=') {
        report(name);
        return locks;
      }
      ++next_;
      skip_blanks();
      const bool is_list = next_ < text_.size() && text_[next_] == '(';
      const Span value = is_list ? list() : word(" \t\n,=");
      if (value.begin == value.end) {
        report(name);
        return locks;
      }
      model::Lock lock = {{at(name), {source_, name}}, {}};
      if (is_list)
        lock.quaternion = quaternion(value);
      else
        lock.position = constant(at(value), diagnostics_);
      locks.push_back(std::move(lock));
    }
    return locks;
  }

 private:
  std::shared_ptr<const Source> source_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t next_ = 0;

  std::string at(const Span& span) const { return std::string(text_.substr(span.begin, span.end - span.begin)); }

  void skip_blanks() { next_ = std::min(text_.find_first_not_of(" \t\n,", next_), text_.size()); }

  Span word(std::string_view ends) {
    const std::size_t begin = next_;
    next_ = std::min(text_.find_first_of(ends, begin), text_.size());
    return {begin, next_};
  }

  // Up to the closing parenthesis of the one that is next.
  Span list() {
    const std::size_t begin = next_;
    int depth = 0;
    do {
      if (text_[next_] == '(') ++depth;
      if (text_[next_] == ')') --depth;
      ++next_;
    } while (depth > 0 && next_ < text_.size());
    return {begin, next_};
  }

  // Four numbers with commas or blanks between them.
  std::optional<std::array<model::Quantity, 4>> quaternion(const Span& span) {
    std::vector<std::string> numbers;
    const std::string inner = at({span.begin + 1, span.end - 1});
    for (std::size_t end = 0, begin = 0; (begin = inner.find_first_not_of(" \t\n,", end)) != std::string::npos;) {
      end = std::min(inner.find_first_of(" \t\n,", begin), inner.size());
      numbers.push_back(inner.substr(begin, end - begin));
    }
    if (text_[span.end - 1] != ')' || numbers.size() != 4) {
      diagnostics_.error(
          "lock-syntax", {source_, span}, "a list must have the four numbers of a quaternion: (w, x, y, z)");
      return std::nullopt;
    }
    std::array<model::Quantity, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = constant(numbers[i], diagnostics_);
    return result;
  }

  void report(Span name) {
    if (name.begin == name.end) name.end = std::min(name.begin + 1, text_.size());
    diagnostics_
        .error("lock-syntax", {source_, name}, fmt::format("expected a name, '=' and a position at '{}'", at(name)))
        .hint = "write elbow = 0.3, or hand_* = 0";
  }
};

std::vector<model::NamePattern> patterns(const std::string& option, const std::vector<std::string>& words) {
  const std::vector<Place> places = places_of(option, words);
  std::vector<model::NamePattern> result;
  for (std::size_t k = 0; k < words.size(); ++k) result.push_back({words[k], places[k]});
  return result;
}

}  // namespace

model::Changes read_changes(const ChangeOptions& options, Diagnostics& diagnostics) {
  model::Changes changes;
  changes.locks = LockReader(options.locks, diagnostics).read();
  changes.kept = patterns("--keep", options.kept);
  changes.parameters = patterns("--parameters", options.parameters);
  return changes;
}

}  // namespace robcogen::driver
