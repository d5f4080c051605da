#include "symbolic/states.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace robcogen::symbolic {
namespace {

// Pseudo-random numbers that are the same on every machine (splitmix64).
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t hash(const std::string& text) {
  std::uint64_t result = 0xcbf29ce484222325ULL;
  for (const char c : text) result = (result ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return result;
}

// A number between -1 and 1 that a float represents exactly. `array`: the hash of the array's name.
double number_of(std::uint64_t array, std::size_t element, std::size_t state) {
  const std::uint64_t bits = scrambled(scrambled(array + element) + state);
  constexpr double kScale = 1 << 16;
  return static_cast<double>(static_cast<std::int64_t>(bits >> 47) - (1 << 16)) / kScale;
}

// A unit quaternion rounded to float; its norm is one up to that rounding.
std::array<double, 4> unit_quaternion(std::uint64_t array, std::size_t first, std::size_t state) {
  std::array<double, 4> q{};
  double square = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = number_of(array, first + i, state) + (i == 0 ? 0.125 : 0.0);
    square += q[i] * q[i];
  }
  for (double& e : q) e = static_cast<double>(static_cast<float>(e / std::sqrt(square)));
  return q;
}

// The elements of a 4 x 4 matrix by columns from `begin` on: a pose.
void set_pose(std::vector<Batch<double>>& inputs, std::size_t begin, std::uint64_t array, std::size_t state) {
  const auto [w, x, y, z] = unit_quaternion(array, 0, state);
  const std::array<double, 12> rotation = {
      1 - 2 * (y * y + z * z), 2 * (x * y + z * w),     2 * (x * z - y * w),     0.0,
      2 * (x * y - z * w),     1 - 2 * (x * x + z * z), 2 * (y * z + x * w),     0.0,
      2 * (x * z + y * w),     2 * (y * z - x * w),     1 - 2 * (x * x + y * y), 0.0};
  for (std::size_t k = 0; k < rotation.size(); ++k) inputs[begin + k].value[state] = rotation[k];
  for (std::size_t k = 12; k < 15; ++k) inputs[begin + k].value[state] *= 0.25;
  inputs[begin + 15].value[state] = 1.0;
}

// A value for an element with this role, from a number between -1 and 1.
double value_of(Role role, double x) {
  switch (role) {
    case Role::parameters:
      return 1.0 + 0.25 * x;
    case Role::joint_position:
    case Role::joint_reference:
      return 3.0 * x;
    case Role::gravity:
      return 10.0 * x;
    case Role::inertia_factor:
      return 0.125 * x;
    case Role::inverse_diagonal:
    case Role::contact_compliance:
      return 1.0 + 0.5 * x;
    case Role::contact_activity:
      return x > -0.5 ? 1.0 : 0.0;
    default:
      return 2.0 * x;
  }
}

}  // namespace

std::vector<Batch<double>> inputs_of(const Program& program, const std::vector<double>& parameters) {
  std::vector<Batch<double>> inputs;
  for (const InputArray& array : program.inputs) {
    const std::uint64_t name = hash(array.name);
    const std::size_t begin = inputs.size();
    for (std::size_t k = 0; k < array.elements.size(); ++k) {
      const bool is_given = array.role == Role::parameters && k < parameters.size();
      inputs.push_back(in_all_states<double>(
          [&](std::size_t s) { return is_given ? parameters[k] : value_of(array.role, number_of(name, k, s)); }));
    }
    if (array.role == Role::homogeneous)
      for (std::size_t s = 0; s < kStates; ++s) set_pose(inputs, begin, name, s);
    for (const int first : array.quaternions)
      for (std::size_t s = 0; s < kStates; ++s) {
        const std::array<double, 4> q = unit_quaternion(name, at(first), s);
        for (std::size_t i = 0; i < q.size(); ++i) inputs[begin + at(first) + i].value[s] = q[i];
      }
  }
  return inputs;
}

DoubleDouble exact(std::int64_t n) {
  constexpr std::int64_t kHalf = std::int64_t{1} << 32;
  return two_sum(static_cast<double>(n / kHalf) * static_cast<double>(kHalf), static_cast<double>(n % kHalf));
}

}  // namespace robcogen::symbolic
