// A map from names to elements of one kind.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace robcogen::model {

class NameIndex {
 public:
  // Adds the next element. A repeated name refers to the first element that has it.
  void add(const std::string& name);

  int size() const { return static_cast<int>(names_.size()); }
  const std::string& name_of(int index) const { return names_[static_cast<std::size_t>(index)]; }
  std::optional<int> find(const std::string& name) const;
  // The first element whose name differs from this one only in the case of its letters.
  std::optional<int> find_in_other_case(const std::string& name) const;
  // The element that a misspelt name probably refers to. Gives up after many calls: each call compares all names, and
  // guesses do not help in a file with thousands of unknown names.
  std::optional<int> nearest_to(const std::string& name);
  // Whether an earlier element has the same name.
  bool is_repetition(int index) const { return find(name_of(index)) != index; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, int> first_;
  std::map<std::string, int> first_in_lower_case_;
  int questions_left_ = 50;
};

}  // namespace robcogen::model
