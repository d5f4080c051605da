#include "samples.h"

#include <array>
#include <limits>
#include <map>
#include <numeric>

#include "../unit/model/trees.h"
#include "symbolic/expression.h"

namespace robcogen::test {
namespace {

using backend::Function;
using backend::Library;
using model::JointType;
using model::test::add_frame;
using model::test::add_link;
using model::test::body;
using model::test::only_base;
using symbolic::Expression;
using symbolic::Role;

using Names = std::vector<std::string>;
using Values = std::vector<Expression>;

const Names kDynamics = {"inverse_dynamics", "bias_forces", "forward_dynamics", "joint_space_inertia"};
const Names kAxes = {"x", "y", "z"};
const Names kSpatial = {"wx", "wy", "wz", "vx", "vy", "vz"};

// Builds one program: inputs in the order of the calls, followed by outputs.
class Sketch {
 public:
  symbolic::Graph graph;

  Values input(const std::string& name, Role role, const Names& elements) {
    Values values;
    for (std::size_t k = 0; k < elements.size(); ++k) values.push_back(graph.input(count_++));
    inputs_.push_back({name, role, elements});
    return values;
  }

  void output(const std::string& name, Role role, int rows, int columns, const Values& values) {
    shapes_.push_back({name, role, rows, columns, {}});
    outputs_.push_back(values);
  }

  Expression constant(double value) { return graph.constant(value); }

  symbolic::Program program(const std::string& name) const { return graph.program(name, inputs_, shapes_, outputs_); }

 private:
  int count_ = 0;
  std::vector<symbolic::InputArray> inputs_;
  std::vector<symbolic::OutputArray> shapes_;
  std::vector<Values> outputs_;
};

Function function(
    const std::string& group,
    const std::string& scope,
    const std::string& name,
    const std::string& kernel,
    const Sketch& sketch) {
  Function f;
  f.group = group;
  f.scope = scope;
  f.name = name;
  f.kernel = kernel;
  f.summary = {"Sample " + kernel + "."};
  f.program = sketch.program(kernel);
  return f;
}

Library library(const std::string& name, const std::string& base, bool floating_base = false) {
  Library result;
  result.name = name;
  result.model_file = name + ".kindsl";
  result.model_hash = "0123456789abcdef";
  result.generator_version = "0";
  result.tree = only_base(name, base, floating_base);
  return result;
}

Names joint_names(const Library& library) {
  return model::names_of(library.tree, library.tree.coordinates());
}

Names wrench_names(const Library& library) {
  Names names;
  for (const model::Link& link : library.tree.links)
    for (const char* element : {"nx", "ny", "nz", "fx", "fy", "fz"}) names.push_back(link.name + "_" + element);
  return names;
}

// ---------------------------------------------------------------------------------------------------------------------
// Cart and pole

constexpr double kCart = 1.5, kPole = 0.4;              // kg
constexpr int kTip = 5;                                 // the frame fr_tip
constexpr double kLength = 0.7, kPoleInertia = 0.0317;  // m to the centre of mass, kg m^2 about it

struct CartPole {
  Sketch sketch;
  Values q, qd;
  Expression s, c;
  std::array<Expression, 3> h;  // H(0,0), H(0,1), H(1,1)

  CartPole() = default;
  CartPole(const CartPole&) = delete;
  CartPole& operator=(const CartPole&) = delete;

  void take_position() {
    q = sketch.input("q", Role::joint_position, {"CART", "POLE"});
    s = sin(q[1]);
    c = cos(q[1]);
  }

  void inertia() {
    sketch.graph.begin_section("link pole: inertia", "pole");
    h = {
        sketch.constant(kCart + kPole), kPole * kLength * c, sketch.constant(kPole * kLength * kLength + kPoleInertia)};
  }

