#include "support/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen {
namespace {

constexpr std::size_t kWidest = 160;  // columns of source shown

std::string label(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

std::string head(
    const Place& place,
    const std::string& kind,
    const std::string& code,
    const std::string& message,
    ErrorFormat format) {
  std::string where = "robcogen";
  if (place.source) {
    const LineColumn at = place.source->locate(place.span.begin);
    where = format == ErrorFormat::gnu ? fmt::format("{}:{}:{}", place.source->name(), at.line, at.column)
                                       : fmt::format("{}({},{})", place.source->name(), at.line, at.column);
  }
  if (format == ErrorFormat::msvc && !code.empty()) return fmt::format("{}: {} {}: {}\n", where, kind, code, message);
  return fmt::format("{}: {}: {}{}\n", where, kind, message, code.empty() ? "" : fmt::format(" [{}]", code));
}

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// The source line and carets under the place. Control characters show as blanks, tabs stay so that columns line up.
std::string excerpt(const Place& place) {
  if (!place.source) return "";
  const std::string_view line = place.source->line_at(place.span.begin);
  const std::size_t column = place.source->locate(place.span.begin).column - 1;
  std::size_t begin = column > kWidest / 2 ? column - kWidest / 2 : 0;
  if (line.size() <= kWidest) begin = 0;
  std::size_t end = std::min(line.size(), begin + kWidest);
  while (begin < end && begin > 0 && is_continuation(line[begin])) ++begin;
  while (end > begin && end < line.size() && is_continuation(line[end])) --end;

  std::string text(line.substr(begin, end - begin)), carets;
  for (char& c : text)
    if (c != '\t' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)) c = ' ';
  for (std::size_t i = begin; i < std::min(column, end); ++i)
    if (!is_continuation(line[i])) carets += line[i] == '\t' ? '\t' : ' ';
  carets += '^';
  const std::size_t length = place.span.end > place.span.begin ? place.span.end - place.span.begin : 1;
  for (std::size_t i = column + 1; i < std::min(column + length, end); ++i)
    if (!is_continuation(line[i])) carets += '~';
  return fmt::format("    {}\n    {}\n", text, carets);
}

std::string render_one(const Diagnostic& d, ErrorFormat format) {
  std::string out = head(d.place, label(d.severity), d.code, d.message, format) + excerpt(d.place);
  for (const Note& note : d.notes) out += head(note.place, "note", "", note.message, format) + excerpt(note.place);
  if (!d.hint.empty()) out += fmt::format("hint: {}\n", d.hint);
  return out;
}

}  // namespace

Diagnostic& Diagnostics::error(std::string code, Place place, std::string message) {
  return list_.emplace_back(Diagnostic{Severity::error, std::move(code), std::move(message), std::move(place), {}, {}});
}

Diagnostic& Diagnostics::warning(std::string code, Place place, std::string message) {
  return list_.emplace_back(
      Diagnostic{Severity::warning, std::move(code), std::move(message), std::move(place), {}, {}});
}

bool Diagnostics::has_errors() const {
  return error_count() > 0;
}

std::size_t Diagnostics::error_count() const {
  return static_cast<std::size_t>(
      std::count_if(list_.begin(), list_.end(), [](const Diagnostic& d) { return d.severity == Severity::error; }));
}

void Diagnostics::promote_warnings(const std::vector<std::string>& codes) {
  for (Diagnostic& d : list_)
    if (std::find(codes.begin(), codes.end(), d.code) != codes.end()) d.severity = Severity::error;
}

std::string Diagnostics::render(ErrorFormat format, std::size_t max_errors) const {
  std::vector<const Diagnostic*> sorted;
  std::vector<const Source*> sources;  // in the order of their first diagnostic
  for (const Diagnostic& d : list_) {
    sorted.push_back(&d);
    if (std::find(sources.begin(), sources.end(), d.place.source.get()) == sources.end())
      sources.push_back(d.place.source.get());
  }
  const auto rank = [&](const Diagnostic* d) {
    return std::pair(
        std::find(sources.begin(), sources.end(), d->place.source.get()) - sources.begin(), d->place.span.begin);
  };
  std::stable_sort(
      sorted.begin(), sorted.end(), [&](const Diagnostic* a, const Diagnostic* b) { return rank(a) < rank(b); });
  std::string out;
  for (std::size_t i = 0; i < std::min(max_errors, sorted.size()); ++i) out += render_one(*sorted[i], format);
  if (sorted.size() > max_errors) out += fmt::format("… and {} more\n", sorted.size() - max_errors);
  return out;
}

std::string render(const Diagnostic& d, ErrorFormat format) {
  return render_one(d, format);
}

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  // Levenshtein distance, bounded: a third of the word may be wrong.
  const std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
  std::size_t best = limit + 1;
  std::string found;
  std::vector<std::size_t> row;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(candidate.size(), word.size());
    if (longer - std::min(candidate.size(), word.size()) > limit || longer > 200) continue;
    row.resize(word.size() + 1);
    for (std::size_t i = 0; i <= word.size(); ++i) row[i] = i;
    for (std::size_t j = 1; j <= candidate.size(); ++j) {
      std::size_t diagonal = row[0];
      row[0] = j;
      for (std::size_t i = 1; i <= word.size(); ++i) {
        const std::size_t substituted = diagonal + (word[i - 1] == candidate[j - 1] ? 0 : 1);
        diagonal = row[i];
        row[i] = std::min({row[i] + 1, row[i - 1] + 1, substituted});
      }
    }
    if (row[word.size()] < best) {
      best = row[word.size()];
      found = candidate;
    }
  }
  return found;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string found = nearest(word, candidates);
  return found.empty() ? "" : fmt::format("did you mean '{}'?", found);
}

}  // namespace robcogen
