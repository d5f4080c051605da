#include "server/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

namespace robcogen::server {
namespace {

constexpr std::string_view kLength = "Content-Length:";
constexpr std::string_view kEnd = "\r\n\r\n";
constexpr std::size_t kMaxHeaderSize = 4096;  // bytes

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

// Field names are case-insensitive.
std::size_t find_length(std::string_view text, std::size_t from = 0) {
  const auto same = [](char a, char b) { return lower(a) == lower(b); };
  const auto begin = text.begin() + static_cast<std::ptrdiff_t>(std::min(from, text.size()));
  const auto found = std::search(begin, text.end(), kLength.begin(), kLength.end(), same);
  return found == text.end() ? std::string_view::npos : static_cast<std::size_t>(found - text.begin());
}

// Returns the number after the field name; nullopt if there is none, or if other text follows it.
std::optional<std::size_t> length_of(std::string_view header) {
  const std::size_t field = find_length(header);
  if (field == std::string_view::npos || (field > 0 && header[field - 1] != '\n')) return std::nullopt;
  std::string_view value = header.substr(field + kLength.size());
  value = value.substr(0, value.find('\r'));
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  while (!value.empty() && value.back() == ' ') value.remove_suffix(1);
  std::size_t length = 0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), length);
  if (fault != std::errc() || end != value.data() + value.size() || length > kMaxContentSize) return std::nullopt;
  return length;
}

}  // namespace

void FrameReader::feed(std::string_view bytes) {
  buffer_ += bytes;
}

void FrameReader::drop(std::size_t count) {
  at_ += count;
  searched_ = 0;
  if (at_ < buffer_.size() / 2) return;
  buffer_.erase(0, at_);
  at_ = 0;
}

std::optional<Frame> FrameReader::lose(std::size_t used, std::string fault) {
  drop(used);
  if (is_lost_) return std::nullopt;
  is_lost_ = true;
  return Frame{"", std::move(fault)};
}

// Drops the bytes before the next header.
bool FrameReader::find_header() {
  const std::string_view rest = std::string_view(buffer_).substr(at_);
  const std::size_t found = find_length(rest);
  // The buffer may end with the beginning of the field name.
  const std::size_t skipped =
      found != std::string_view::npos ? found : rest.size() - std::min(rest.size(), kLength.size());
  drop(skipped);
  return found != std::string_view::npos;
}

std::optional<Frame> FrameReader::next() {
  while (true) {
    if (is_lost_ && !find_header()) return std::nullopt;
    const std::string_view rest = std::string_view(buffer_).substr(at_);
    const std::size_t end = rest.find(kEnd, searched_);
    if (end == std::string_view::npos) {
      if (rest.size() <= kMaxHeaderSize) {
        searched_ = rest.size() - std::min(rest.size(), kEnd.size());
        return std::nullopt;
      }
      if (std::optional<Frame> fault = lose(kLength.size(), "a header has no end")) return fault;
      continue;
    }
    const std::optional<std::size_t> length = end <= kMaxHeaderSize ? length_of(rest.substr(0, end + 2)) : std::nullopt;
    if (!length) {
      // A valid header may follow the broken line without an empty line in between.
      const std::size_t other = find_length(rest.substr(0, end), 1);
      const std::size_t used = other == std::string_view::npos ? end + kEnd.size() : other;
      if (std::optional<Frame> fault = lose(used, "a header has no valid 'Content-Length'")) return fault;
      continue;
    }
    searched_ = end;
    if (rest.size() - end - kEnd.size() < *length) return std::nullopt;
    Frame frame = {std::string(rest.substr(end + kEnd.size(), *length)), ""};
    is_lost_ = false;
    drop(end + kEnd.size() + *length);
    return frame;
  }
}

void FrameReader::reread(std::string_view content) {
  const std::size_t found = find_length(content);
  if (found == std::string_view::npos) return;
  buffer_.replace(0, at_, content.substr(found));
  at_ = 0;
  searched_ = 0;
}

std::string framed(std::string_view content) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", content.size(), content);
}

}  // namespace robcogen::server
