// The documents that a user has, and the languages that they are in.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "support/source.h"

namespace robcogen::driver {

enum class Language { robot, urdf, mjcf, motions, transforms, desired };

// By the suffix of the file's name; nullopt where that says nothing.
std::optional<Language> language_of_suffix(const std::filesystem::path& file);
// A robot is in the language that its content shows, whatever its suffix: URDF and MJCF by their root elements, and a
// robot document otherwise.
Language language_of(const std::filesystem::path& file);
// The same for a file of this text.
Language language_of(const std::filesystem::path& file, const Source& source);

constexpr bool is_robot(Language language) {
  return language == Language::robot || language == Language::urdf || language == Language::mjcf;
}

// The file's text; `-` is standard input. A Failure when it cannot be read or is not text.
std::shared_ptr<const Source> read_source(const std::filesystem::path& path);

}  // namespace robcogen::driver
