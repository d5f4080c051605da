#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/newton_euler.h"

namespace robcogen::algorithm {

symbolic::Program loop_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in = motion_inputs(trace);
  const TracedMotion motion(trace, in, loads, formulation);
  std::vector<Expression> forces;
  for (const std::vector<Expression>& force : trace.reactions(in.q, motion.forces.tau))
    forces.insert(forces.end(), force.begin(), force.end());
  trace.output("forces", symbolic::Role::value, forces);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