  // The forces that velocities, gravity and external wrenches cause. Gravity acts in the x-z plane; the pole hangs
  // along -z and turns about -y, and the link coordinates of the pole turn with it.
  Values bias(bool velocities, const Values& gravity, const Values& external) {
    sketch.graph.begin_section("link pole: bias forces", "pole");
    Values tau(2);
    if (velocities) tau[0] = -(kPole * kLength * (s * (qd[1] * qd[1])));
    tau[0] -= (kCart + kPole) * gravity[0];
    tau[1] -= kPole * kLength * (c * gravity[0] + s * gravity[2]);
    if (external.empty()) return tau;
    const Expression fx = external[15], fz = external[17];
    tau[0] -= external[9] + c * fx - s * fz;
    tau[1] += external[13];
    return tau;
  }
};

struct Loads {
  std::string suffix;
  bool gravity = false, external = false;
};

const std::vector<Loads> kLoads = {{"", false, false}, {"_gravity", true, false}, {"_external", true, true}};

Function cart_pole_dynamics(const Library& library, const std::string& name, const Loads& loads) {
  CartPole p;
  p.take_position();
  const bool forward = name == "forward_dynamics", inverse = name == "inverse_dynamics";
  const bool velocities = name != "gravity_forces";
  if (velocities) p.qd = p.sketch.input("qd", Role::joint_velocity, {"CART", "POLE"});
  Values x;
  if (inverse) x = p.sketch.input("qdd", Role::joint_acceleration, {"CART", "POLE"});
  if (forward) x = p.sketch.input("tau", Role::joint_force, {"CART", "POLE"});
  Values gravity = {Expression(), Expression(), p.sketch.constant(-9.81)};
  if (name == "coriolis_forces") gravity[2] = Expression();
  if (loads.gravity) gravity = p.sketch.input("gravity", Role::gravity, kAxes);
  Values external;
  if (loads.external) external = p.sketch.input("external", Role::link_wrenches, wrench_names(library));
  p.inertia();
  Values tau = p.bias(velocities, gravity, external);
  if (forward) {
    p.sketch.graph.begin_section("accelerations", "cart");
    const Expression u0 = x[0] - tau[0], u1 = x[1] - tau[1];
    const Expression inverse_determinant = p.sketch.graph.one() / (p.h[0] * p.h[2] - p.h[1] * p.h[1]);
    const Values qdd = {
        inverse_determinant * (p.h[2] * u0 - p.h[1] * u1), inverse_determinant * (p.h[0] * u1 - p.h[1] * u0)};
    p.sketch.output("qdd", Role::joint_acceleration, 2, 1, qdd);
    return function("forward_dynamics", "", name, name + loads.suffix, p.sketch);
  }
  if (inverse) {
    p.sketch.graph.begin_section("joint forces", "cart");
    tau[0] += p.h[0] * x[0] + p.h[1] * x[1];
    tau[1] += p.h[1] * x[0] + p.h[2] * x[1];
  }
  p.sketch.output("tau", Role::joint_force, 2, 1, tau);
  return function(inverse ? name : "bias_forces", "", name, name + loads.suffix, p.sketch);
}

// Pose of the pole's tip: fr_base_X_fr_tip.
Function tip_transform(const std::string& form, Role role) {
  CartPole p;
  p.take_position();
  const Expression zero, one = p.sketch.graph.one();
  const Expression x = p.q[0] + kLength * p.s, z = -(kLength * p.c);
  const std::array<std::array<Expression, 3>, 3> R = {{{p.c, zero, -p.s}, {zero, one, zero}, {p.s, zero, p.c}}};
  const std::array<std::array<Expression, 3>, 3> px = {{{zero, -z, zero}, {z, zero, -x}, {zero, x, zero}}};
  const auto element = [&](std::size_t r, std::size_t col) -> Expression {
    if (form == "homogeneous") {
      if (r < 3 && col < 3) return R[r][col];
      return r == 3 ? (col == 3 ? one : zero) : std::array{x, zero, z}[r];
    }
    if (r / 3 == col / 3) return R[r % 3][col % 3];
    if ((r < 3) == (form == "motion")) return zero;
    Expression sum;
    for (std::size_t k = 0; k < 3; ++k) sum += px[r % 3][k] * R[k][col % 3];
    return sum;
  };
  const std::size_t size = form == "homogeneous" ? 4 : 6;
  Values values;
  for (std::size_t k = 0; k < size * size; ++k) values.push_back(element(k % size, k / size));
  p.sketch.output("X", role, static_cast<int>(size), static_cast<int>(size), values);
  Function f = function("transforms", "transforms::" + form, "fr_base_X_fr_tip", form + "_fr_base_X_fr_tip", p.sketch);
  f.left_frame = 0;
  f.right_frame = kTip;
  return f;
}

// Jacobian of the tip (two columns) or of the base frame (no column), in base coordinates.
Function tip_jacobian(bool empty) {
  CartPole p;
  p.take_position();
  const Expression zero, one = p.sketch.graph.one();
  Values values;
  if (!empty) values = {zero, zero, zero, one, zero, zero, zero, -one, zero, kLength * p.c, zero, kLength * p.s};
  p.sketch.output("J", Role::jacobian, 6, empty ? 0 : 2, values);
  const std::string name = empty ? "fr_base_J_fr_base" : "fr_base_J_fr_tip";
  Function f = function("jacobians", "jacobians", name, name, p.sketch);
  f.left_frame = 0;
  f.right_frame = empty ? 0 : kTip;
  if (!empty) f.columns = {0, 1};
  return f;
}

// ---------------------------------------------------------------------------------------------------------------------
// Formulas without physics: each output depends on each input

Values mixture(Sketch& sketch, const Values& x, int outputs) {
  Values result;
  for (int k = 0; k < outputs; ++k) {
    sketch.graph.begin_section("output " + std::to_string(k), "output" + std::to_string(k));
    Expression sum = sketch.constant(0.125 * (k + 1));
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += (0.1 * (k + 1) + 0.01 * static_cast<double>(i)) * x[i];
      sum -= x[i] * x[(i + static_cast<std::size_t>(k) + 1) % x.size()];
    }
    result.push_back(x.empty() ? sum : sum + sin(x[0]));
  }
  return result;
}

struct Array {
  std::string name;
  Role role;
};

// A function of these inputs, each with the length that its role requires.
Function mixed_function(
    const Library& library,
    const std::string& group,
    const std::string& name,
    const std::string& kernel,
    const std::vector<Array>& inputs,
    const std::vector<Array>& outputs) {
  Sketch sketch;
  const int n = library.tree.dof();
  Values all;
  for (const Array& input : inputs) {
    const Names elements = input.role == Role::gravity         ? kAxes
                           : input.role == Role::link_wrenches ? wrench_names(library)
                           : input.role == Role::base_velocity || input.role == Role::base_acceleration
                               ? kSpatial
                               : joint_names(library);
    const Values values = sketch.input(input.name, input.role, elements);
    all.insert(all.end(), values.begin(), values.end());
  }
  for (const Array& output : outputs) {
    const bool matrix = output.role == Role::inertia_matrix || output.role == Role::inertia_factor;
    const bool base = output.role == Role::base_wrench || output.role == Role::base_acceleration;
    const int rows = matrix ? n + (library.tree.floating_base ? 6 : 0) : base ? 6 : n;
    const int columns = matrix ? rows : 1;
    sketch.output(output.name, output.role, rows, columns, mixture(sketch, all, rows * columns));
  }
  return function(group, "", name, kernel, sketch);
}

const Array kQ{"q", Role::joint_position}, kQd{"qd", Role::joint_velocity}, kQdd{"qdd", Role::joint_acceleration};
const Array kTau{"tau", Role::joint_force}, kVelocity{"base_velocity", Role::base_velocity};
const Array kAcceleration{"base_acceleration", Role::base_acceleration}, kWrench{"base_wrench", Role::base_wrench};
const Array kGravity{"gravity", Role::gravity}, kExternal{"external", Role::link_wrenches};
const Array kInertia{"H", Role::inertia_matrix};

const Array kFactor{"L", Role::inertia_factor}, kDiagonal{"inverse_diagonal", Role::inverse_diagonal};
const std::string kFactorGroup = "joint_space_inertia_factor";

// H = L^T L of the cart and the pole, and solutions with it, given (L00, L10, L01, L11).
std::vector<Function> cart_pole_factor() {
  CartPole p;
  p.take_position();
  p.inertia();
  const Expression l11 = sqrt(p.h[2]), l10 = p.h[1] / l11, l00 = sqrt(p.h[0] - l10 * l10), one = p.sketch.constant(1);
  p.sketch.output("L", Role::inertia_factor, 2, 2, {l00, l10, Expression(), l11});
  p.sketch.output("inverse_diagonal", Role::inverse_diagonal, 2, 1, {one / l00, one / l11});
  std::vector<Function> result = {function(kFactorGroup, "", kFactorGroup, kFactorGroup, p.sketch)};
  const auto add = [&](const std::string& name, const auto& build) {
    Sketch sketch;
    const Values L = sketch.input("L", Role::inertia_factor, {"L00", "L10", "L01", "L11"});
    const Values r = sketch.input("inverse_diagonal", Role::inverse_diagonal, {"CART", "POLE"});
    build(sketch, Values{r[0], -(L[1] * r[0] * r[1]), Expression(), r[1]});
    result.push_back(function(kFactorGroup, "inertia_factor", name, "inertia_factor_" + name, sketch));
  };
  add("solve", [](Sketch& sketch, const Values& m) {
    const Values x = sketch.input("x", Role::value, {"CART", "POLE"});
    const Expression y0 = m[0] * x[0] + m[1] * x[1], y1 = m[3] * x[1];
    sketch.output("y", Role::value, 2, 1, {m[0] * y0, m[1] * y0 + m[3] * y1});
  });
  add("inverse", [](Sketch& sketch, const Values& m) {
    const Expression coupled = m[0] * m[1];
    sketch.output("inverse", Role::inertia_matrix, 2, 2, {m[0] * m[0], coupled, coupled, m[1] * m[1] + m[3] * m[3]});
  });
  add("inverse_L", [](Sketch& sketch, const Values& m) { sketch.output("inverse", Role::matrix, 2, 2, m); });
  return result;
}

}  // namespace

