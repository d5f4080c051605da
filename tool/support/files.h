// Reading and writing files: generated output is complete or absent, and untouched when it would not change.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace robcogen {

// The size limit for documents, which also applies to input without an end (a device, a pipe).
inline constexpr std::size_t kMaxInputSize = std::size_t{64} << 20;  // bytes

// The bytes of the file, or nullopt with a message in `error`. Refuses folders and files larger than kMaxInputSize. "-"
// is standard input.
std::optional<std::string> read_file(const std::filesystem::path& path, std::string& error);

struct OutputFile {
  std::filesystem::path path;  // relative to the output directory
  std::string text;
};

// Writes every file whose content differs. All of them are first written to temporary files, which are then renamed. If
// a folder cannot be made or a file cannot be written, the temporary files are removed, nothing is renamed, `error`
// says what failed, and the function returns false. A symbolic link remains, and its target is replaced. Devices and
// pipes are written directly, after the files.
bool write_files_if_changed(
    const std::filesystem::path& directory,
    const std::vector<OutputFile>& files,
    std::string& error);

// Two paths of one file.
struct Overlap {
  std::filesystem::path output;
  std::filesystem::path input;
};

// The first output that is one of the inputs, whatever paths, symbolic links or hard links lead to it; nullopt if there
// is none. Only regular files count. "-" is standard input among the inputs, and standard output among the outputs. An
// output counts together with the temporary file beside it.
std::optional<Overlap> overlap(
    const std::vector<std::filesystem::path>& outputs,
    const std::vector<std::filesystem::path>& inputs);

// One rule `target: inputs…` in the form of a compiler's dependency file; blanks, '#' and '$' are escaped.
std::string dependency_file(const std::filesystem::path& target, const std::vector<std::filesystem::path>& inputs);

// 64-bit FNV-1a of the text, as 16 hexadecimal digits: the model's hash in banners. Not for security.
std::string hash_text(const std::string& text);

}  // namespace robcogen
