#include "model/unlike_limbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/limbs.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

const char* name_of(JointType type) {
  switch (type) {
    case JointType::revolute:
      return "revolute";
    case JointType::prismatic:
      return "prismatic";
    case JointType::helical:
      return "helical";
    case JointType::spherical:
      break;
  }
  return "spherical";
}

class Comparison {
 public:
  explicit Comparison(const KinematicTree& tree) : tree_(tree), shapes_(limb_shapes(tree)) {}

  std::vector<UnlikeLimbs> run() {
    visit(0);
    return std::move(result_);
  }

 private:
  const KinematicTree& tree_;
  const std::vector<int> shapes_;
  std::vector<UnlikeLimbs> result_;

  const std::string& name(int joint) const { return tree_.joints[at(joint)].name; }
  int size(int joint) const { return static_cast<int>(limb_joints(tree_, shapes_, joint).size()); }
  // The joints on a joint's child, the longest limb first.
  std::vector<int> beyond(int joint) const {
    std::vector<int> joints = tree_.links[at(tree_.joints[at(joint)].child)].child_joints;
    std::stable_sort(joints.begin(), joints.end(), [&](int a, int b) { return size(a) > size(b); });
    return joints;
  }

  void visit(int link) {
    constexpr int kLeast = 3, kMostDifferent = 2;  // joints
    std::vector<int> alone;
    const std::vector<int>& joints = tree_.links[at(link)].child_joints;
    for (const int joint : joints) {
      const auto alike = std::count_if(
          joints.begin(), joints.end(), [&](int other) { return shapes_[at(other)] == shapes_[at(joint)]; });
      if (alike > 1) continue;
      alone.push_back(joint);
      visit(tree_.joints[at(joint)].child);
    }
    while (alone.size() > 1) {
      const int first = alone.front();
      alone.erase(alone.begin());
      const auto second = std::min_element(alone.begin(), alone.end(), [&](int a, int b) {
        return std::abs(size(a) - size(first)) < std::abs(size(b) - size(first));
      });
      if (std::min(size(first), size(*second)) < kLeast || std::abs(size(*second) - size(first)) > kMostDifferent)
        continue;
      result_.push_back({name(first), name(*second), difference(first, *second)});
      alone.erase(second);
    }
  }

  // The first difference between two limbs of different shapes.
  std::string difference(int a, int b) const {
    const Joint &first = tree_.joints[at(a)], &second = tree_.joints[at(b)];
    if (first.type != second.type)
      return fmt::format("{} is {}, {} is {}", name(a), name_of(first.type), name(b), name_of(second.type));
    if (first.pitch.is_zero() != second.pitch.is_zero())
      return fmt::format("one of {} and {} has a pitch", name(a), name(b));
    if (first.drive.present(tree_.uses_passive_forces) != second.drive.present(tree_.uses_passive_forces))
      return fmt::format("{} and {} have rotors, friction, damping or springs that differ in kind", name(a), name(b));
    const std::vector<int> of_a = beyond(a), of_b = beyond(b);
    if (of_a.size() != of_b.size())
      return fmt::format(
          "{} carries {} joint{}, {} carries {}", name(a), of_a.size(), of_a.size() == 1 ? "" : "s", name(b),
          of_b.size());
    for (std::size_t k = 0; k < of_a.size(); ++k)
      if (shapes_[at(of_a[k])] != shapes_[at(of_b[k])]) return difference(of_a[k], of_b[k]);
    return fmt::format(
        "{} tie {} or {} to other joints in different ways",
        tree_.tendons.empty() ? "couplings or loops" : "couplings, tendons or loops", name(a), name(b));
  }
};

}  // namespace

std::vector<UnlikeLimbs> unlike_limbs(const KinematicTree& tree) {
  return Comparison(tree).run();
}

}  // namespace robcogen::model
