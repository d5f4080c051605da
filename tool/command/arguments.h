// The arguments of a function as JSON: what it takes, and what a state gives it.
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
    numbers_by_name,  // an object of names, a number each
    vectors_by_name,  // an object of names, an array of numbers each
  };
  std::string name;
  Shape shape = Shape::vector;
  std::string meaning;                // with units and coordinates
  std::vector<std::string> elements;  // vectors: what each number is about, such as joints; by name: the names
  std::size_t length = 0;             // of a vector, of a row, of the vector of a name
  // Of each number: what it is where the state does not give it; nullopt where it must. Vectors and squares are given
  // whole or not at all.
  std::vector<std::optional<double>> defaults;

  bool is_required() const;
};

// What a function is evaluated with.
struct Signature {
  std::string function;
  std::vector<Argument> arguments;
};

// Of a robot's function, given all its overloads: what only some of them take has a default.
Signature signature_of(
    const std::string& function,
    const std::vector<const symbolic::Program*>& overloads,
    const model::KinematicTree& tree);
Signature signature_of(
    const std::string& function,
    const symbolic::Program& program,
    const model::CoordinateTransforms& document);

// The inputs of the function from an object of arguments. Throws the Failure of refuse_input for a name that is no
// argument, for a missing argument and for a wrong shape.
symbolic::Arrays<double> arguments_from(const JsonValue& object, const Signature& signature);

}  // namespace robcogen::command
