// A robot as the motion planner VAMP (https://github.com/KavrakiLab/vamp) takes it: the members of the structures in
// its headers vamp/robots/<robot>.hh, over the shapes of a robot (collision_check.h). Headers of `--vamp` derive from
// this structure; it is compiled against the headers of VAMP that the program has.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <vamp/collision/environment.hh>
#include <vamp/collision/validity.hh>
#include <vamp/vector.hh>

#include "robcogen/collision_check.h"

namespace robcogen {

namespace vamp_robot {
// As in lanes.h: lanes depend on the processor that a file is compiled for.
namespace {

// One configuration in each lane. VAMP's vectors are arrays of registers of the processor.
template <std::size_t rake, std::size_t dimension>
struct Positions {
  static_assert(rake <= ::vamp::FloatVectorWidth, "a block fills at most one register");
  using Value = Lanes<float, static_cast<int>(::vamp::FloatVectorWidth)>;
  Value data[dimension];

  explicit Positions(const ::vamp::FloatVector<rake, dimension>& x) noexcept {
    static_assert(sizeof(data) == sizeof(x.data), "a register for each position");
    std::memcpy(static_cast<void*>(data), &x.data, sizeof(data));
  }
};

// The centres of all spheres.
template <class Shapes, class Value>
struct Placed {
  std::array<Value, static_cast<std::size_t>(3 * Shapes::kSphereCount)> spheres;

  explicit Placed(const Value* q) noexcept {
    collision::Places<Shapes, Value> places(q);
    for (int part = 0; part < Shapes::kPartCount; ++part) {
      const collision::Group& of = Shapes::kParts[collision::at(part)];
      for (int g = of.first; g < of.first + of.count; ++g) {
        const collision::Group& group = Shapes::kGroups[collision::at(g)];
        std::copy_n(places.spheres(part, g), 3 * group.count, spheres.data() + 3 * group.first);
      }
    }
  }
};

}  // namespace
}  // namespace vamp_robot

// Traits: Shapes (of collision_check.h); kName, kEndEffector and kJointNames; kLow and kRange (rad, m), by joint;
// kAttachmentGroups, the groups of spheres that what is attached to the end effector must not touch; and
// end_effector(q, X), the 4 x 4 pose X, column by column, of the end effector in the base.
template <class Traits>
struct VampRobot {
  using Shapes = typename Traits::Shapes;

  static constexpr const char* name = Traits::kName;
  static constexpr std::size_t dimension = Traits::kJointNames.size();
  static constexpr std::size_t n_spheres = static_cast<std::size_t>(Shapes::kSphereCount);
  static constexpr float min_radius = [] {
    double least = Shapes::kRadii[0];
    for (const double r : Shapes::kRadii) least = r < least ? r : least;
    return static_cast<float>(least);
  }();
  static constexpr float max_radius = [] {
    double most = 0;
    for (const double r : Shapes::kRadii) most = r > most ? r : most;
    return static_cast<float>(most);
  }();
  static constexpr std::size_t resolution = 32;
  static constexpr std::array<std::string_view, dimension> joint_names = Traits::kJointNames;
  static constexpr const char* end_effector = Traits::kEndEffector;

  using Configuration = ::vamp::FloatVector<dimension>;
  using ConfigurationArray = std::array<::vamp::FloatT, dimension>;
  struct alignas(::vamp::FloatVectorAlignment) ConfigurationBuffer
      : std::array<float, Configuration::num_scalars_rounded> {};
  template <std::size_t rake>
  using ConfigurationBlock = ::vamp::FloatVector<rake, dimension>;
  template <std::size_t rake>
  struct Spheres {
    ::vamp::FloatVector<rake, n_spheres> x, y, z, r;
  };
  // For each sphere the obstacles that it touches, and the pairs of spheres that overlap.
  using Debug = std::pair<std::vector<std::vector<std::string>>, std::vector<std::pair<std::size_t, std::size_t>>>;

  // From numbers between 0 and 1 to positions, and back.
  static void scale_configuration(Configuration& q) noexcept { q = q * of(Traits::kRange) + of(Traits::kLow); }
  static void descale_configuration(Configuration& q) noexcept { q = (q - of(Traits::kLow)) * of(reciprocals()); }
  template <std::size_t rake>
  static void scale_configuration_block(ConfigurationBlock<rake>& q) noexcept {
    for (std::size_t i = 0; i < dimension; ++i) q[i] = Traits::kLow[i] + q[i] * Traits::kRange[i];
  }
  template <std::size_t rake>
  static void descale_configuration_block(ConfigurationBlock<rake>& q) noexcept {
    for (std::size_t i = 0; i < dimension; ++i) q[i] = (q[i] - Traits::kLow[i]) * reciprocals()[i];
  }
  static float space_measure() noexcept {
    double product = 1;
    for (const float range : Traits::kRange) product *= range;
    return static_cast<float>(product);
  }

