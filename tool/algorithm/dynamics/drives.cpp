#include "algorithm/dynamics/drives.h"

#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {

Expression drive_inertia(Trace& trace, int joint) {
  return trace.lift(trace.tree.joints[at(joint)].drive.armature);
}

std::vector<Expression> passive_forces(Trace& trace, const StateInputs& in) {
  std::vector<Expression> forces(in.qd.size());
  for (std::size_t j = 0; j < forces.size(); ++j) {
    const model::Joint& joint = trace.tree.joints[j];
    if (!joint.drive.is_passive()) continue;
    trace.section(joint.name, "joint " + joint.name + ": passive forces");
    forces[j] = trace.lift(joint.drive.damping) * in.qd[j];
    describe(forces[j], joint.name + "_passive");
  }
  return forces;
}

void add_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau) {
  const std::vector<Expression> forces = passive_forces(trace, in);
  for (std::size_t j = 0; j < tau.size(); ++j) tau[j] += forces[j];
}

void subtract_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau) {
  const std::vector<Expression> forces = passive_forces(trace, in);
  for (std::size_t j = 0; j < tau.size(); ++j) tau[j] -= forces[j];
}

}  // namespace robcogen::algorithm
