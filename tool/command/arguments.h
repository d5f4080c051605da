// The arguments of a function as JSON: its signature, and the values of a state.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/json_reader.h"
#include "model/coordinate_transforms.h"
#include "model/kinematic_tree.h"
#include "symbolic/interpret.h"

namespace robcogen::command {

struct Argument {
  enum class Shape {
    vector,           // an array of numbers
    square,           // rows of numbers
    numbers_by_name,  // an object with one number per name
    vectors_by_name,  // an object with an array of numbers per name
  };
  std::string name;
  Shape shape = Shape::vector;
  std::string meaning;                // with units and coordinates
  std::vector<std::string> elements;  // vectors: the names of the numbers, such as joints; by name: the names
  std::size_t length = 0;             // of a vector, of a row, or of the vector of each name
  // The default of each number; nullopt if the state must give it. A state gives vectors and squares as a whole or not
  // at all.
  std::vector<std::optional<double>> defaults;
  std::vector<int> quaternions = {};  // of a vector: where the four numbers of each unit quaternion begin
  int followers = 0;                  // of a vector: how many of its last numbers follow the others and may be left out

  bool is_required() const;
};

// The signature of a function for evaluation.
struct Signature {
  std::string function;
  std::vector<Argument> arguments;
  const model::KinematicTree* tree = nullptr;  // of a robot; must outlive this
};

// The signature of a robot's function, from all its overloads. Arguments that only some of them take have a default.
Signature signature_of(
    const std::string& function,
    const std::vector<symbolic::Program>& overloads,
    const model::KinematicTree& tree);
Signature signature_of(
    const std::string& function,
    const symbolic::Program& program,
    const model::CoordinateTransforms& document);

// The inputs of the function, from an object of arguments. Quaternions whose norm is within 1e-6 of one are normalised.
// Followers that are left out get the positions at which their loops close. Throws the Failure of refuse_input for an
// unknown or missing argument, for a wrong shape, and for a quaternion of another norm.
symbolic::Arrays<double> arguments_from(const JsonValue& object, const Signature& signature);

}  // namespace robcogen::command