  template <std::size_t rake>
  static void sphere_fk(const ConfigurationBlock<rake>& x, Spheres<rake>& out) noexcept {
    const Placed<rake> placed(Positions<rake>(x).data);
    for (std::size_t i = 0; i < n_spheres; ++i) {
      const auto& center = placed.spheres;
      out.x[i] = vector<rake>(center[3 * i]);
      out.y[i] = vector<rake>(center[3 * i + 1]);
      out.z[i] = vector<rake>(center[3 * i + 2]);
      out.r[i] = radius(i);
    }
  }

  // Whether all configurations of the block are free.
  template <std::size_t rake>
  static bool fkcc(
      const ::vamp::collision::Environment<::vamp::FloatVector<rake>>& environment,
      const ConfigurationBlock<rake>& x) noexcept {
    const Positions<rake> q(x);
    return !in_collision<Shapes>(q.data, [&](const auto& cx, const auto& cy, const auto& cz, double r) {
      return ::vamp::sphere_environment_in_collision(
          environment, vector<rake>(cx), vector<rake>(cy), vector<rake>(cz), static_cast<float>(r));
    });
  }

  // The same, with the spheres that are attached to the end effector.
  template <std::size_t rake>
  static bool fkcc_attach(
      const ::vamp::collision::Environment<::vamp::FloatVector<rake>>& environment,
      const ConfigurationBlock<rake>& x) noexcept {
    using Vector = ::vamp::FloatVector<rake>;
    if (!fkcc<rake>(environment, x)) return false;
    const Positions<rake> q(x);
    typename Positions<rake>::Value pose[16];
    Traits::end_effector(q.data, pose);
    Eigen::Transform<Vector, 3, Eigen::Isometry> X;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r) X(r, c) = vector<rake>(pose[4 * c + r]);
    ::vamp::collision::set_attachment_pose(environment, X);
    if (::vamp::attachment_environment_collision(environment)) return false;
    const Placed<rake> placed(Positions<rake>(x).data);
    for (const int group : Traits::kAttachmentGroups)
      for (int k = 0; k < Shapes::kGroups[at(group)].count; ++k) {
        const auto s = static_cast<std::size_t>(Shapes::kGroups[at(group)].first + k);
        if (::vamp::attachment_sphere_collision<Vector>(
                environment, vector<rake>(placed.spheres[3 * s]), vector<rake>(placed.spheres[3 * s + 1]),
                vector<rake>(placed.spheres[3 * s + 2]), radius(s)))
          return false;
      }
    return true;
  }

  template <std::size_t rake>
  static Debug fkcc_debug(
      const ::vamp::collision::Environment<::vamp::FloatVector<rake>>& environment,
      const ConfigurationBlock<rake>& x) noexcept {
    using Vector = ::vamp::FloatVector<rake>;
    const Placed<rake> placed(Positions<rake>(x).data);
    Debug result;
    for (std::size_t s = 0; s < n_spheres; ++s)
      result.first.push_back(::vamp::sphere_environment_get_collisions<Vector>(
          environment, vector<rake>(placed.spheres[3 * s]), vector<rake>(placed.spheres[3 * s + 1]),
          vector<rake>(placed.spheres[3 * s + 2]), radius(s)));
    for (const collision::Pair& pair : Shapes::kPairs)
      for (int i = first_sphere(pair.a); i < first_sphere(pair.a + 1); ++i)
        for (int k = first_sphere(pair.b); k < first_sphere(pair.b + 1); ++k)
          if (collision::nearer(
                  &placed.spheres[3 * at(i)], &placed.spheres[3 * at(k)],
                  Shapes::kRadii[at(i)] + Shapes::kRadii[at(k)]))
            result.second.emplace_back(at(i), at(k));
    return result;
  }

  static Eigen::Isometry3f eefk(const ConfigurationArray& q) noexcept {
    Eigen::Isometry3f X;
    Traits::end_effector(q.data(), X.data());
    return X;
  }

 private:
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
  // Of a part; the number of spheres for the part after the last one.
  static int first_sphere(int part) {
    if (part == Shapes::kPartCount) return Shapes::kSphereCount;
    return Shapes::kGroups[at(Shapes::kParts[at(part)].first)].first;
  }
  static constexpr float radius(std::size_t sphere) { return static_cast<float>(Shapes::kRadii[sphere]); }

  static Configuration of(const std::array<float, dimension>& numbers) noexcept { return Configuration(numbers); }
  static constexpr std::array<float, dimension> reciprocals() noexcept {
    std::array<float, dimension> result{};
    for (std::size_t i = 0; i < dimension; ++i)
      result[i] = static_cast<float>(1.0 / static_cast<double>(Traits::kRange[i]));
    return result;
  }

  template <std::size_t rake>
  using Positions = vamp_robot::Positions<rake, dimension>;
  template <std::size_t rake>
  using Placed = vamp_robot::Placed<Shapes, typename Positions<rake>::Value>;

  template <std::size_t rake>
  static ::vamp::FloatVector<rake> vector(const typename Positions<rake>::Value& value) noexcept {
    ::vamp::FloatVector<rake> result;
    static_assert(sizeof(result.data) == sizeof(value), "one register");
    std::memcpy(&result.data, &value, sizeof(value));
    return result;
  }
};

}  // namespace robcogen
