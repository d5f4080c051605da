// Positions in the protocol, which are lines and characters counted from 0, of a text whose places are byte offsets.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "server/json.h"
#include "support/source.h"

namespace robcogen::server {

// The unit of a character: a byte, or a UTF-16 code unit, of which characters beyond U+FFFF have two.
enum class PositionEncoding { utf8, utf16 };

struct Position {
  std::size_t line = 0;
  std::size_t character = 0;
};

class Positions {
 public:
  // Lines end with LF, CR LF or CR.
  Positions(std::shared_ptr<const Source> source, PositionEncoding encoding);

  const Source& source() const { return *source_; }
  std::string_view text() const { return source_->text(); }

  Position position(std::size_t offset) const;
  // A character beyond the end of its line refers to that end; a line beyond the last one refers to the end of the
  // text.
  std::size_t offset(const Position& position) const;
  std::size_t line_count() const { return line_starts_.size(); }
  std::size_t line_end(std::size_t line) const;  // before the line end characters

  Json json(std::size_t offset) const;
  Json json(const Span& span) const;
  // The range that an editor underlines: as on the command line, at most one line and at least one character.
  Json underlined(const Span& span) const;
  // Reads a value of the protocol. Throws an exception of the JSON library if it is malformed.
  std::size_t offset(const Json& position) const;
  Span span(const Json& range) const;

 private:
  std::shared_ptr<const Source> source_;
  std::vector<std::size_t> line_starts_;
  std::vector<std::size_t> units_;  // units before each block of bytes; empty if each byte is a unit

  std::size_t units_before(std::size_t offset) const;
};

}  // namespace robcogen::server
