// The files of a library before the library exists: builds need their paths, which depend on the options alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "backend/library.h"
#include "support/parallel.h"

namespace robcogen::backend {

// A file, and the function that prints it, given the names that the library has in the language.
template <class Names>
struct PlannedFile {
  std::string path;
  std::function<std::string(const Names&)> text;
};

template <class Names>
std::vector<std::string> paths(const std::vector<PlannedFile<Names>>& files) {
  std::vector<std::string> result;
  for (const PlannedFile<Names>& file : files) result.push_back(file.path);
  return result;
}

// Prints several files at a time, in parallel.
template <class Names>
std::vector<OutputFile> print(const std::vector<PlannedFile<Names>>& files, const Names& names) {
  std::vector<OutputFile> result(files.size());
  for_each_index(files.size(), [&](std::size_t i) { result[i] = {files[i].path, files[i].text(names)}; });
  return result;
}

}  // namespace robcogen::backend
