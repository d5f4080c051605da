// Handmade robots for the tests of generated code: no algorithm of the generator makes their programs.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::test {

// A pole that hangs on a cart (closed-form Lagrangian), fixed base, all groups: joints CART (m) and POLE (rad).
backend::Library cart_pole();

// A floating trunk with one sliding leg: every signature of floating bases, with formulas without physics.
backend::Library hopper();

// A robot without joints.
backend::Library plinth();

// Constants that are hard to print: each one is an element of the output of `literals::literals`.
backend::Library literals();
const std::vector<double>& literal_values();

// A robot called `robot` whose joints, links, frames and values have names that C++, its headers or the generated code
// use for something else.
backend::Library nasty();

std::vector<backend::Library> samples();

}  // namespace robcogen::test
