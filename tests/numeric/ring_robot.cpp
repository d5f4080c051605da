#include "ring_robot.h"

#include <fmt/format.h>

#include <cmath>

#include "at.h"

namespace robcogen::numeric {
namespace {

bool is_before(int link, int cut) {
  return link <= cut;
}

}  // namespace

Ring::Ring(int size, std::uint64_t seed, Shape shape) : size_(size), dice_(seed) {
  constexpr double kPi = 3.14159265358979323846;
  for (int k = 0; k < size; ++k) {
    const double angle = 2 * kPi * k / size;
    pivots_.push_back({0.3 * std::cos(angle) + noise(), 0.3 * std::sin(angle) + noise()});
    heights_.push_back(k == 0 ? 0.0 : noise());
    bodies_.push_back(body());
  }
  if (shape == Shape::flat) {
    const double share = dice_.between(0.3, 2.0);
    pivots_[2] = {
        pivots_[1].x + share * (pivots_[1].x - pivots_[0].x), pivots_[1].y + share * (pivots_[1].y - pivots_[0].y)};
  }
  if (shape != Shape::any)
    pivots_[3] = {pivots_[0].x + pivots_[2].x - pivots_[1].x, pivots_[0].y + pivots_[2].y - pivots_[1].y};
  arm_ = {pivots_[1].x + noise(), pivots_[1].y + noise()};
  turn_of_arm_ =
      fmt::format("rotation = ({}, {}, {})", dice_.between(-1, 1), dice_.between(-1, 1), dice_.between(-1, 1));
}

std::string Ring::name(int pivot) {
  return fmt::format("p{}", pivot);
}

std::string Ring::document(int cut, const std::vector<int>& leaders, const std::string& type) const {
  std::string text = "Robot Ring { RobotBase link0 { " + children(0, cut) + frames(0, cut) + "} ";
  for (int link = 1; link < size_; ++link)
    text += fmt::format(
        "link link{} {{ id = {} inertia_params {{ {} ref_frame = body{} }} {} {} }} ", link, link, bodies_[at(link)],
        link, children(link, cut), frames(link, cut));
  text += "link arm { id = 9 inertia_params { " + bodies_.front() + " } children {} } ";
  for (int pivot = 0; pivot < size_; ++pivot)
    if (pivot != cut) text += joint(pivot, cut);
  text += "r_joint extra { ref_frame { " + place(2, cut, arm_, heights_[2]) + " " + turn_of_arm_ +
          " } } loops { cut { frames = left ~ right type = " + type + " } } ";
  text += "independent { extra";
  for (const int leader : leaders) text += ", " + name(leader);
  return text + " } }";
}

std::vector<std::vector<int>> Ring::choices_of_leaders(int cut) const {
  std::vector<std::vector<int>> choices;
  for (int a = 0; a < size_; ++a) {
    if (a == cut) continue;
    if (size_ == 4) choices.push_back({a});
    for (int b = a + 1; size_ == 5 && b < size_; ++b)
      if (b != cut) choices.push_back({a, b});
  }
  return choices;
}

double Ring::noise() {
  return dice_.between(-0.05, 0.05);
}

std::string Ring::body() {
  const double m = dice_.between(0.3, 2.0), s = dice_.between(0.002, 0.02);
  return fmt::format(
      "mass = {} CoM = ({}, {}, {}) Ix = {} Iy = {} Iz = {} Ixy = {} Ixz = {} Iyz = {}", m, noise(), noise(), noise(),
      3 * m * s, 2.5 * m * s, 3.5 * m * s, 0.2 * m * s, -0.1 * m * s, 0.15 * m * s);
}

// Returns the origin of the link's frame at q = 0.
Ring::Point Ring::origin(int link, int cut) const {
  if (link == 0) return {0, 0};
  return is_before(link, cut) ? pivots_[at(link - 1)] : pivots_[at(link)];
}

std::string Ring::place(int link, int cut, const Point& p, double height) const {
  const Point o = origin(link, cut);
  return fmt::format("translation = ({}, {}, {})", p.x - o.x, p.y - o.y, height - heights_[at(link)]);
}

std::string Ring::children(int link, int cut) const {
  std::string text = "children { ";
  const auto add = [&](int child, int pivot) { text += fmt::format("link{} via {} ", child, name(pivot)); };
  if (link < cut) add(link + 1, link);
  if (link == 0 && cut < size_ - 1) add(size_ - 1, size_ - 1);
  if (link > cut + 1) add(link - 1, link - 1);
  if (link == 2) text += "arm via extra ";
  return text + "} ";
}

std::string Ring::frames(int link, int cut) const {
  std::string text;
  const auto add = [&](const std::string& frame, const Point& p, double height) {
    text += fmt::format("{} {{ {} rotation = (0.0, 0.0, 0.0) }} ", frame, place(link, cut, p, height));
  };
  if (link > 0) add(fmt::format("body{}", link), pivots_[at(link - 1)], heights_[at(link)]);
  if (link == cut) add("left", pivots_[at(cut)], heights_[at(cut)]);
  if (link == (cut + 1) % size_) add("right", pivots_[at(cut)], heights_[at(cut)]);
  return text.empty() ? "" : "frames { " + text + "} ";
}

std::string Ring::joint(int pivot, int cut) const {
  const int next = (pivot + 1) % size_;
  const int parent = pivot < cut ? pivot : next, child = pivot < cut ? next : pivot;
  return fmt::format(
      "r_joint {} {{ ref_frame {{ {} rotation = (0.0, 0.0, 0.0) }} }} ", name(pivot),
      place(parent, cut, pivots_[at(pivot)], heights_[at(child)]));
}

}  // namespace robcogen::numeric
