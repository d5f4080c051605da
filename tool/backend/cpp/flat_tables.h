// Tables of <name>/reflection.h. Their functions read and write all arrays one after another, as one flat array each.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/api.h"
#include "backend/cpp/layout.h"

namespace robcogen::backend::cpp {

// The definition of a table, and how the table of the whole model refers to it.
struct Table {
  std::string definition;
  std::string reference;
};

inline constexpr const char* kNoTable = "{nullptr, 0}";

// A table of robcogen::reflection::<type>.
Table table(const std::string& type, const std::string& name, const std::vector<std::vector<Field>>& rows);

std::string address(const Callable& c);

// Where an input and the outputs begin when all arrays follow one another.
std::size_t offset_of(const symbolic::Program& program, std::size_t input);
std::vector<std::size_t> offsets_of_outputs(const symbolic::Program& program);
// `At<0, 3>`: the offsets at which the arrays begin.
std::string offset_list(const std::vector<std::size_t>& offsets);
int output_count(const symbolic::Program& program);

// The kernel under the signature that all functions of the tables have.
Field flat(const Callable& c);
// The first fields of a robcogen::reflection::Function.
std::vector<Field> function_row(const Callable& c);

// The table that says where the derivatives of these functions stand (robcogen::reflection::Derivative), in their
// order. `has_cache`: the functions read the cache instead of the parameters.
Table derivatives(const std::vector<const Callable*>& functions, bool has_cache);

// The tables of the parts of fused functions among these (robcogen::reflection::Part).
Table parts(const std::vector<const Callable*>& functions);

}  // namespace robcogen::backend::cpp
