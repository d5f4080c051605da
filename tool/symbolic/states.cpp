#include "symbolic/states.h"

#include <cmath>
#include <cstdint>

namespace robcogen::symbolic {
namespace {

// Pseudo-random numbers that are the same on every machine (splitmix64).
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// A number between -1 and 1 that a float represents exactly.
double number_of(const std::string& array, std::size_t element, std::size_t state) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : array) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  const std::uint64_t bits = scrambled(scrambled(hash + element) + state);
  constexpr double kScale = 1 << 16;
  return static_cast<double>(static_cast<std::int64_t>(bits >> 47) - (1 << 16)) / kScale;
}

// A unit quaternion rounded to float; its norm is one up to that rounding.
std::array<double, 4> unit_quaternion(const std::string& array, std::size_t first, std::size_t state) {
  std::array<double, 4> q{};
  double square = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = number_of(array, first + i, state) + (i == 0 ? 0.125 : 0.0);
    square += q[i] * q[i];
  }
  for (double& e : q) e = static_cast<double>(static_cast<float>(e / std::sqrt(square)));
  return q;
}

}  // namespace

double input_of(
    const InputArray& array,
    std::size_t element,
    std::size_t state,
    const std::vector<double>& parameters) {
  const double x = number_of(array.name, element, state);
  for (const int first : array.quaternions)
    if (const int i = static_cast<int>(element) - first; i >= 0 && i < 4)
      return unit_quaternion(array.name, at(first), state)[at(i)];
  switch (array.role) {
    case Role::parameters:
      return element < parameters.size() ? parameters[element] : 1.0 + 0.25 * x;
    case Role::joint_position:
      return 3.0 * x;
    case Role::gravity:
      return 10.0 * x;
    case Role::inertia_factor:
      return 0.125 * x;
    case Role::inverse_diagonal:
      return 1.0 + 0.5 * x;
    case Role::contact_activity:
      return x > -0.5 ? 1.0 : 0.0;
    case Role::contact_compliance:
      return 1.0 + 0.5 * x;
    default:
      return 2.0 * x;
  }
}

DoubleDouble exact(std::int64_t n) {
  constexpr std::int64_t kHalf = std::int64_t{1} << 32;
  return two_sum(static_cast<double>(n / kHalf) * static_cast<double>(kHalf), static_cast<double>(n % kHalf));
}

}  // namespace robcogen::symbolic
