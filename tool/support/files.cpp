#include "support/files.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <system_error>

namespace robcogen {
namespace {

namespace fs = std::filesystem;

// Reads at most `limit` + 1 bytes; the last one shows that the file is larger.
std::string read_up_to(std::FILE* file, std::size_t limit) {
  std::string text;
  std::array<char, 1 << 16> block;
  std::size_t count = 0;
  while (text.size() <= limit && (count = std::fread(block.data(), 1, block.size(), file)) > 0)
    text.append(block.data(), count);
  return text;
}

bool same_content(const fs::path& path, const std::string& text) {
  std::error_code fault;
  if (fs::file_size(path, fault) != text.size() || fault) return false;
  std::ifstream file(path, std::ios::binary);
  std::string found(text.size(), '\0');
  return file.read(found.data(), static_cast<std::streamsize>(found.size())) && found == text;
}

bool write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();  // a full disk may be reported only here
  return static_cast<bool>(file);
}

std::string reason(int number) {
  return number == 0 ? "" : ": " + std::generic_category().message(number);
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
  const bool is_input = path == "-";
  const std::string name = is_input ? "<standard input>" : path.string();
  std::error_code fault;
  if (!is_input && fs::is_directory(path, fault)) {
    error = name + ": error: a folder, not a file";
    return std::nullopt;
  }
  errno = 0;
  const std::unique_ptr<std::FILE, void (*)(std::FILE*)> file(
      is_input ? stdin : std::fopen(path.c_str(), "rb"), [](std::FILE* f) {
        if (f && f != stdin) static_cast<void>(std::fclose(f));
      });
  std::optional<std::string> text;
  if (file) text = read_up_to(file.get(), kMaxInputSize);
  if (!text || std::ferror(file.get())) {
    error = name + ": error: cannot read the file" + reason(errno);
    return std::nullopt;
  }
  if (text->size() > kMaxInputSize) {
    error = name + ": error: the file has more than " + std::to_string(kMaxInputSize >> 20) +
            " MiB, the limit for documents";
    return std::nullopt;
  }
  return text;
}

bool write_files_if_changed(const fs::path& directory, const std::vector<OutputFile>& files, std::string& error) {
  std::vector<Change> changes;
  const auto give_up = [&](const std::string& what, const fs::path& path, int number) {
    error = what + " '" + path.string() + "'" + reason(number);
    std::error_code ignored;
    for (const Change& change : changes) fs::remove(change.temporary, ignored);
    return false;
  };
  for (const OutputFile& file : files) {
    const fs::path final = directory / file.path;
    if (same_content(final, file.text)) continue;
    std::error_code fault;
    if (fs::is_directory(final, fault)) return give_up("cannot replace the folder", final, EISDIR);
    fs::create_directories(final.parent_path(), fault);
    if (fault) return give_up("cannot create the folder", final.parent_path(), fault.value());
    fs::path temporary = final;
    temporary += ".robcogen-new";
    changes.push_back({temporary, final});
    errno = 0;
    if (!write(temporary, file.text)) return give_up("cannot write", final, errno);
  }
  for (const Change& change : changes) {
    std::error_code fault;
    fs::rename(change.temporary, change.final, fault);
    if (fault) return give_up("cannot replace", change.final, fault.value());
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
