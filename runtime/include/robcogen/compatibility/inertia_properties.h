// Mass properties of the links, as the first RobCoGen's InertiaProperties has them.
#pragma once

#include <array>
#include <cstddef>

#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/parameters.h"

namespace robcogen::compatibility {

// Of a link: mass, centre of mass, moments of inertia xx yy zz and products xy xz yz of positive sign, in the axes of
// the link and about its origin.
using LinkNumbers = std::array<double, 10>;

// `numbers` are those of the links, the base first.
template <class Trait, class Robot>
class InertiaPropertiesBase {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = typename Trait::Scalar;
  using CoreS = iit::rbd::Core<Scalar>;
  using IMatrix = InertiaMatrix<Scalar>;
  using Vec3d = typename CoreS::Vector3;

  using Parameters = ParametersOf<Robot, Scalar, typename Robot::DynamicsGetters>;

  InertiaPropertiesBase() { compute(); }
  template <class Getter>
  explicit InertiaPropertiesBase(const Getter* getter) : parameters_(typename Robot::DynamicsGetters(getter)) {
    compute();
  }

  Scalar getTotalMass() const {
    Scalar sum = mass(Robot::kFloatingBase ? 0 : 1);
    for (int link = Robot::kFloatingBase ? 1 : 2; link < Robot::kLinks; ++link) sum = sum + mass(link);
    return sum;
  }

  // Of a link by its number in LinkIdentifiers.
  const IMatrix& tensor(int link) const { return tensors_[link]; }
  const Vec3d& com(int link) const { return coms_[link]; }
  Scalar mass(int link) const { return masses_[link]; }

  // Version 5: new values. The first RobCoGen also takes the getter itself.
  template <class Values>
  void updateParameters(const Values& values) {
    parameters_.set(values);
    compute();
  }
  // Version 0.4: reads the getter again.
  void updateParameters() {
    parameters_.read();
    compute();
  }

  const Parameters& parameters() const { return parameters_; }

 private:
  void compute() {
    std::array<LinkNumbers, Robot::kLinks> numbers{};
    if constexpr (Robot::kHasParameters)
      Robot::link_numbers(parameters_.values.data(), numbers.data()->data());
    else
      numbers = Robot::kLinkNumbers;
    for (std::size_t link = 0; link < numbers.size(); ++link) {
      const LinkNumbers& n = numbers[link];
      const auto at = [&](int i) { return Scalar(n[static_cast<std::size_t>(i)]); };
      typename CoreS::Matrix33 moments;
      moments << at(4), -at(7), -at(8), -at(7), at(5), -at(9), -at(8), -at(9), at(6);
      masses_[link] = at(0);
      coms_[link] = Vec3d(at(1), at(2), at(3));
      tensors_[link].fill(masses_[link], coms_[link], moments);
    }
  }

  IMatrix tensors_[Robot::kLinks];
  Vec3d coms_[Robot::kLinks];
  Scalar masses_[Robot::kLinks];
  Parameters parameters_;
};

}  // namespace robcogen::compatibility
