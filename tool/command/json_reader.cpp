#include "command/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "command/status.h"

namespace robcogen::command {

using nlohmann::json;

const JsonValue* JsonValue::find(const std::string& name) const {
  const auto place = std::find(names().begin(), names().end(), name);
  return place == names().end() ? nullptr : &values()[static_cast<std::size_t>(place - names().begin())];
}

std::string describe(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return "a truth value";
    case JsonValue::Kind::number:
      return fmt::format("the number {}", value.number);
    case JsonValue::Kind::text:
      return fmt::format("the string \"{}\"", value.content->text);
    case JsonValue::Kind::object:
      return "an object";
    case JsonValue::Kind::array:
      break;
  }
  const std::size_t count = value.values().size();
  const bool has_numbers = std::all_of(
      value.values().begin(), value.values().end(), [](const JsonValue& element) { return element.is_number(); });
  return fmt::format("an array of {} {}{}", count, has_numbers ? "number" : "element", count == 1 ? "" : "s");
}

void refuse_input(std::size_t line, const std::string& message) {
  throw Failure{wrong_input, fmt::format("<standard input>:{}: error: {}", line, message)};
}

namespace {

// Whether the token ends in NaN or infinity as other programs write them, up to where the parser stopped. The token may
// begin earlier.
bool is_special(const std::string& token) {
  std::size_t begin = token.size();
  while (begin > 0 && std::isalpha(static_cast<unsigned char>(token[begin - 1]))) --begin;
  const std::string word = token.substr(begin);
  return word == "N" || word == "na" || word == "I" || word == "i";
}

}  // namespace

// The input of nlohmann's parser; copies share the position of the reader.
class JsonReader::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  explicit Iterator(JsonReader* reader) : reader_(reader) {}
  char operator*() const { return static_cast<char>(reader_->peek()); }
  Iterator& operator++() {
    reader_->take();
    return *this;
  }
  // Only compared with the end.
  bool operator==(const Iterator& /*end*/) const { return reader_->peek() == EOF || reader_->size_ >= kMaxSize; }
  bool operator!=(const Iterator& end) const { return !(*this == end); }

 private:
  JsonReader* reader_;
};

// Builds the value from the parser's events.
class JsonReader::Handler : public nlohmann::json_sax<json> {
 public:
  explicit Handler(const JsonReader& reader) : reader_(reader) {}
  JsonValue take_result() { return std::move(result_); }

  bool null() override { return add({JsonValue::Kind::null, reader_.line_}); }
  bool boolean(bool /*value*/) override { return add({JsonValue::Kind::boolean, reader_.line_}); }
  bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add_number(value); }
  bool string(string_t& value) override {
    JsonValue text = with_content(JsonValue::Kind::text);
    text.content->text = std::move(value);
    return add(std::move(text));
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON text has none

  bool start_object(std::size_t /*size*/) override { return open(JsonValue::Kind::object); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*size*/) override { return open(JsonValue::Kind::array); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (!known_.back().insert(name).second)
      refuse_input(reader_.line_, fmt::format("'{}' is given twice [duplicate-key]", name));
    open_.back().content->names.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t /*position*/, const std::string& token, const json::exception& fault) override {
    if (fault.id == 406)
      refuse_input(reader_.line_, fmt::format("the number {} is beyond the range of double [number-overflow]", token));
    // `[json.exception.parse_error.101] parse error at line 1, column 8: what is wrong`; the line is counted in the
    // object.
    const std::string what = fault.what();
    const std::size_t column = what.find(", column ");
    const std::size_t colon = column == std::string::npos ? column : what.find(": ", column);
    const std::string message = colon == std::string::npos ? what : what.substr(colon + 2);
    refuse_input(
        reader_.line_ - (reader_.ended_line_ ? 1 : 0),
        fmt::format(
            "{} [json-syntax]{}", message, is_special(token) ? "\nhint: JSON has neither NaN nor infinity" : ""));
  }

 private:
  JsonValue with_content(JsonValue::Kind kind) const {
    return {kind, reader_.line_, 0, std::make_unique<JsonValue::Content>()};
  }

  // The parser has already read the byte after a number, to find its end.
  bool add_number(double value) {
    return add({JsonValue::Kind::number, reader_.line_ - (reader_.ended_line_ ? 1 : 0), value});
  }

  bool add(JsonValue value) {
    if (open_.empty())
      result_ = std::move(value);
    else
      open_.back().content->values.push_back(std::move(value));
    return true;
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() == kMaxDepth)
      refuse_input(reader_.line_, fmt::format("values are nested deeper than {} levels [too-deep]", kMaxDepth));
    open_.push_back(with_content(kind));
    known_.emplace_back();
    return true;
  }

  bool close() {
    JsonValue value = std::move(open_.back());
    open_.pop_back();
    known_.pop_back();
    return add(std::move(value));
  }

  const JsonReader& reader_;
  std::vector<JsonValue> open_;
  std::vector<std::set<std::string>> known_;  // member names of each
  JsonValue result_;
};

