#include "support/files.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace robcogen {
namespace {

namespace fs = std::filesystem;

bool same_content(const fs::path& path, const std::string& text) {
  std::error_code fault;
  if (fs::file_size(path, fault) != text.size() || fault) return false;
  std::ifstream file(path, std::ios::binary);
  return file && std::string(std::istreambuf_iterator<char>(file), {}) == text;
}

bool write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();  // a full disk may show only here
  return static_cast<bool>(file);
}

std::string escaped(const fs::path& path) {
  std::string result;
  for (char c : path.string()) {
    if (c == ' ' || c == '#') result += '\\';
    if (c == '$') result += '$';
    result += c;
  }
  return result;
}

struct Change {
  fs::path temporary;
  fs::path final;
};

}  // namespace

std::optional<std::string> read_file(const fs::path& path, std::string& error) {
  if (path == "-") return std::string(std::istreambuf_iterator<char>(std::cin), {});
  std::error_code fault;
  if (fs::is_directory(path, fault)) {
    error = path.string() + ": error: this is a folder, not a file";
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file) text.assign(std::istreambuf_iterator<char>(file), {});
  if (!file || file.bad()) {
    error = path.string() + ": error: cannot read the file: " +
            (fs::exists(path, fault) ? "permission denied, or a fault of the disk" : "it does not exist");
    return std::nullopt;
  }
  return text;
}

bool write_files_if_changed(const fs::path& directory, const std::vector<OutputFile>& files, std::string& error) {
  std::vector<Change> changes;
  const auto give_up = [&](const std::string& what, const fs::path& path) {
    std::error_code ignored;
    for (const Change& change : changes) fs::remove(change.temporary, ignored);
    error = what + " '" + path.string() + "'";
    return false;
  };
  for (const OutputFile& file : files) {
    const fs::path final = directory / file.path;
    if (same_content(final, file.text)) continue;
    std::error_code fault;
    fs::create_directories(final.parent_path(), fault);
    if (fault) return give_up("cannot make the folder", final.parent_path());
    fs::path temporary = final;
    temporary += ".new";
    changes.push_back({temporary, final});
    if (!write(temporary, file.text)) return give_up("cannot write", temporary);
  }
  for (const Change& change : changes) {
    std::error_code fault;
    fs::rename(change.temporary, change.final, fault);
    if (fault) return give_up("cannot replace", change.final);
  }
  return true;
}

std::string dependency_file(const fs::path& target, const std::vector<fs::path>& inputs) {
  std::string text = escaped(target) + ":";
  for (const fs::path& input : inputs) text += " \\\n  " + escaped(input);
  return text + "\n";
}

std::string hash_text(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash >> shift & 15U];
  return digits;
}

}  // namespace robcogen
