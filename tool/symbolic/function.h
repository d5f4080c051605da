// One function of a generated library, from its declaration to its printed text: what it is, its program, and the forms
// of the program that a language asks for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symbolic/accuracy.h"
#include "symbolic/core.h"
#include "symbolic/derivative.h"
#include "symbolic/kernel_form.h"
#include "symbolic/program.h"
#include "symbolic/solved_columns.h"

namespace robcogen::symbolic {

// A coordinate transform as a product: its factors from left to right, and the program that computes their amounts (m,
// rad), one row per factor.
struct Product {
  struct Primitive {
    bool rotation = false;
    int axis = 0;  // 0 x, 1 y, 2 z
  };
  std::vector<Primitive> primitives;
  Program amounts;
};

// A function whose outputs are among those of a fused function, from one output on.
struct Part {
  std::string kernel;
  int first_output = 0;
};

// Overloads share `scope` and `name` and differ in inputs (gravity, external wrenches); `kernel` is unique.
struct Function {
  std::string group;                        // file stem: inverse_dynamics, joint_space_inertia, transforms, …
  std::string scope;                        // nested namespace: "", inertia_factor, transforms::motion, jacobians, …
  std::string name;                         // `inverse_dynamics`, `fr_base_X_fr_foot`
  std::string kernel = {};                  // `inverse_dynamics_external`; identifier, unique in the library
  std::vector<std::string> summary;         // documentation lines: what, frames, units, source
  std::vector<int> columns = {};            // jacobians: the coordinate of each column
  std::vector<int> row_joints = {};         // inverse kinematics: the coordinate of each row
  std::vector<std::string> labels = {};     // regressors: what each column multiplies
  std::string left = {}, right = {};        // functions between two frames: their names
  int left_frame = -1, right_frame = -1;    // the same frames in the library
  Program program = {};                     // its name is `kernel`
  std::string method = {};                  // how it is computed, where there was a choice
  std::optional<RoundingError> error = {};  // where it was measured
  std::vector<DerivativeBlock> derivatives = {};  // blocks of its outputs, to be checked by differences
  std::vector<Part> parts = {};                   // of a fused function

  // Set for languages whose functions take precomputed sines and cosines, if the program reads any.
  std::optional<Core> core = {};
  // Set for languages with vectors: the same program with congruent limbs in lanes, if there is one, and a text for
  // each class of congruent limbs.
  std::optional<Program> in_lanes = {};
  std::vector<std::string> limbs_in_lanes = {};
  // Set for languages with vectors too: what kernels these programs become.
  KernelForm form = {};
  // The same with a loop over right-hand sides, where the program is long and the language wants one: the function then
  // calls the function that has the name of `right_sides`, whose last output is `factor`, and solves. `program` has
  // inputs and outputs only.
  std::optional<SolvedColumns> solved = {};
  // Set for homogeneous transforms, where products of primitives are asked for: the product in their convention.
  std::optional<Product> product = {};
  // Set for homogeneous transforms without a robot, for checks: the product in the convention where the moved frame is
  // on the right, from all parameters and all variables.
  std::optional<Product> factors = {};
};

}  // namespace robcogen::symbolic
