// One run of an algorithm: its inputs, its graph, and the model's quantities as expressions.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "algorithm/spatial/closures.h"
#include "algorithm/spatial/motion_force.h"
#include "model/kinematic_tree.h"
#include "symbolic/cost.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// A program under construction, over quantities of any model.
class ProgramTrace {
 public:
  ProgramTrace() = default;

  Graph graph;

  // Inputs and outputs: arrays in the order of the calls. Matrices are given column by column.
  std::vector<Expression> input(const std::string& name, symbolic::Role role, std::vector<std::string> elements);
  // The same for elements that are quantities: their labels are the names.
  std::vector<Expression> quantity_input(
      const std::string& name,
      symbolic::Role role,
      const std::vector<symbolic::QuantityRef>& elements);
  // Declares the input `parameters`, unless there are none. Quantities that depend on one can be lifted from then on.
  void parameter_input(const std::vector<model::Parameter>& parameters);

  void output(const std::string& name, symbolic::Role role, const std::vector<Expression>& values);
  void output(const std::string& name, symbolic::Role role, const Motion& value);
  void output(const std::string& name, symbolic::Role role, const Force& value);
  void output(
      const std::string& name,
      symbolic::Role role,
      int rows,
      int columns,
      const std::vector<Expression>& values);
  void output(const std::string& name, symbolic::Role role, int rows, const Columns& columns);

  // Starts a section titled `<kind> <subject>: <what>`; unnamed values in it are numbered after the subject.
  void section(const std::string& subject, const std::string& title);
  // The same with a title in pieces, which are put together only if names are kept: `<before><subject><after>`, or all
  // pieces of a list.
  void section(const std::string& subject, const char* before, const char* after);
  void section(const std::string& subject, std::initializer_list<std::string_view> title);

  // `variables` are the values of the model's variables; for robots the joint positions.
  Expression lift(const model::Quantity& q, const std::vector<Expression>& variables = {});
  Vector3 lift(const std::array<model::Quantity, 3>& q, const std::vector<Expression>& variables = {});

  symbolic::Program program(const std::string& name) const;
  // The cost of that program, without building it unless the model has parameters.
  symbolic::TracedCost cost() const;

 protected:
  std::vector<symbolic::InputArray> inputs_;

 private:
  std::vector<Expression> parameters_;
  std::vector<symbolic::OutputArray> shapes_;
  std::vector<std::vector<Expression>> outputs_;
  int input_elements_ = 0;
};

// Possible values of a robot's parameters: their defaults, or numbers near one.
std::vector<double> parameter_values(const model::KinematicTree& tree);

// A program under construction, over a robot.
class Trace : public ProgramTrace {
 public:
  // A parametric robot's parameters are the first input array of every program.
  explicit Trace(const model::KinematicTree& tree);

  const model::KinematicTree& tree;

  // An input with one element per coordinate.
  std::vector<Expression> coordinate_input(const std::string& name, symbolic::Role role);
  // Positions, references, velocities or accelerations of all joints, from an input of those of the coordinates.
  // Positions are followed by the scalar parts of the quaternions of spherical joints; the components of these joints
  // have the other parts.
  std::vector<Expression> joint_input(const std::string& name, symbolic::Role role);
  // The same, from values of the coordinates.
  std::vector<Expression> by_joint(
      const std::string& name,
      symbolic::Role role,
      const std::vector<Expression>& coordinates);
  // The accelerations of all joints if those of the coordinates are zero. They are those of the dependent joints of
  // loops, at the last velocities of the trace.
  std::vector<Expression> accelerations_at_rest();
  // For a motion `v` of all joints that keeps loops closed: the terms that are added to its rate, by joint, while
  // joints move with `qd` (dG/dt y for v = G y).
  std::vector<Expression> added_by_loops(const std::vector<Expression>& qd, const std::vector<Expression>& v);
  // The rates of such a motion, from an input of those of the coordinates.
  std::vector<Expression> reference_acceleration_input(
      const std::string& name,
      const std::vector<Expression>& qd,
      const std::vector<Expression>& v);
  // Elements of q, from positions by joint as joint_input returns them.
  std::vector<Expression> positions(const std::vector<Expression>& joints) const;
  // The rate of a dependent joint of a loop, as a combination of those of coordinates.
  const std::vector<RateTerm>& rates_of(const model::Coupling& coupling);
  // By loop: the force of its second end on its first one (TracedClosure::reaction), from the forces that a motion
  // needs at all joints, at the positions q by joint.
  std::vector<std::vector<Expression>> reactions(const std::vector<Expression>& q, std::vector<Expression> forces);
  // The pose of the base in the world: unit quaternion w, x, y, z, then position.
  std::vector<Expression> base_pose_input();
  Vector3 vector_input(const std::string& name, symbolic::Role role);
  Motion motion_input(const std::string& name, symbolic::Role role);
  // One wrench per link, base first, in link coordinates about the link's origin; zero for repeated links.
  std::vector<Force> link_wrench_input();

 private:
  std::vector<std::unique_ptr<TracedClosure>> closures_;  // at the positions of the trace
  std::vector<Expression> positions_, velocities_;        // by joint
  std::vector<std::vector<RateTerm>> rates_;              // by dependent joint of a loop

  std::vector<symbolic::Rate> motion_of_positions(const std::vector<Expression>& qd);
  void follow(std::size_t closure, symbolic::Role role, std::vector<Expression>& joints);
  // Positions by coordinate, then the scalar parts of quaternions, then dependent joints in q.
  std::vector<Expression> position_input(const std::string& name, symbolic::Role role);
};

}  // namespace robcogen::algorithm
