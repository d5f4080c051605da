// Reads the elements of a file into the document.
#pragma once

#include "import/sdf/element_reader.h"

namespace robcogen::import::from_sdf {

// What elements of one file have in common.
struct FileContext {
  int version = 0;  // the minor number: 6 for SDF 1.6
  std::filesystem::path folder;
};

// Reads the only model of the file, or the one that the options choose, with the models in it and those that it
// includes. Appends files that were read to `included`.
Document read_document(
    const Element& root,
    const std::filesystem::path& file,
    const SdfOptions& options,
    std::vector<std::filesystem::path>& included,
    Diagnostics& diagnostics);

// The version of a file by its root element; nullopt for one that is reported.
std::optional<int> read_version(const Element& root, Diagnostics& diagnostics);

// Reads the mass properties of a link.
Inertial read_inertial(const Element& link, const std::string& name, ElementReader& reader);

// Reads a joint except for its frame. nullopt for a type that is reported.
std::optional<Joint> read_joint(const Element& element, const Name& name, int version, ElementReader& reader);

}  // namespace robcogen::import::from_sdf
