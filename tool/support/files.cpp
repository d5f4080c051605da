#include "support/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

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

constexpr const char* kTemporary = ".robcogen-new";

// A file, whatever its path; nullopt if there is no regular file.
#ifdef _WIN32
// `stat` does not number the files, and nothing tells which one a stream is: the path without links.
using Identity = fs::path;

std::optional<Identity> identity(const fs::path& path, int) {
  std::error_code fault;
  if (!fs::is_regular_file(path, fault)) return std::nullopt;
  const fs::path place = fs::canonical(path, fault);
  return fault ? path : place;
}
#else
// The device and the number on it.
using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> identity(const fs::path& path, int standard_stream) {
  struct stat status {};
  const int fault = path == "-" ? ::fstat(standard_stream, &status) : ::stat(path.c_str(), &status);
  if (fault != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Identity(status.st_dev, status.st_ino);
}
#endif

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

// The target of a symbolic link, and otherwise the path itself.
fs::path behind_links(const fs::path& path) {
  std::error_code fault;
  if (!fs::is_symlink(path, fault)) return path;
  fs::path target = fs::canonical(path, fault);
  return fault ? path : target;
}

// Whether the path leads to a device, to a pipe, or, like /dev/stdout, to a file that is open.
bool is_stream(fs::path path) {
  constexpr int kMaxLinks = 40;
  std::error_code fault;
  const fs::file_status status = fs::status(path, fault);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return true;
  for (int links = 0; links < kMaxLinks && fs::is_symlink(path, fault); ++links) {
    path = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", fault) / path.filename();
    if (path.string().starts_with("/proc/")) return true;
    path = path.parent_path() / fs::read_symlink(path, fault);
  }
  return false;
}

// Streams are not emptied first: `>>` appends.
bool append(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  return static_cast<bool>(file);
}

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
      is_input ? stdin : std::fopen(path.string().c_str(), "rb"), [](std::FILE* f) {
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
  std::vector<const OutputFile*> streams;
  for (const OutputFile& file : files) {
    if (is_stream(directory / file.path)) {
      streams.push_back(&file);
      continue;
    }
    const fs::path final = behind_links(directory / file.path);
    if (same_content(final, file.text)) continue;
    std::error_code fault;
    if (fs::is_directory(final, fault)) return give_up("cannot replace the folder", final, EISDIR);
    fault.clear();  // there may be no file yet
    if (final.has_parent_path()) fs::create_directories(final.parent_path(), fault);
    if (fault) return give_up("cannot create the folder", final.parent_path(), fault.value());
    fs::path temporary = final;
    temporary += kTemporary;
    changes.push_back({temporary, final});
    errno = 0;
    if (!write(temporary, file.text)) return give_up("cannot write", final, errno);
  }
  for (const Change& change : changes) {
    std::error_code fault;
    fs::rename(change.temporary, change.final, fault);
    if (fault) return give_up("cannot replace", change.final, fault.value());
  }
  for (const OutputFile* file : streams) {
    errno = 0;
    if (!append(directory / file->path, file->text)) return give_up("cannot write", directory / file->path, errno);
  }
  return true;
}

std::optional<Overlap> overlap(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::map<Identity, const fs::path*> read;
  for (const fs::path& input : inputs)
    if (const auto file = identity(input, STDIN_FILENO)) read.emplace(*file, &input);
  for (const fs::path& output : outputs) {
    // A folder of the path may not exist yet; then `..` behind it leads nowhere until the folder is made.
    std::error_code fault;
    fs::path place = output == "-" ? output : fs::weakly_canonical(fs::absolute(output, fault), fault);
    if (fault) place = output;
    fs::path temporary = place;
    temporary += kTemporary;
    for (const fs::path& written : {output, place, temporary}) {
      const auto file = identity(written, STDOUT_FILENO);
      if (!file) continue;
      if (const auto found = read.find(*file); found != read.end())
        return Overlap{written == place ? output : written, *found->second};
    }
  }
  return std::nullopt;
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
