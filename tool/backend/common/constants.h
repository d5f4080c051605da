// What a library tells about its robot, for languages that have it as data: which lists, of which items, with which
// members. A back end spells them.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

struct Constant;
// Members of an item, in rows of those that stand together.
using Record = std::vector<std::vector<Constant>>;

struct Constant {
  std::string name;
  std::variant<std::string, double, int, std::vector<double>, Record> value;  // int: an index, from 0
};

struct ConstantList {
  std::string name;
  std::vector<std::vector<Constant>> items;
};

// Joints, coupled joints, links, frames and limbs, in SI units; link 0 is the base, whose parent_joint is -1.
std::vector<ConstantList> constants(const Library& library);

// Whether joints follow through loops: by no factors, but by joint_positions.
bool has_closures(const Library& library);

// What the lists and their members are, one text each.
std::vector<std::string> describe_constants(const Library& library);

// How many a robot has, by the names that the counts have where they are constants: dof, link_count, ….
std::vector<std::pair<std::string, std::size_t>> sizes(const Library& library);

// A table of texts or numbers by which languages of plain arrays know the robot.
struct Table {
  std::string name, what;
  std::vector<std::string> texts = {};
  std::vector<double> numbers = {};  // of a numeric table
  bool is_numeric = false;
};

// Names of joints, positions, links, frames and parameters, and limits of joints.
std::vector<Table> tables(const Library& library);

}  // namespace robcogen::backend
