#include "command/output_files.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <system_error>

#include "command/status.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

const char* const kGenerated = "enerated by robcogen";  // in every file of a library, with a small or a large letter

std::string name_of(const fs::path& path, const char* of_stream) {
  return path == "-" ? of_stream : fmt::format("'{}'", path.string());
}

// Throws a Failure if two of the paths lead to one file. Hard links of one file may differ: each is replaced on its
// own.
void require_different(const std::vector<fs::path>& outputs) {
  std::map<fs::path, const fs::path*> known;
  for (const fs::path& output : outputs) {
    std::error_code fault;
    const fs::path place = fs::weakly_canonical(fs::absolute(output, fault), fault);
    const auto [earlier, is_new] = known.emplace(fault ? output : place, &output);
    if (is_new || !(fs::is_regular_file(output, fault) || !fs::exists(output, fault))) continue;
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: the outputs '{}' and '{}' are the same file [outputs-coincide]",
                         earlier->second->string(), output.string())};
  }
}

void require_generated(const fs::path& folder, const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files) {
    const fs::path path = folder / file.path;
    std::error_code fault;
    if (file.text.find(kGenerated) == std::string::npos || !fs::is_regular_file(path, fault)) continue;
    std::string reason;
    const std::optional<std::string> there = read_file(path, reason);
    if (!there || there->empty() || there->find(kGenerated) != std::string::npos) continue;
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: a generated file would replace '{}', which was not generated "
                         "[output-is-not-generated]\nhint: name another folder or library, or remove the file",
                         path.string())};
  }
}

void require_distinct(
    const fs::path& folder,
    const std::vector<OutputFile>& files,
    const std::vector<fs::path>& inputs,
    const std::vector<fs::path>& others) {
  std::vector<fs::path> outputs;
  for (const OutputFile& file : files) outputs.push_back(folder / file.path);
  outputs.insert(outputs.end(), others.begin(), others.end());
  require_apart(outputs, inputs);
  require_different(outputs);
}

void write_all(const fs::path& folder, const std::vector<OutputFile>& files) {
  std::string error;
  if (!write_files_if_changed(folder, files, error))
    throw Failure{wrong_usage, fmt::format("robcogen: error: {}", error)};
}

}  // namespace

void require_apart(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  const std::optional<Overlap> found = overlap(outputs, inputs);
  if (!found) return;
  throw Failure{
      wrong_usage, fmt::format(
                       "robcogen: error: the output would replace the input: {} is the file that was read as {} "
                       "[output-is-input]\nhint: name another output",
                       name_of(found->output, "standard output"), name_of(found->input, "standard input"))};
}

void require_apart_from_output(const std::vector<fs::path>& inputs) {
  require_apart({"-"}, inputs);
}

void write_file(const fs::path& file, const std::string& text, const std::vector<fs::path>& inputs) {
  write_files("", {{file, text}}, inputs);
}

void write_files(
    const fs::path& folder,
    const std::vector<OutputFile>& files,
    const std::vector<fs::path>& inputs,
    const std::vector<fs::path>& others) {
  require_distinct(folder, files, inputs, others);
  write_all(folder, files);
}

void write_generated_files(
    const fs::path& folder,
    const std::vector<OutputFile>& files,
    const std::vector<fs::path>& inputs,
    const std::vector<fs::path>& others) {
  require_distinct(folder, files, inputs, others);
  require_generated(folder, files);
  write_all(folder, files);
}

}  // namespace robcogen::command
