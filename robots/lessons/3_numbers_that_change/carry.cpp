// The arm of lesson 2, without and with a load at its tool.
#include <picker/picker.h>
#include <robcogen/payload.h>

#include <cstdio>

int main() {
  const picker::JointState q(0.2, -0.9, 1.4, 0.0);
  picker::Parameters<> parameters;
  const double without = picker::gravity_forces(parameters, q)[1];

  auto values = parameters.array();
  robcogen::Payload load;
  load.mass = 0.5;  // kg
  robcogen::set_payload(picker::kParameterNames, "tool", load, values);
  parameters.update(values);
  const double with = picker::gravity_forces(parameters, q)[1];
  std::printf("arm of lesson 2    shoulder %6.3f N m without, %6.3f N m with 0.5 kg\n", without, with);
}
