// The input of a back end: a robot or a document of coordinate transforms, and its programs. It contains no algorithm
// and no syntax.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/collision_tree.h"
#include "model/coordinate_transforms.h"
#include "model/elements.h"
#include "support/files.h"
#include "symbolic/cost.h"
#include "symbolic/function.h"
#include "symbolic/program.h"
#include "symbolic/stages.h"

namespace robcogen::backend {

// The convention of the user's Rx(a). Right: it maps coordinates from the frame rotated by +a to the original frame.
// Left: it is the inverse.
enum class PrimitiveConvention { none, left, right };

using ProductData = symbolic::Product;
using PrimitiveData = symbolic::Product::Primitive;
using symbolic::Function;

// Which functions loop over right-hand sides: Function::solved, Library::right_sides.
enum class ColumnLoops {
  none,       // all code is written out
  if_long,    // functions that are too long without the loop
  if_faster,  // also functions that are faster with columns in lanes
};

// A check of collisions that ends early.
struct CollisionCheck {
  model::CollisionTree shapes;
  // One that places the spheres around all parts; then, on demand, those around the groups of each part with several
  // groups, and those of each group with several spheres. Inputs: q and the workspace; outputs: `parts`, `groups` and
  // `spheres`, and the workspace.
  symbolic::Stages stages;
};

// The forms of programs that a language uses.
struct Features {
  bool caches_parameters =
      false;               // functions read values that depend on parameters alone from a cache: Library::updates
  bool has_lanes = false;  // congruent limbs share the lanes of vectors: Function::in_lanes
  bool has_both = false;   // the same, beside the program that is the fastest without lanes
  bool checks_collisions = false;  // there are checks that end early: Library::collision_check
  bool takes_sines = false;        // functions take precomputed sines and cosines: Library::trigonometry
  ColumnLoops column_loops = ColumnLoops::none;
};

struct Library {
  std::string name;               // identifier: namespace and folder
  std::string enclosing;          // enclosing namespace `a::b`, or empty
  std::string model_file;         // file name without folders
  std::string model_hash;         // of the canonical document
  std::string generator_version;  // of the tool: printed in one file only, so that a new version recompiles little
  model::KinematicTree tree;      // the robot; without links: a library of the transforms of `document`
  model::CoordinateTransforms document = {};
  std::vector<model::ContactFrame> contacts = {};   // only if the library has contact functions
  std::vector<model::InverseTarget> inverses = {};  // what the functions of inverse kinematics invert
  std::vector<std::string> groups;                  // the groups that were asked for, in canonical order
  std::vector<Function> functions;
  std::vector<Function> right_sides = {};  // called by functions that have Function::solved
  // For robots with parameters, in languages that cache the values that depend on parameters alone (`functions` then
  // read the cache as their parameters). Each update computes one part of the cache from the parameters: the values
  // that depend on kinematics parameters alone, on dynamics parameters alone, and on both. The parts follow one
  // another.
  std::vector<Function> updates;
  // For the same robots: functions of the parameters that compute the numbers of links, joints and frames, one column
  // per item; and, where joints are coupled, the factors and the offset of each, one column per coupled joint.
  std::vector<Function> numbers;
  // For a robot, in languages whose functions take precomputed sines and cosines: the sines and cosines of all angles.
  // The angles are the positions of all joints, followed by sums of positions.
  struct Trigonometry {
    int angle_count = 0;
    symbolic::Program angles;  // [parameters,] q -> all angles
    Function addition;         // [parameters,] sines and cosines of the joints -> of all angles
  };
  std::optional<Trigonometry> trigonometry = {};
  // Of a robot with collision shapes, if the group `collision` was asked for.
  std::optional<CollisionCheck> collision_check = {};
  PrimitiveConvention primitives = PrimitiveConvention::none;
  bool has_batches = false;              // each function also exists over many states: C++, robots
  std::vector<std::string> levels = {};  // processors, besides the baseline, that kernels are compiled for: C++, robots
  bool has_single_precision = true;      // everything also exists in float: C++

  bool has_robot() const { return !tree.links.empty(); }
  // The name of the robot, or of the model, in the document.
  const std::string& title() const { return has_robot() ? tree.name : document.name; }
  // In the order of the elements of inputs of role `parameters`.
  const std::vector<model::Parameter>& parameters() const {
    return has_robot() ? tree.parameters : document.parameters;
  }
  // The frames that Function::left_frame and right_frame refer to.
  std::vector<std::string> frames() const;
};

// Whether a group has functions of frames: transforms, Jacobians, velocities and accelerations.
bool is_kinematics(const std::string& group);

}  // namespace robcogen::backend