int JsonReader::peek() {
  if (ahead_) return *ahead_;
  errno = 0;
  ahead_ = std::getc(file_);
  if (*ahead_ == EOF && std::ferror(file_))
    throw Failure{
        wrong_usage,
        fmt::format("robcogen: error: cannot read standard input: {}", std::generic_category().message(errno))};
  return *ahead_;
}

void JsonReader::take() {
  ended_line_ = peek() == '\n';
  line_ += ended_line_ ? 1 : 0;
  ++size_;
  if (peek() != EOF) ahead_.reset();
}

// Returns the byte that follows the white space, without taking it.
int JsonReader::skip_space() {
  for (size_ = 0; peek() == ' ' || peek() == '\t' || peek() == '\r' || peek() == '\n'; take())
    if (size_ == kMaxSize)
      refuse_input(line_, fmt::format("more than {} MiB of white space [input-too-long]", kMaxSize >> 20));
  return peek();
}

void JsonReader::begin_array() {
  in_array_ = true;
  take();
  is_over_ = skip_space() == ']';
  if (is_over_) take();
}

// Takes the comma or the bracket after an object. Returns false at the end of the array.
bool JsonReader::go_on_in_array() {
  const int mark = skip_space();
  if (mark != ',' && mark != ']') refuse_input(line_, "expected ',' or ']' after an object of the array [json-syntax]");
  take();
  return mark == ',';
}

std::optional<JsonValue> JsonReader::next() {
  const bool begins = std::exchange(is_first_, false);
  if (begins && skip_space() == '[') begin_array();
  if (!begins && in_array_ && !is_over_) is_over_ = !go_on_in_array();
  const int first = skip_space();
  if (in_array_ && is_over_) {
    if (first != EOF) refuse_input(line_, "unexpected input after the array of states [json-syntax]");
    return std::nullopt;
  }
  if (first == EOF && !in_array_ && !begins) return std::nullopt;
  if (first != '{') {
    const std::string found = first == EOF          ? "the end of the input"
                              : std::isprint(first) ? fmt::format("'{}'", static_cast<char>(first))
                                                    : fmt::format("byte {}", first);
    refuse_input(
        line_, fmt::format(
                   "expected an object, such as {{\"q\": [0.1]}}, found {} [json-syntax]\nhint: a function without "
                   "arguments takes {{}}",
                   found));
  }
  return read_object();
}

JsonValue JsonReader::read_object() {
  size_ = 0;
  Handler handler(*this);
  try {
    json::sax_parse(Iterator(this), Iterator(this), &handler, json::input_format_t::json, false);
  } catch (const Failure&) {
    if (size_ < kMaxSize) throw;
    refuse_input(line_, fmt::format("an object of more than {} MiB [input-too-long]", kMaxSize >> 20));
  }
  return handler.take_result();
}

}  // namespace robcogen::command