Library cart_pole() {
  Library result = library("cart_pole", "base");
  const std::array<double, 6> pole = {1.0 / 3, 1.0 / 7, 1.0 / 11, -1e-5 / 3, 1e-5 / 7, -1e-5 / 13};
  add_link(result.tree, "CART", JointType::prismatic, 0, "cart", body(kCart));
  add_link(result.tree, "POLE", JointType::revolute, 1, "pole", body(kPole, {0, 0, -kLength}, pole));
  result.tree.joints[0].limits = {-0.1, 2.5, 3, std::numeric_limits<double>::infinity()};
  add_frame(result.tree, "fr_tip", 2, model::test::vector(0, 0, -kLength));
  result.groups = kDynamics;
  result.groups.insert(result.groups.end(), {kFactorGroup, "transforms", "jacobians"});
  for (const std::string name : {"inverse_dynamics", "bias_forces", "gravity_forces", "forward_dynamics"})
    for (const Loads& loads : kLoads)
      if (name != "gravity_forces" || !loads.external)
        result.functions.push_back(cart_pole_dynamics(result, name, loads));
  result.functions.push_back(cart_pole_dynamics(result, "coriolis_forces", kLoads[0]));

  CartPole p;
  p.take_position();
  p.inertia();
  p.sketch.output("H", Role::inertia_matrix, 2, 2, {p.h[0], p.h[1], p.h[1], p.h[2]});
  result.functions.push_back(
      function("joint_space_inertia", "", "joint_space_inertia", "joint_space_inertia", p.sketch));

  for (Function& f : cart_pole_factor()) result.functions.push_back(std::move(f));

  result.functions.push_back(tip_transform("homogeneous", Role::homogeneous));
  result.functions.push_back(tip_transform("motion", Role::spatial_motion));
  result.functions.push_back(tip_transform("force", Role::spatial_force));
  result.functions.push_back(tip_jacobian(false));
  result.functions.push_back(tip_jacobian(true));
  return result;
}

