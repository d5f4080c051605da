// Source text and places in it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen {

// Some editors write this mark before a text in UTF-8. It is not part of the text, nor of its first line.
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

// A named text, whose lines end with LF, CR LF or CR. The name is what messages show: a path, or `<standard input>`.
//
// A source may also stand for several texts, and some of them many times over, such as a document into which parts were
// put. Each use of a text has offsets of its own, and says where it was used.
class Source {
 public:
  // A use of the text of `source` by the text at `user`. The offsets of this use start at `begin`.
  struct Use {
    std::shared_ptr<const Source> source;
    std::size_t begin = 0;
    Span user = {};         // in offsets of the whole, before `begin`
    std::string note = {};  // what a message says at `user`; empty for the first text, which nothing uses
  };

  Source(std::string name, std::string text);
  // A source of several texts. The offsets of the first one are its own.
  explicit Source(std::shared_ptr<const Source> first);
  // Adds a further text, used by the text at `user`. Returns the offset at which it begins.
  std::size_t use(std::shared_ptr<const Source> source, Span user, std::string note);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  LineColumn locate(std::size_t offset) const;
  // The line that contains this offset, without its end.
  std::string_view line_at(std::size_t offset) const;

  // The use that an offset belongs to; nullptr if the source has a text of its own.
  const Use* use_at(std::size_t offset) const;

 private:
  std::string name_;
  std::string text_;
  std::vector<std::size_t> line_starts_;
  std::vector<Use> uses_;  // sorted by `begin`
};

}  // namespace robcogen
