// One library for several legs: the joint forces of HyL, of a leg with a payload on its slider, and of a leg with a
// longer shank.
#include <hyl_parametric/hyl_parametric.h>

#include <iostream>

namespace leg = hyl_parametric;

// Values may come from anywhere, here from a scale that is read at run time.
class Scale : public leg::DynamicsParameters {
 public:
  double get_slider_mass() const noexcept override { return 3.982 + payload; }
  double get_upperleg_mass() const noexcept override { return 2.638; }
  double get_lowerleg_mass() const noexcept override { return 0.881; }

  double payload = 0;  // kg
};

void print(const char* name, const leg::Parameters<>& parameters) {
  const leg::JointState q(0.64, -0.65, 1.34);
  const auto base_X_foot = leg::transforms::homogeneous::fr_base_X_fr_foot(parameters, q);
  std::cout << name << ": gravity forces [N, N m, N m] " << leg::gravity_forces(parameters, q).transpose()
            << ", foot at z = " << base_X_foot(2, 3) << " m\n";
}

int main() {
  std::cout.precision(4);
  leg::Parameters<> parameters;  // the defaults of the document
  print("HyL      ", parameters);

  Scale scale;
  scale.payload = 5;
  parameters.update(scale);  // new mass properties, lengths as before
  print("payload  ", parameters);

  leg::ParameterValues values;
  values.lowerleg_length = 0.4;
  parameters.update(values);
  print("long leg ", parameters);
  std::cout << '\n';
}
