// Files that hold a document and what a test expects of it:
//
//   Robot Arm { … }
//   ==== list ====
//   Robot Arm Transforms { … }
//   ==== messages ====
//   arm.kindsl:1:13: error: …
//
// The generator sees exactly the bytes before the first marker, and only some documents have a list. A document that
// does not end in a newline has one in the file all the same; the marker after it then says ` (no newline above)`.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen::test {

struct Golden {
  std::string document;
  std::optional<std::string> list;      // desired transforms, as in <name>.dtdsl beside the document
  std::optional<std::string> messages;  // absent if the file states no expectation
};

// The bytes of a file; empty if it cannot be read.
inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Parts of a golden file. Throws std::runtime_error if a marker is unknown or misplaced.
inline Golden golden_of(std::string_view text) {
  constexpr std::string_view kBegin = "==== ", kEnd = " ====", kTorn = " (no newline above)";
  Golden result;
  std::string* part = &result.document;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = std::min(text.find('\n', at), text.size() - 1) + 1;
    std::string_view line = text.substr(at, next - at);
    at = next;
    if (!line.starts_with(kBegin)) {
      *part += line;
      continue;
    }
    const std::string whole(line.substr(0, line.find_last_not_of("\r\n") + 1));
    std::string_view title = std::string_view(whole).substr(kBegin.size());
    if (!title.ends_with(kEnd)) throw std::runtime_error("the marker '" + whole + "' does not end in ' ===='");
    title.remove_suffix(kEnd.size());
    if (title.ends_with(kTorn)) {
      title.remove_suffix(kTorn.size());
      if (!part->ends_with('\n')) throw std::runtime_error("nothing is above the marker '" + whole + "'");
      part->pop_back();
    }
    if (title == "messages" && !result.messages) {
      part = &result.messages.emplace();
    } else if (title == "list" && !result.messages && !result.list) {
      part = &result.list.emplace();
    } else {
      throw std::runtime_error(
          "the marker '" + whole +
          "' is unknown, repeated or misplaced; markers are '==== list ====' "
          "and, last, '==== messages ===='");
    }
  }
  return result;
}

// The text of a golden file; golden_of() is the inverse.
inline std::string text_of(const Golden& golden) {
  std::string text = golden.document;
  const auto append = [&](const char* title, const std::string& above, const std::string& part) {
    const bool is_torn = !above.empty() && !above.ends_with('\n');
    text +=
        std::string(is_torn ? "\n" : "") + "==== " + title + (is_torn ? " (no newline above)" : "") + " ====\n" + part;
  };
  if (golden.list) append("list", golden.document, *golden.list);
  if (golden.messages) append("messages", golden.list.value_or(golden.document), *golden.messages);
  return text;
}

// Reads a golden file. The exception names the file.
inline Golden golden_at(const std::filesystem::path& path) {
  try {
    return golden_of(bytes_of(path));
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(path.string() + ": " + e.what());
  }
}

// The texts in a golden file.
inline std::vector<std::string> parts_of(const Golden& golden) {
  std::vector<std::string> parts = {golden.document};
  if (golden.list) parts.push_back(*golden.list);
  if (golden.messages) parts.push_back(*golden.messages);
  return parts;
}

// Writes the documents and lists of a folder, and of its subfolders, to another folder as separate files, for programs
// that read a folder.
inline void unpack_goldens(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::filesystem::create_directories(to);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(from)) {
    std::filesystem::path target = to / entry.path().lexically_relative(from);
    if (entry.is_directory()) {
      std::filesystem::create_directories(target);
      continue;
    }
    const Golden golden = golden_at(entry.path());
    std::ofstream(target, std::ios::binary) << golden.document;
    if (golden.list) std::ofstream(target.replace_extension(".dtdsl"), std::ios::binary) << *golden.list;
  }
}

}  // namespace robcogen::test
