// The files of a library before it is known: their paths follow from the options alone, as builds need them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "backend/library.h"
#include "support/parallel.h"

namespace robcogen::backend {

// What prints it takes the names that the library has in the language.
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

// Several at a time.
template <class Names>
std::vector<OutputFile> print(const std::vector<PlannedFile<Names>>& files, const Names& names) {
  std::vector<OutputFile> result(files.size());
  for_each_index(files.size(), [&](std::size_t i) { result[i] = {files[i].path, files[i].text(names)}; });
  return result;
}

}  // namespace robcogen::backend