Library hopper() {
  Library result = library("hopper", "trunk", true);
  result.enclosing = "legs::floating";
  result.tree.links[0].inertia = body(5.0);
  add_link(result.tree, "LEG", JointType::prismatic, 0, "leg", body(0.5));
  result.groups = kDynamics;
  const auto add = [&](const std::string& group, const std::string& name, std::vector<Array> inputs,
                       const std::vector<Array>& outputs, bool gravity = true, bool external = true) {
    if (gravity) inputs.push_back(kGravity);
    result.functions.push_back(mixed_function(result, group, name, name, inputs, outputs));
    if (!external) return;
    inputs.push_back(kExternal);
    result.functions.push_back(mixed_function(result, group, name, name + "_external", inputs, outputs));
  };
  add("inverse_dynamics", "inverse_dynamics", {kQ, kQd, kQdd, kVelocity}, {kTau, kAcceleration});
  add("inverse_dynamics", "inverse_dynamics_fully_actuated", {kQ, kQd, kQdd, kVelocity, kAcceleration},
      {kTau, kWrench});
  add("bias_forces", "bias_forces", {kQ, kQd, kVelocity}, {kTau, kWrench});
  add("bias_forces", "gravity_forces", {kQ}, {kTau, kWrench}, true, false);
  add("bias_forces", "coriolis_forces", {kQ, kQd, kVelocity}, {kTau, kWrench}, false, false);
  add("forward_dynamics", "forward_dynamics", {kQ, kQd, kTau, kVelocity}, {kQdd, kAcceleration});
  add("joint_space_inertia", "joint_space_inertia", {kQ}, {kInertia}, false, false);
  return result;
}

Library plinth() {
  Library result = library("plinth", "base");
  result.groups = kDynamics;
  result.groups.push_back(kFactorGroup);
  result.functions = {
      mixed_function(result, "inverse_dynamics", "inverse_dynamics", "inverse_dynamics", {kQ, kQd, kQdd}, {kTau}),
      mixed_function(result, "forward_dynamics", "forward_dynamics", "forward_dynamics", {kQ, kQd, kTau}, {kQdd}),
      mixed_function(result, "joint_space_inertia", "joint_space_inertia", "joint_space_inertia", {kQ}, {kInertia}),
      mixed_function(result, kFactorGroup, kFactorGroup, kFactorGroup, {kQ}, {kFactor, kDiagonal}),
      mixed_function(
          result, kFactorGroup, "solve", "inertia_factor_solve", {kFactor, kDiagonal, {"x", Role::value}},
          {{"y", Role::value}})};
  return result;
}

