// The C++ interface of a library: all identifiers, and the overloads of its functions.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/lower.h"
#include "backend/library.h"
#include "symbolic/cost.h"

namespace robcogen::backend::cpp {

// The first argument of functions of robots with parameters, in namespace hyl and in hyl::f32.
inline constexpr const char* kParametersType = "Parameters<Scalar>";

// The type that replaces joint positions, in either precision, and the name of the argument.
inline constexpr const char* kTrigonometryType = "JointTrigonometry";
inline constexpr const char* kTrigonometryName = "at";

// A function of the library with its C++ names.
struct Callable {
  const Function* function = nullptr;
  std::string kernel;                             // in namespace `kernel`
  std::string name;                               // in the function's scope
  std::string columns;                            // the constant that lists the joints, or the labels, of its columns
  std::string owner;                              // the type that it is a member of; empty: a free function
  std::string result = {};                        // the type that it returns
  std::vector<KernelArray> parameters = {};       // of the kernel: inputs, then outputs
  std::vector<KernelArray> core_parameters = {};  // of its core, if it has one
  symbolic::Cost count = {};                      // of the function's program
};

struct Api {
  const Library* library = nullptr;
  std::string space;                                                          // the whole namespace: `a::hyl`
  std::vector<std::string> joints, positions, coupled, links, frames, limbs;  // enumerators
  std::vector<std::string> variables;                                         // names of arguments
  std::vector<std::string> parameters;                                        // members of Parameters
  std::vector<Callable> callables;                                            // in the order of Library::functions
  std::vector<Callable> right_sides;                                          // called by callables, in no interface
  // For robots with parameters, whose functions take these first.
  std::vector<std::string> fields, getters;  // by parameter
  std::vector<Callable> updates, numbers;
  // For robots whose functions take precomputed sines and cosines: computes those of all angles from those of the
  // joints.
  std::vector<Callable> trigonometry;

  bool is_parametric() const { return !updates.empty(); }
  bool takes_sines() const { return !trigonometry.empty(); }
  // The scalar types that kernels are compiled for.
  std::vector<std::string> scalars() const;
  // `double and float`.
  std::string scalars_in_words() const;
};

// The result refers to the library, which must outlive it.
Api api(const Library& library);

struct Argument {
  std::string type;
  std::string name;
};

// A kernel's array whose elements a function takes one by one.
struct Packed {
  std::string name;
  std::vector<std::string> elements;
};

struct Overload {
  const Callable* callable = nullptr;
  std::string result;
  std::vector<Argument> arguments;
  bool adds_standard_gravity = false;    // has no gravity argument, and calls the overload that has one
  bool takes_sines = false;              // takes JointTrigonometry instead of joint positions
  std::vector<Packed> packed = {};       // parameters and variables of libraries without a robot
  std::vector<std::string> inputs = {};  // arguments of the kernel, unless adds_standard_gravity
};

// The overloads of these functions, which have one scope and name. With a fixed base, gravity may be left out: unless
// one of the functions has standard gravity folded in, an additional overload passes it. With a floating base, gravity
// is required, because it says how the base is oriented. The overloads for joint positions come first, then those for
// JointTrigonometry.
std::vector<Overload> overloads(const Api& api, const std::vector<const Callable*>& callables);

// The overloads of a group's free functions in this scope, in order.
std::vector<Overload> overloads(const Api& api, const std::string& group, const std::string& scope);

// The members of a type in order, without its constructors.
std::vector<Overload> members(const Api& api, const std::string& type);

// The same overload with JointTrigonometry instead of joint positions; unchanged if it takes none.
Overload with_sines(const Api& api, const Overload& overload);

// The scopes of a group's free functions in the order of their first function.
std::vector<std::string> scopes(const Api& api, const std::string& group);

// The first function of each name that returns a structure of the library's own.
std::vector<const Callable*> callables_with_structures(const Api& api);

std::string matrix_type(int rows, int columns);
// The C++ type of an input, of an output, and of what a function returns. The names are aliases in types.h.
std::string type_of(const symbolic::InputArray& input);
std::string type_of(const symbolic::OutputArray& output);
std::string result_type(const Function& function);
// Whether the result type is a structure of the library's own, named after the function: it has several arrays, and the
// runtime has no type for them.
bool returns_own_structure(const symbolic::Program& program);
// Whether outputs of this role are members of a result type of the library. The functions that read them are members of
// that type as well.
bool is_kept(symbolic::Role role);
std::string kept_name(const std::string& array);  // the data member that holds the array
bool returns_object(const symbolic::Program& program);
// The member of the result type that holds this output; empty when the function returns the output itself.
std::string result_member(const symbolic::Program& program, const symbolic::OutputArray& output);

}  // namespace robcogen::backend::cpp
