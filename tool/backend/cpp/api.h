// The C++ interface of a library: every identifier settled, and the overloads that its functions make.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/lower.h"
#include "backend/library.h"
#include "symbolic/count.h"

namespace robcogen::backend::cpp {

// What functions of robots with parameters take first: of namespace hyl and of hyl::f32 alike.
inline constexpr const char* kParametersType = "Parameters<Scalar>";

// What takes the place of joint positions, in either precision, and the argument's name.
inline constexpr const char* kTrigonometryType = "JointTrigonometry";
inline constexpr const char* kTrigonometryName = "at";

// A function of the library under its C++ names.
struct Callable {
  const Function* function = nullptr;
  std::string kernel;                      // in namespace `kernel`
  std::string name;                        // in the function's scope
  std::string columns;                     // Jacobians: the constant beside it that lists the joints of its columns
  std::string owner;                       // the type whose member it is; empty: a free function
  std::vector<Parameter> parameters = {};  // of the kernel: inputs, then outputs
  std::vector<Parameter> core_parameters = {};  // of its core, where it has one
  symbolic::OperationCount count = {};          // of the function's program
};

struct Api {
  const Library* library = nullptr;
  std::string space;                               // the whole namespace: `a::hyl`
  std::vector<std::string> joints, links, frames;  // enumerators
  std::vector<std::string> variables;              // arguments
  std::vector<std::string> parameters;             // members of Parameters
  std::vector<Callable> callables;                 // in the order of Library::functions
  // Of robots with parameters, whose functions take these first:
  std::vector<std::string> fields, getters;  // by parameter
  std::vector<Callable> updates, numbers;
  // Of robots whose functions take given sines and cosines: how those of all angles follow from those of the joints.
  std::vector<Callable> trigonometry;

  bool is_parametric() const { return !updates.empty(); }
  bool takes_sines() const { return !trigonometry.empty(); }
};

// Refers to the library, which must live as long.
Api api(const Library& library);

struct Argument {
  std::string type;
  std::string name;
};

// An array of a kernel whose elements a function takes one by one.
struct Packed {
  std::string name;
  std::vector<std::string> elements;
};

struct Overload {
  const Callable* callable = nullptr;
  std::string result;
  std::vector<Argument> arguments;
  bool adds_standard_gravity = false;    // has no argument for it, and calls the overload that has one
  bool takes_sines = false;              // JointTrigonometry in the place of joint positions
  std::vector<Packed> packed = {};       // parameters and variables, where there is no robot
  std::vector<std::string> inputs = {};  // what the kernel gets, unless adds_standard_gravity
};

// The overloads that these functions make, all of one scope and name. With a fixed base gravity may be left out
// wherever no function of its own does without it: an overload of its own then adds standard gravity. With a floating
// base it says how the base is oriented, and no overload does without it. Behind those that take joint positions come
// those that take JointTrigonometry, where there is one.
std::vector<Overload> overloads(const Api& api, const std::vector<const Callable*>& callables);

// The overloads of a group's free functions in this scope, in order.
std::vector<Overload> overloads(const Api& api, const std::string& group, const std::string& scope);

// The members of a type, but those that it is made by, in order.
std::vector<Overload> members(const Api& api, const std::string& type);

// The overload that takes JointTrigonometry in the place of joint positions; the same, where there are none.
Overload with_sines(const Api& api, const Overload& overload);

// The scopes of a group's free functions in the order of their first function.
std::vector<std::string> scopes(const Api& api, const std::string& group);

std::string matrix_type(int rows, int columns);
// C++ type of an input, and of what a function returns. The names are aliases of types.h.
std::string type_of(const symbolic::InputArray& input);
std::string type_of(const symbolic::OutputArray& output);
std::string result_type(const symbolic::Program& program);
// What such outputs make together is a type of the library's own, printed where its functions are: they are kept, and
// functions that read them are its members.
bool is_kept(symbolic::Role role);
std::string kept_name(const std::string& array);  // the data member that holds the array
bool returns_object(const symbolic::Program& program);
// The member of the result type that holds this output; empty when the function returns the output itself.
std::string result_member(const symbolic::Program& program, const symbolic::OutputArray& output);

}  // namespace robcogen::backend::cpp
