// The names of one kind of element, with what is wrong about them and the way from a name to its element.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::model {

class NameIndex {
 public:
  // `kind` is what messages call the elements: `link`, `joint`, `frame`.
  explicit NameIndex(std::string kind) : kind_(std::move(kind)) {}

  // Adds the next element. Reports a name that is taken (`duplicate-<kind>`), or that differs from another in case
  // only.
  void add(const std::string& name, const Place& place, Diagnostics& diagnostics);

  // The first element of this name, in the order of addition.
  std::optional<int> find(const std::string& name) const;
  const std::string& name_of(int index) const { return names_[static_cast<std::size_t>(index)]; }
  const Place& place_of(int index) const { return places_[static_cast<std::size_t>(index)]; }
  // Whether an earlier element has the same name.
  bool is_repetition(int index) const;
  // The element that a misspelt name was probably meant to be. Gives up after many questions: each costs a look at all
  // names, and a file with thousands of unknown names is not helped by guesses.
  std::optional<int> nearest_to(const std::string& name);

 private:
  std::string kind_;
  std::vector<std::string> names_;
  std::vector<Place> places_;
  std::map<std::string, int, std::less<>> first_;
  std::map<std::string, int, std::less<>> first_in_lower_case_;
  int questions_left_ = 50;
};

}  // namespace robcogen::model
