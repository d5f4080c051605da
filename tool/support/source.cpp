#include "support/source.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace robcogen {

Source::Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  line_starts_.push_back(std::string_view(text_).starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const bool is_lone_return = text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n');
    if (text_[i] == '\n' || is_lone_return) line_starts_.push_back(i + 1);
  }
}

Source::Source(std::shared_ptr<const Source> first) : Source(first->name(), "") {
  uses_.push_back({std::move(first)});
}

std::size_t Source::use(std::shared_ptr<const Source> source, Span user, std::string note) {
  const Use& last = uses_.back();
  const std::size_t begin = last.begin + last.source->text().size() + 1;
  uses_.push_back({std::move(source), begin, user, std::move(note)});
  return begin;
}

const Source::Use* Source::use_at(std::size_t offset) const {
  const auto next = std::upper_bound(
      uses_.begin(), uses_.end(), offset, [](std::size_t at, const Use& use) { return at < use.begin; });
  return next == uses_.begin() ? nullptr : &*std::prev(next);
}

LineColumn Source::locate(std::size_t offset) const {
  offset = std::clamp(offset, line_starts_.front(), text_.size());
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<std::size_t>(next - line_starts_.begin());
  return {line, offset - line_starts_[line - 1] + 1};
}

std::string_view Source::line_at(std::size_t offset) const {
  const std::size_t line = locate(offset).line;
  const std::size_t begin = line_starts_[line - 1];
  std::size_t end = line < line_starts_.size() ? line_starts_[line] : text_.size();
  while (end > begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  return std::string_view(text_).substr(begin, end - begin);
}

}  // namespace robcogen
