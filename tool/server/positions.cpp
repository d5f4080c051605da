#include "server/positions.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace robcogen::server {
namespace {

constexpr std::size_t kBlock = 256;  // bytes

// Returns the number of code units that begin at this byte of UTF-8. A byte that does not belong to a character counts
// as one unit.
std::size_t units_at(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0xF0) return 2;
  return (byte & 0xC0U) == 0x80U ? 0 : 1;
}

}  // namespace

Positions::Positions(std::shared_ptr<const Source> source, PositionEncoding encoding)
    : source_(std::move(source)), line_starts_{0} {
  const std::string_view text = source_->text();
  bool is_ascii = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_lone_return = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
    if (text[i] == '\n' || is_lone_return) line_starts_.push_back(i + 1);
    is_ascii = is_ascii && static_cast<unsigned char>(text[i]) < 0x80;
  }
  if (is_ascii || encoding == PositionEncoding::utf8) return;
  std::size_t units = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % kBlock == 0) units_.push_back(units);
    units += units_at(text[i]);
  }
}

std::size_t Positions::units_before(std::size_t offset) const {
  if (units_.empty()) return offset;
  const std::size_t block = std::min(offset / kBlock, units_.size() - 1);
  std::size_t units = units_[block];
  for (std::size_t i = block * kBlock; i < offset; ++i) units += units_at(text()[i]);
  return units;
}

Position Positions::position(std::size_t offset) const {
  offset = std::min(offset, text().size());
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const std::size_t begin = *std::prev(next);
  return {static_cast<std::size_t>(next - line_starts_.begin()) - 1, units_before(offset) - units_before(begin)};
}

std::size_t Positions::line_end(std::size_t line) const {
  const std::size_t begin = line_starts_[line];
  std::size_t end = line + 1 < line_starts_.size() ? line_starts_[line + 1] : text().size();
  while (end > begin && (text()[end - 1] == '\n' || text()[end - 1] == '\r')) --end;
  return end;
}

std::size_t Positions::offset(const Position& position) const {
  if (position.line >= line_starts_.size()) return text().size();
  const std::size_t begin = line_starts_[position.line], end = line_end(position.line);
  if (units_.empty()) return begin + std::min(position.character, end - begin);
  const std::size_t wanted = units_before(begin) + position.character;
  // The last block that does not begin after the wanted unit.
  const auto next = std::upper_bound(units_.begin(), units_.end(), wanted);
  const auto block = static_cast<std::size_t>(next - units_.begin()) - 1;
  std::size_t at = std::max(begin, block * kBlock);
  for (std::size_t units = units_before(at); at < end; ++at) {
    units += units_at(text()[at]);
    if (units > wanted) break;
  }
  return at;
}

Json Positions::json(std::size_t offset) const {
  const Position p = position(offset);
  return {{"line", p.line}, {"character", p.character}};
}

Json Positions::json(const Span& span) const {
  return {{"start", json(span.begin)}, {"end", json(std::max(span.begin, span.end))}};
}

Json Positions::underlined(const Span& span) const {
  const std::size_t begin = std::min(span.begin, text().size());
  const std::size_t line = position(begin).line;
  std::size_t end = std::min(std::max(span.end, begin + 1), std::max(begin, line_end(line)));
  while (end < text().size() && end > begin && units_at(text()[end]) == 0) ++end;
  return json(Span{begin, end});
}

std::size_t Positions::offset(const Json& position) const {
  return offset(Position{position.at("line").get<std::size_t>(), position.at("character").get<std::size_t>()});
}

Span Positions::span(const Json& range) const {
  const std::size_t begin = offset(range.at("start"));
  return {begin, std::max(begin, offset(range.at("end")))};
}

}  // namespace robcogen::server
