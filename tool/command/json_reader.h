// Reads JSON values one after the other from a stream, which may be an endless pipe: each value is returned as soon as
// its last byte has arrived.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace robcogen::command {

// A value, and the line on which it stands.
struct JsonValue {
  enum class Kind { null, boolean, number, text, array, object };
  // The members that a number does not have. They are separate, so that an array of numbers is small.
  struct Content {
    std::string text;
    std::vector<std::string> names;  // of an object's members
    std::vector<JsonValue> values;   // of an array's or an object's members
  };

  Kind kind = Kind::null;
  std::size_t line = 0;  // from 1; of an array or object, its first line
  double number = 0;
  std::unique_ptr<Content> content = nullptr;  // of texts, arrays and objects

  bool is_number() const { return kind == Kind::number; }
  bool is_array() const { return kind == Kind::array; }
  bool is_object() const { return kind == Kind::object; }
  const std::vector<JsonValue>& values() const { return content->values; }
  const std::vector<std::string>& names() const { return content->names; }
  // The member of an object; nullptr if it has none of this name.
  const JsonValue* find(const std::string& name) const;
};

// `a string`, `an array of 3 numbers`: for messages about an unexpected value.
std::string describe(const JsonValue& value);

// Throws the Failure `<standard input>:<line>: error: <message>`, status wrong_input.
[[noreturn]] void refuse_input(std::size_t line, const std::string& message);

class JsonReader {
 public:
  // Limits of one object.
  static constexpr std::size_t kMaxSize = std::size_t{16} << 20;  // bytes
  static constexpr std::size_t kMaxDepth = 16;

  // The messages call the stream <standard input>.
  explicit JsonReader(std::FILE* file) : file_(file) {}

  // The next object, from a sequence of objects (one per line, or with any white space between them) or from a single
  // array of objects; nullopt at the end. Throws a Failure with the line for text that is not JSON, for a name that is
  // given twice in an object, for a number outside the range of double, and for an object beyond the limits. Throws a
  // Failure with wrong_usage if reading fails.
  std::optional<JsonValue> next();

  // The line of the last byte, from 1.
  std::size_t line() const { return line_; }

 private:
  class Iterator;
  class Handler;

  int peek();
  void take();
  int skip_space();
  void begin_array();
  bool go_on_in_array();
  JsonValue read_object();

  std::FILE* file_;
  std::optional<int> ahead_;  // read, but not taken
  std::size_t line_ = 1;
  bool ended_line_ = false;  // the byte taken last ended a line
  std::size_t size_ = 0;     // bytes since the last value
  bool in_array_ = false;
  bool is_first_ = true;
  bool is_over_ = false;
};

}  // namespace robcogen::command
