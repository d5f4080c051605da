// One library, three arms: the torques that hold the arm out straight, and where its tool is.
#include <arm/arm.h>

#include <cstdio>

void print(const char* name, const arm::Parameters<>& parameters) {
  const arm::JointState straight = arm::JointState::Zero();
  const arm::JointState tau = arm::gravity_forces(parameters, straight);
  const Eigen::Matrix4d X = arm::transforms::homogeneous::fr_base_X_tool(parameters, straight);
  std::printf("%-18s shoulder %6.3f N m  elbow %6.3f N m  tool at x = %.2f m\n", name, tau[0], tau[1], X(0, 3));
}

int main() {
  arm::Parameters<> parameters;  // the defaults of the document
  print("as in the document", parameters);

  arm::ParameterValues values;
  values.payload = 0.5;  // kg
  parameters.update(values);
  print("with 0.5 kg", parameters);

  values.forearm_length = 0.6;  // m
  parameters.update(values);
  print("and a long forearm", parameters);
}
