// The files that a subcommand writes. Every subcommand writes through these functions, which refuse to write over what
// it has read: a mistyped command must not destroy a model.
#pragma once

#include <filesystem>
#include <vector>

#include "support/files.h"

namespace robcogen::command {

// Throws a Failure if one of the outputs is one of the inputs, or if two outputs are the same file. "-" is standard
// input among the inputs, and standard output among the outputs.
void require_apart(const std::vector<std::filesystem::path>& outputs, const std::vector<std::filesystem::path>& inputs);

// Throws a Failure if standard output is one of these files.
void require_apart_from_output(const std::vector<std::filesystem::path>& inputs);

// Writes a single file, if its text changes. `inputs` are the files that were read. Throws a Failure if the file is one
// of them or cannot be written.
void write_file(
    const std::filesystem::path& file,
    const std::string& text,
    const std::vector<std::filesystem::path>& inputs);

// Writes files with paths relative to the folder (empty: the current one) in the same way. `others` are files that the
// subcommand writes afterwards: they must be neither inputs nor any of these files.
void write_files(
    const std::filesystem::path& folder,
    const std::vector<OutputFile>& files,
    const std::vector<std::filesystem::path>& inputs,
    const std::vector<std::filesystem::path>& others = {});

// The same for the files of a library. Throws a Failure if one of them would replace a file that was not generated.
void write_generated_files(
    const std::filesystem::path& folder,
    const std::vector<OutputFile>& files,
    const std::vector<std::filesystem::path>& inputs,
    const std::vector<std::filesystem::path>& others);

}  // namespace robcogen::command
