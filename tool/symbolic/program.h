// The neutral intermediate representation: a program of named scalar statements from input arrays to output arrays.
//
// A program is data. It prints as text and reads back (text.h), is verified (verify.h), interpreted (interpret.h),
// counted (cost.h), rewritten by passes (tool/pass) and spelled in a target language (tool/backend).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "symbolic/constant.h"
#include "symbolic/quantity.h"

namespace robcogen::symbolic {

// `arc_tangent` has two operands: it is the angle, from -PI to PI, whose sine is the first and whose cosine is the
// second. The last two operations occur in programs with lanes only: `gather` makes several scalars one value, and
// `sum_lanes` adds the lanes of a value.
enum class Op : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  square_root,
  sine,
  cosine,
  arc_tangent,
  gather,
  sum_lanes
};

constexpr bool is_binary(Op op) {
  return op == Op::add || op == Op::subtract || op == Op::multiply || op == Op::divide || op == Op::arc_tangent;
}

// What a statement reads: a constant, an element of an input array, or an earlier statement; possibly negated.
struct Operand {
  enum class Kind { constant, input, statement };
  Kind kind = Kind::constant;
  int index = 0;          // into Program::constants, the flat list of input elements, or Program::statements
  bool negative = false;  // costs nothing: passes and back ends fold it into an addition or a subtraction
  int lane = -1;          // of a statement with lanes: one lane, a scalar; -1: all lanes
  friend bool operator==(const Operand&, const Operand&) = default;
};

struct Statement {
  Op op = Op::add;
  Operand a;
  Operand b;           // unused by unary operations
  std::string name;    // if the program was read from text: its name there; otherwise empty
  int section = 0;     // into Program::sections
  bool named = false;  // passes and back ends keep it as a statement of its own, with the name of its quantity
  // Number of lanes. The operation is applied in each lane; a scalar operand is the same in all of them.
  int width = 1;
  std::vector<Operand> lanes = {};  // of gather: a scalar per lane
  QuantityRef quantity = {};        // what the value is; null: nothing is known
};

constexpr bool is_sum(Op op) {
  return op == Op::add || op == Op::subtract;
}

// Whether the name of the value says what it is; otherwise it is a number within the section.
inline bool has_meaning(const Statement& s) {
  return s.quantity != nullptr;
}

inline bool is_statement(const Operand& o) {
  return o.kind == Operand::Kind::statement;
}

inline bool is_constant(const Operand& o) {
  return o.kind == Operand::Kind::constant;
}

// Calls f on every operand of a statement, in order; f may change the operands of a statement that is not const.
template <class AnyStatement, class F>
void for_each_operand(AnyStatement& s, F f) {
  if (s.op == Op::gather) {
    for (auto& o : s.lanes) f(o);
    return;
  }
  f(s.a);
  if (is_binary(s.op)) f(s.b);
}

