// User errors are values: collected in one list, printed once.
//
// Each diagnostic has a stable code (`two-parents`, `unknown-joint`), a place, and optional notes that point at related
// places. It is rendered as
//     hyl.kindsl:12:5: error: joint 'KFE' connects two links [joint-used-twice]
//         lowerleg via KFE
//         ^~~~~~~~
//     hyl.kindsl:8:5: note: first used here
//     hint: did you mean 'HFE'?
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "support/source.h"

namespace robcogen {

enum class Severity { note, warning, error };
enum class ErrorFormat { gnu, msvc };

// How messages are shown.
struct Rendering {
  ErrorFormat format = ErrorFormat::gnu;
  bool folds_notes = true;       // notes about one source with the same code become one
  std::size_t max_errors = 100;  // so many errors, and as many warnings and notes
};

// A place in a source; `source` is null if there is none.
struct Place {
  std::shared_ptr<const Source> source;
  Span span;
};

// The place in the text in which it was written, if its source stands for several texts.
Place written_at(const Place& place);

struct Note {
  Place place;
  std::string message;
};

struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;     // kebab-case, stable
  std::string message;  // one sentence, no final stop
  Place place;
  std::vector<Note> notes;
  std::string hint;                       // `did you mean 'x'?`; empty if there is none
  std::vector<std::string> details = {};  // lines shown instead of the source line
};

class Diagnostics {
 public:
  // These return the stored diagnostic, so that notes and a hint can be added. After 10,000 errors (or warnings and
  // notes) further ones are counted, but not stored.
  Diagnostic& error(std::string code, Place place, std::string message);
  Diagnostic& warning(std::string code, Place place, std::string message);
  // Information about how the input was read; nothing is wrong.
  Diagnostic& note(std::string code, Place place, std::string message);
  // One sentence that stands for all notes of this code where they are folded.
  void summarise_notes(const std::string& code, std::string message);

  bool has_errors() const;
  std::size_t error_count() const;
  const std::vector<Diagnostic>& all() const { return list_; }
  // `--strict`: the named warnings become errors.
  void promote_warnings(const std::vector<std::string>& codes);
  // All that are shown, sorted by source and place, and a line that counts the rest. Folded notes are shown as their
  // summary, or else as the first of them and the lines of the others.
  std::string render(const Rendering& rendering = {}) const;

 private:
  Diagnostic& add(Diagnostic diagnostic);

  std::vector<Diagnostic> list_;
  std::map<std::string, std::string> summaries_;  // of notes, by code
  Diagnostic unkept_;
  std::size_t errors_added_ = 0;
  std::size_t warnings_added_ = 0;
};

std::string render(const Diagnostic& d, ErrorFormat format = ErrorFormat::gnu);

// The candidate nearest to `word` by edit distance, or empty if none is near enough to be meant. Among equally near
// ones, this is the first of the same length, otherwise the first.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);
// `did you mean 'x'?`, or empty.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace robcogen
