// Source text and places in it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen {

// Some editors write it before a text in UTF-8. It is not part of the text, nor of its first line.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// Half-open range of byte offsets into one source text.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct LineColumn {
  std::size_t line = 1;    // from 1
  std::size_t column = 1;  // from 1, in bytes
};

// A named text; its lines end with LF, CR LF or CR. The name is what messages show: a path, or `<standard input>`.
class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  LineColumn locate(std::size_t offset) const;
  // The line (without its end) that holds this offset.
  std::string_view line_at(std::size_t offset) const;

 private:
  std::string name_;
  std::string text_;
  std::vector<std::size_t> line_starts_;
};

}  // namespace robcogen