const std::vector<double>& literal_values() {
  static const std::vector<double> values = {
      0.1,
      1.0 / 3.0,
      3.141592653589793,
      -2.718281828459045,
      1e-9,
      1e22,
      123456789.12345679,
      -4503599627370497.5,
      9007199254740993.0,
      1.7976931348623157e308,
      2.2250738585072014e-308,
      5e-324,
      -5e-324,
      1e-310,
      0.30000000000000004,
      1e16,
      1e17,
      100.0,
      0.0};
  return values;
}

Library literals() {
  Library result = library("literals", "base");
  result.groups = {"literals"};
  Sketch sketch;
  Values values;
  for (double v : literal_values()) values.push_back(sketch.constant(v));
  sketch.output("values", Role::value, static_cast<int>(values.size()), 1, values);
  result.functions = {function("literals", "", "literals", "literals", sketch)};
  return result;
}

Library nasty() {
  Library result = library("robot", "base");
  result.tree.name = "R\"obot\\";
  result.model_file = "two words \\";
  result.enclosing = "my::robcogen::class";
  const Names names = {
      "class",
      "I",
      "M_PI",
      "double",
      "_x",
      "__y",
      "q",
      "Scalar",
      "hfe",
      "HFE",
      "linux",
      "major",
      "tau",
      "robcogen",
      "std",
      "kernel",
      "sincos",
      "Joint",
      "left_front_shock_absorber_lower_housing_1",
      "left_front_shock_absorber_lower_housing_2",
      "min",
      "n",
      "index"};
  for (const std::string& name : names) {
    const int parent = result.tree.dof();
    add_link(result.tree, name, JointType::revolute, parent, name);
    add_frame(result.tree, name, parent + 1);
  }
  result.groups = {"inverse_dynamics", "transforms", "jacobians"};

  Sketch sketch;
  const Values q = sketch.input("q", Role::joint_position, names);
  const Values qd = sketch.input("qd", Role::joint_velocity, names);
  Values tau;
  for (std::size_t k = 0; k < names.size(); ++k) {
    sketch.graph.begin_section("link " + names[k] + " \\", names[k]);
    const Expression value = sin(q[k]) * qd[k] + cos(q[k]);
    sketch.graph.name(value, {names[k]});
    tau.push_back(value * (k == 0 ? value : tau.back()));
    sketch.graph.name(tau.back(), {k % 2 == 0 ? "Scalar" : "tau"});
  }
  sketch.output("tau", Role::joint_force, static_cast<int>(tau.size()), 1, tau);
  result.functions.push_back(function("inverse_dynamics", "", "inverse_dynamics", "inverse_dynamics", sketch));

  for (const auto& [left, right] : {std::pair(0, 1), std::pair(4, 5), std::pair(20, 18)}) {
    Sketch chain;
    const Values x = chain.input("q", Role::joint_position, names);
    chain.output("J", Role::jacobian, 6, 1, mixture(chain, {x[0]}, 6));
    const auto l = static_cast<std::size_t>(left), r = static_cast<std::size_t>(right);
    Function f = function("jacobians", "jacobians", names[l] + "_J_" + names[r], names[l] + "_J_" + names[r], chain);
    f.left_frame = model::place_of_frame(result.tree, names[l]);
    f.right_frame = model::place_of_frame(result.tree, names[r]);
    f.columns = {right};
    result.functions.push_back(std::move(f));
  }
  // As many columns as there are joints, which makes a long list.
  Function f = result.functions.back();
  f.name = f.kernel = "all_J_columns";
  f.columns.resize(names.size());
  std::iota(f.columns.begin(), f.columns.end(), 0);
  Sketch chain;
  const Values x = chain.input("q", Role::joint_position, names);
  chain.output(
      "J", Role::jacobian, 6, static_cast<int>(names.size()),
      mixture(chain, {x[0]}, 6 * static_cast<int>(names.size())));
  f.program = chain.program("all_J_columns");
  result.functions.push_back(std::move(f));
  return result;
}

std::vector<Library> samples() {
  return {cart_pole(), hopper(), plinth(), literals(), nasty()};
}

}  // namespace robcogen::test
