// The data of a robot, for languages that represent it as lists of items with members. A back end spells them.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

struct Constant;
// The members of an item, in rows of members that belong together.
using Record = std::vector<std::vector<Constant>>;

struct Constant {
  std::string name;
  std::variant<std::string, double, int, std::vector<double>, Record> value;  // int: a zero-based index
};

struct ConstantList {
  std::string name;
  std::vector<std::vector<Constant>> items;
};

// Joints, coupled joints, links, frames and limbs, and tendons if there are any, in SI units. Link 0 is the base; its
// parent_joint is -1.
std::vector<ConstantList> constants(const Library& library);

// Describes the lists and their members, one text each.
std::vector<std::string> describe_constants(const Library& library);

// The sizes of a robot under the names that they have as constants: dof, link_count, ….
std::vector<std::pair<std::string, std::size_t>> sizes(const Library& library);

// A table of texts or numbers that describes the robot, for languages that have only plain arrays.
struct Table {
  std::string name, what;
  std::vector<std::string> texts = {};
  std::vector<double> numbers = {};  // of a numeric table
  bool is_numeric = false;
};

// Names of joints, positions, links, frames and parameters, and limits of joints.
std::vector<Table> tables(const Library& library);

}  // namespace robcogen::backend
