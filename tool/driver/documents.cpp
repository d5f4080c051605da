#include "driver/documents.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include "driver/failure.h"
#include "language/common/content.h"
#include "support/files.h"

namespace robcogen::driver {
namespace {

constexpr std::array kSuffixes = {
    std::pair(".kindsl", Language::robot),  std::pair(".urdf", Language::urdf),        std::pair(".sdf", Language::sdf),
    std::pair(".motdsl", Language::motions), std::pair(".ctdsl", Language::transforms), std::pair(".dtdsl", Language::desired)};

// Throws a Failure for binary files and for UTF-16, in which every second byte would be an error of its own.
void require_text(const Source& source) {
  const std::size_t at = source.text().find('\0');
  if (at == std::string_view::npos) return;
  const LineColumn place = source.locate(at);
  throw Failure{
      wrong_input, fmt::format(
                       "{}:{}:{}: error: not a text file: byte {} is zero [not-text]\nhint: documents are UTF-8",
                       source.name(), place.line, place.column, at + 1)};
}

}  // namespace

std::optional<Language> language_of_suffix(const std::filesystem::path& file) {
  for (const auto& [suffix, language] : kSuffixes)
    if (file.extension() == suffix) return language;
  return std::nullopt;
}

Language language_of(const std::filesystem::path& file) {
  const std::optional<Language> language = language_of_suffix(file);
  if (language && !is_robot(*language)) return *language;
  std::error_code no_such_file;
  if (file != "-" && !std::filesystem::exists(file, no_such_file)) return language.value_or(Language::robot);
  return language_of(file, *read_source(file));
}

Language language_of(const std::filesystem::path& file, const Source& source) {
  const std::optional<Language> language = language_of_suffix(file);
  if (language && !is_robot(*language)) return *language;
  const language::Content content = language::content_of(source.text());
  if (content == language::Content::mjcf) return Language::mjcf;
  if (content == language::Content::sdf) return Language::sdf;
  return content == language::Content::urdf ? Language::urdf : language.value_or(Language::robot);
}

std::shared_ptr<const Source> read_source(const std::filesystem::path& path) {
  // A stream, such as a pipe, can be read only once.
  static std::map<std::filesystem::path, std::shared_ptr<const Source>> streams;
  std::error_code fault;
  const bool is_stream = path == "-" || !std::filesystem::is_regular_file(path, fault);
  if (const auto known = streams.find(path); is_stream && known != streams.end()) return known->second;
  std::string error;
  std::optional<std::string> text = read_file(path, error);
  if (!text) throw Failure{wrong_usage, error};
  auto source = std::make_shared<const Source>(path == "-" ? "<standard input>" : path.string(), std::move(*text));
  require_text(*source);
  if (is_stream) streams.insert({path, source});
  return source;
}

}  // namespace robcogen::driver