// What the elements of an array mean. Back ends choose types by it and know nothing else about the algorithm.
enum class Role {
  joint_position,           // rad or m
  joint_reference,          // joint positions other than those of the robot: rad or m
  joint_sine,               // of joint positions, then of sums of joint positions
  joint_cosine,             // in the same order
  joint_velocity,           // rad/s or m/s
  joint_acceleration,       // rad/s^2 or m/s^2
  joint_force,              // N m or N
  gravity,                  // 3: m/s^2, base coordinates
  base_pose,                // 7: unit quaternion w, x, y, z from base axes to world axes, base origin in the world
  base_velocity,            // 6: twist, angular first, base coordinates
  base_acceleration,        // 6: spatial acceleration, base coordinates, gravity not included
  base_wrench,              // 6: about the base origin, base coordinates
  link_wrenches,            // 6 per link (base first): about the link origin, link coordinates
  inertia_matrix,           // symmetric, base rows first for a floating base; or its inverse
  inertia_factor,           // square: L of such a matrix H = L^T L
  inverse_diagonal,         // the reciprocals of that factor's diagonal
  homogeneous,              // 4 x 4
  spatial_motion,           // 6 x 6, angular first
  spatial_force,            // 6 x 6, angular first
  jacobian,                 // 6 x k, angular rows first: of the right frame's origin, in axes of the left frame
  jacobian_in_target,       // the same in axes of the right frame
  spatial_jacobian,         // 6 x k, angular rows first: of twists about the left frame's origin, in its axes
  jacobian_derivative,      // 6 x k: time derivative of `jacobian`
  matrix,                   // any other matrix, also one of a single row or column
  frame_velocity,           // 6: twist, angular first
  frame_acceleration,       // 6: spatial acceleration, angular first
  frame_bias_acceleration,  // 6: `jacobian_derivative` times the joint velocities
  position,                 // 3: m
  energy,                   // 1: J
  mass,                     // 1: kg
  distance,                 // 1: m
  parameters,               // kinematics, then dynamics parameters
  variables,                // of a document of transforms: m or rad
  contact_activity,         // one per contact: 1 if it holds, 0 if it is open
  contact_compliance,       // not negative
  residual,                 // zero but for rounding, or where solutions meet: its digits do not count
  value,                    // anything else
};

// Whether an array of this role is one number, which languages return as such.
constexpr bool is_number(Role role) {
  return role == Role::energy || role == Role::mass || role == Role::distance;
}

// Whether the columns belong to the joints of a chain.
constexpr bool is_jacobian(Role role) {
  return role == Role::jacobian || role == Role::jacobian_in_target || role == Role::spatial_jacobian ||
         role == Role::jacobian_derivative;
}

// Whether a single column is still a matrix, not a vector.
constexpr bool is_matrix(Role role) {
  return is_jacobian(role) || role == Role::inertia_matrix || role == Role::inertia_factor ||
         role == Role::homogeneous || role == Role::spatial_motion || role == Role::spatial_force ||
         role == Role::matrix;
}

// Arrays of more than one column are stored column by column.
// Whether an input is a square matrix, column by column.
constexpr bool is_square_input(Role role) {
  return role == Role::inertia_factor || role == Role::homogeneous;
}

struct InputArray {
  std::string name;
  Role role = Role::value;
  std::vector<std::string> elements;         // a label for each element: the joint's name, `wx`, …
  std::vector<int> quaternions = {};         // the elements that begin unit quaternions: w, x, y, z
  int followers = 0;                         // of joint positions: how many of the last elements follow the others
  std::vector<QuantityRef> quantities = {};  // of the elements; empty: the labels say all
};

struct OutputArray {
  std::string name;
  Role role = Role::value;
  int rows = 0;
  int columns = 1;
  std::vector<Operand> values;  // rows * columns, column by column
};

// A run of statements that belong together: becomes a comment in generated text.
struct Section {
  std::string title;   // `link lowerleg: velocity and acceleration`
  std::string prefix;  // unnamed statements of the section are numbered as `<prefix>_t<k>`
};

struct Program {
  std::string name;
  std::vector<InputArray> inputs;
  std::vector<OutputArray> outputs;
  std::vector<Constant> constants;  // each non-negative, each once
  std::vector<Section> sections;
  std::vector<Statement> statements;  // operands come before their users

  int input_count() const {
    int n = 0;
    for (const InputArray& array : inputs) n += static_cast<int>(array.elements.size());
    return n;
  }
  bool has_lanes() const {
    return std::any_of(statements.begin(), statements.end(), [](const Statement& s) { return s.width > 1; });
  }
};

// The number of lanes of an operand: those of a statement that is read as a whole, otherwise one.
inline int width_of(const Program& p, const Operand& o) {
  return is_statement(o) && o.lane < 0 ? p.statements[static_cast<std::size_t>(o.index)].width : 1;
}

}  // namespace robcogen::symbolic
