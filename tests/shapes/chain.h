// The robot of chain.urdf: a joint about z, one about y, one about x and a prismatic joint along z, each 0.5 m above
// the last one in its own link. Its kinematics and distances, written down without the code under test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace robcogen::test {

using Point = std::array<double, 3>;
using Numbers = std::vector<double>;

// A point of a link in the base.
inline Point in_base(std::size_t link, const Numbers& q, Point p) {
  const auto turn = [&](std::size_t a, std::size_t b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), x = p[a], y = p[b];
    p[a] = c * x - s * y;
    p[b] = s * x + c * y;
  };
  for (std::size_t k = link; k-- > 0;) {
    if (k == 0) turn(0, 1, q[0]);
    if (k == 1) turn(2, 0, q[1]);
    if (k == 2) turn(1, 2, q[2]);
    if (k == 3) p[2] += q[3];
    p[2] += 0.5;
  }
  return p;
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// The minimum between 0 and 1 by golden sections: no formula is shared with the code under test.
template <class F>
double least(F f) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double low = 0, high = 1;
  for (int k = 0; k < 45; ++k) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    const bool is_left = f(a) < f(b);
    (is_left ? high : low) = is_left ? b : a;
  }
  return std::min({f(0.0), f(1.0), f((low + high) / 2)});
}

inline double distance_of_segments(const std::array<Point, 2>& a, const std::array<Point, 2>& b) {
  return least([&](double s) {
    const Point p = between(a[0], a[1], s);
    return least([&](double t) { return distance(p, between(b[0], b[1], t)); });
  });
}

inline Point along(const Point& p, double length, const Point& axis) {
  return {p[0] + length * axis[0], p[1] + length * axis[1], p[2] + length * axis[2]};
}

// The ends of their axes, in the frames of the URDF: Rz(0.4) Ry(1.2) and Rx(0.5) turn two of them.
inline const Point kTilted = {std::cos(0.4) * std::sin(1.2), std::sin(0.4) * std::sin(1.2), std::cos(1.2)};
inline const Point kTurned = {0, -std::sin(0.5), std::cos(0.5)};
inline const std::array<std::array<Point, 2>, 5> kEnds = {
    {{along({0.3, 0, 0}, -0.4, kTilted), along({0.3, 0, 0}, 0.4, kTilted)},
     {{{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}}},
     {{{0, 0, 0}, {0, 0, 0.4}}},
     {along({0, 0.1, 0.3}, -0.3, kTurned), along({0, 0.1, 0.3}, 0.3, kTurned)},
     {{{0, 0, 0.1}, {0, 0, 0.1}}}}};

inline constexpr std::array<double, 5> kRadii = {0.1, 0.05, 0.07, 0.08, 0.125};

// Those of links that a joint connects are left out.
inline const std::vector<std::array<std::size_t, 2>> kPairs = {{0, 2}, {0, 3}, {0, 4}, {1, 3}, {1, 4}, {2, 4}};

inline Point end_in_base(std::size_t link, std::size_t end, const Numbers& q) {
  return in_base(link, q, kEnds[link][end]);
}

inline double least_distance(const Numbers& q) {
  double result = 1e9;
  for (const auto& [i, k] : kPairs) {
    const std::array<Point, 2> a = {end_in_base(i, 0, q), end_in_base(i, 1, q)},
                               b = {end_in_base(k, 0, q), end_in_base(k, 1, q)};
    result = std::min(result, distance_of_segments(a, b) - kRadii[i] - kRadii[k]);
  }
  return result;
}

inline std::vector<Numbers> states(std::size_t count) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-2, 2);
  std::vector<Numbers> list = {{0, 0, 0, 0}};
  while (list.size() < count)
    list.push_back({uniform(random), uniform(random), uniform(random), 0.2 * uniform(random)});
  return list;
}

}  // namespace robcogen::test
