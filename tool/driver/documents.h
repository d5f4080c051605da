// The user's documents, and the languages in which they are written.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "support/source.h"

namespace robcogen::driver {

enum class Language { robot, urdf, mjcf, sdf, motions, transforms, desired };

// The language by the suffix of the file's name; nullopt if the suffix is not known.
std::optional<Language> language_of_suffix(const std::filesystem::path& file);
// The language of the file. The content decides which language a robot is in, whatever the suffix: the root element
// shows URDF, MJCF and SDF, and anything else is a robot document.
Language language_of(const std::filesystem::path& file);
// The same for a file of this text.
Language language_of(const std::filesystem::path& file, const Source& source);

constexpr bool is_robot(Language language) {
  return language == Language::robot || language == Language::urdf || language == Language::mjcf ||
         language == Language::sdf;
}

// The text of the file; `-` is standard input. Throws a Failure if the file cannot be read or is not text.
std::shared_ptr<const Source> read_source(const std::filesystem::path& path);

}  // namespace robcogen::driver
