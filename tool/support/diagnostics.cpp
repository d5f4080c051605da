#include "support/diagnostics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

namespace robcogen {
namespace {

constexpr std::size_t kMaxColumns = 160;  // the most that is shown of a source line
constexpr std::size_t kMaxKept = 10000;   // of each severity: many megabytes of garbage must not fill the memory

std::size_t beyond(std::size_t count, std::size_t most) {
  return count > most ? count - most : 0;
}

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

// The number of bytes of the UTF-8 character at the beginning of the text; 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!is_continuation(text[i])) return 0;
  return length;
}

// How one character is shown: a control character as a blank, a byte that is not UTF-8 as '?'. Tabs are kept, also in
// the line of carets, so that columns are aligned.
std::string shown(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  if (lead >= 0x80 && character_length(character) == 0) return "?";
  const bool is_control = lead < 0x20 || lead == 0x7F;
  const bool is_wide_control = lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;  // U+0080 to U+009F
  return lead != '\t' && (is_control || is_wide_control) ? " " : std::string(character);
}

// The source line, or the part of it around the place, and carets under the place.
std::string excerpt(const Place& place) {
  if (!place.source) return "";
  const std::string_view line = place.source->line_at(place.span.begin);
  const std::size_t mark = place.source->locate(place.span.begin).column - 1;
  const std::size_t mark_end = mark + std::max(place.span.end, place.span.begin) - place.span.begin;
  std::size_t begin = line.size() <= kMaxColumns || mark <= kMaxColumns / 2 ? 0 : mark - kMaxColumns / 2;
  for (int i = 0; i < 3 && begin > 0 && begin < mark && is_continuation(line[begin]); ++i) ++begin;
  const std::size_t end = std::min(line.size(), begin + kMaxColumns);

  std::string text = begin > 0 ? "…" : "", carets = begin > 0 ? " " : "";
  for (std::size_t i = begin; i < end;) {
    const std::size_t length = std::max<std::size_t>(1, character_length(line.substr(i)));
    const std::string character = shown(line.substr(i, length));
    text += character;
    if (i + length <= mark) {
      carets += character == "\t" ? "\t" : " ";
    } else if (i <= mark) {
      carets += "^";
    } else if (i < mark_end) {
      carets += "~";
    }
    i += length;
  }
  if (mark >= end) carets += "^";
  if (end < line.size()) text += "…";
  return fmt::format("    {}\n    {}\n", text, carets);
}

bool is_error(const Diagnostic& d) {
  return d.severity == Severity::error;
}

// Adds a note for the use of the text that holds the place, then for the use of the text that uses it, and so on.
void add_uses(Place place, std::vector<Note>& notes) {
  while (place.source) {
    const Source::Use* use = place.source->use_at(place.span.begin);
    if (use == nullptr || use->note.empty()) return;
    place.span = use->user;
    notes.push_back({place, use->note});
  }
}

std::string render_one(const Diagnostic& d, ErrorFormat format) {
  const Place place = written_at(d.place);
  std::string out = head(place, label(d.severity), d.code, d.message, format);
  for (const std::string& line : d.details) out += fmt::format("    {}\n", line);
  if (d.details.empty()) out += excerpt(place);
  std::vector<Note> notes = d.notes;
  add_uses(d.place, notes);
  for (const Note& note : notes) {
    const Place written = written_at(note.place);
    out += head(written, "note", "", note.message, format) + excerpt(written);
  }
  if (!d.hint.empty()) out += fmt::format("hint: {}\n", d.hint);
  return out;
}

// The line after the first of several notes with one code: where the others are.
std::string more_like_it(const std::vector<const Diagnostic*>& notes) {
  constexpr std::size_t kMaxLines = 8;
  std::vector<std::size_t> lines;
  for (std::size_t i = 1; i < notes.size(); ++i) {
    const Place place = written_at(notes[i]->place);
    if (place.source) lines.push_back(place.source->locate(place.span.begin).line);
  }
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  const bool has_more = lines.size() > kMaxLines;
  if (has_more) lines.resize(kMaxLines);
  return fmt::format(
      "… and {} more note{} [{}]{}{}; --verbose shows all\n", notes.size() - 1, notes.size() == 2 ? "" : "s",
      notes.front()->code,
      lines.empty() ? "" : fmt::format(", line{} {}", lines.size() == 1 ? "" : "s", fmt::join(lines, ", ")),
      has_more ? ", …" : "");
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

constexpr std::size_t kMaxCompared = 200;

// The number of insertions, deletions, substitutions and exchanges of neighbours (optimal string alignment) that turn
// one word into the other. Upper and lower case count as the same.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(a.size() + 1), last(a.size() + 1), row(a.size() + 1);
  for (std::size_t i = 0; i <= a.size(); ++i) row[i] = i;
  for (std::size_t j = 1; j <= b.size(); ++j) {
    before_last.swap(last);
    last.swap(row);
    row[0] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
      const char x = lower(a[i - 1]), y = lower(b[j - 1]);
      row[i] = std::min({row[i - 1] + 1, last[i] + 1, last[i - 1] + (x == y ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && x == lower(b[j - 2]) && lower(a[i - 2]) == y;
      if (exchanged) row[i] = std::min(row[i], before_last[i - 2] + 1);
    }
  }
  return row[a.size()];
}

// Whether the word is the candidate with its last letter twice, as in `Ixx`.
bool doubles_last_letter(const std::string& word, const std::string& candidate) {
  const std::size_t size = candidate.size();
  return size > 0 && word.size() == size + 1 && edit_distance(word.substr(0, size), candidate) == 0 &&
         lower(word[size]) == lower(word[size - 1]);
}

// Decides between candidates that are equally near.
int preference(const std::string& word, const std::string& candidate) {
  if (doubles_last_letter(word, candidate)) return 2;
  return candidate.size() == word.size() ? 1 : 0;
}

}  // namespace

Place written_at(const Place& place) {
  const Source::Use* use = place.source ? place.source->use_at(place.span.begin) : nullptr;
  if (use == nullptr) return place;
  return {use->source, {place.span.begin - use->begin, place.span.end - use->begin}};
}

Diagnostic& Diagnostics::error(std::string code, Place place, std::string message) {
  return add({Severity::error, std::move(code), std::move(message), std::move(place), {}, {}, {}});
}

Diagnostic& Diagnostics::warning(std::string code, Place place, std::string message) {
  return add({Severity::warning, std::move(code), std::move(message), std::move(place), {}, {}, {}});
}

Diagnostic& Diagnostics::note(std::string code, Place place, std::string message) {
  return add({Severity::note, std::move(code), std::move(message), std::move(place), {}, {}, {}});
}

void Diagnostics::summarise_notes(const std::string& code, std::string message) {
  summaries_[code] = std::move(message);
}

Diagnostic& Diagnostics::add(Diagnostic diagnostic) {
  std::size_t& count = diagnostic.severity == Severity::error ? errors_added_ : warnings_added_;
  return ++count <= kMaxKept ? list_.emplace_back(std::move(diagnostic)) : unkept_ = std::move(diagnostic);
}

bool Diagnostics::has_errors() const {
  return error_count() > 0;
}

std::size_t Diagnostics::error_count() const {
  return beyond(errors_added_, kMaxKept) +
         static_cast<std::size_t>(std::count_if(list_.begin(), list_.end(), is_error));
}

void Diagnostics::promote_warnings(const std::vector<std::string>& codes) {
  for (Diagnostic& d : list_)
    if (std::find(codes.begin(), codes.end(), d.code) != codes.end()) d.severity = Severity::error;
}

std::string Diagnostics::render(const Rendering& rendering) const {
  const auto& [format, folds_notes, max_errors] = rendering;
  std::vector<const Diagnostic*> sorted;
  std::vector<const Source*> sources;  // in the order of their first diagnostic
  for (const Diagnostic& d : list_) {
    sorted.push_back(&d);
    const Place place = written_at(d.place);
    if (std::find(sources.begin(), sources.end(), place.source.get()) == sources.end())
      sources.push_back(place.source.get());
  }
  const auto rank = [&](const Diagnostic* d) {
    const Place place = written_at(d->place);
    return std::pair(std::find(sources.begin(), sources.end(), place.source.get()) - sources.begin(), place.span.begin);
  };
  std::stable_sort(
      sorted.begin(), sorted.end(), [&](const Diagnostic* a, const Diagnostic* b) { return rank(a) < rank(b); });
  std::map<std::pair<std::string, const Source*>, std::vector<const Diagnostic*>> alike;
  if (folds_notes)
    for (const Diagnostic* d : sorted)
      if (d->severity == Severity::note) alike[{d->code, written_at(d->place).source.get()}].push_back(d);
  std::string out;
  std::size_t errors = 0, warnings = 0;
  for (const Diagnostic* d : sorted) {
    const auto notes = alike.find({d->code, written_at(d->place).source.get()});
    const bool is_folded = notes != alike.end() && notes->second.size() > 1 && d->severity == Severity::note;
    if (is_folded && d != notes->second.front()) continue;
    std::size_t& count = is_error(*d) ? errors : warnings;
    if (++count > max_errors) continue;
    const auto summary = is_folded ? summaries_.find(d->code) : summaries_.end();
    if (summary != summaries_.end()) {
      out += head(written_at(d->place), "note", d->code, summary->second, format);
    } else {
      out += render_one(*d, format);
      if (is_folded) out += more_like_it(notes->second);
    }
  }
  const std::size_t more_errors = beyond(errors + beyond(errors_added_, kMaxKept), max_errors);
  const std::size_t more_warnings = beyond(warnings + beyond(warnings_added_, kMaxKept), max_errors);
  if (more_errors > 0) out += fmt::format("… and {} more errors\n", more_errors);
  if (more_warnings > 0) out += fmt::format("… and {} more warnings\n", more_warnings);
  return out;
}

std::string render(const Diagnostic& d, ErrorFormat format) {
  return render_one(d, format);
}

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  // At most a third of the word may be wrong.
  const std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
  std::size_t best = limit + 1;
  std::string found;
  for (const std::string& candidate : candidates) {
    const auto [shorter, longer] = std::minmax({candidate.size(), word.size()});
    if (longer - shorter > limit || longer > kMaxCompared) continue;
    const std::size_t edits = edit_distance(word, candidate);
    const bool is_nearer = edits < best || (edits == best && preference(word, candidate) > preference(word, found));
    if (!is_nearer || edits >= shorter) continue;
    best = edits;
    found = candidate;
  }
  return found;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string found = nearest(word, candidates);
  return found.empty() ? "" : fmt::format("did you mean '{}'?", found);
}

}  // namespace robcogen
