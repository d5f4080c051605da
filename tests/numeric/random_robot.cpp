#include "random_robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "at.h"
#include "dice.h"
#include "reference_tables.h"
#include "rewritten_robot.h"
#include "robcogen/reference/dynamics.h"

namespace robcogen::numeric {
namespace {

using model::Inertia;
using model::Joint;
using model::JointType;
using model::KinematicTree;
using model::Link;
using model::Placement;
using model::Quantity;
using model::UserFrame;
using reference::Matrix;
using reference::Vector;

Quantity length(Dice& dice) {
  return dice.chance(0.35) ? Quantity() : Quantity(dice.between(-0.5, 0.5));
}

Quantity angle(Dice& dice) {
  if (dice.chance(0.35)) return Quantity();
  if (dice.chance(0.5)) return Quantity(Number::pi_multiple(dice.below(4) - 1, 2));
  return Quantity(dice.between(-3.14, 3.14));
}

Placement placement(Dice& dice) {
  Placement p;
  for (Quantity& t : p.translation) t = length(dice);
  for (Quantity& r : p.rotation) r = angle(dice);
  return p;
}

// A body of eight point masses around its centre: it is physical, whatever the numbers are.
Inertia inertia(Dice& dice) {
  const double mass = std::pow(10.0, dice.between(-1, 1));
  const bool symmetric = dice.chance(0.3);  // diagonal inertia in link axes about the centre
  const bool centred = dice.chance(0.2);
  std::array<double, 3> centre{};
  for (double& x : centre) x = centred || dice.chance(0.3) ? 0.0 : dice.between(-0.2, 0.2);
  std::array<double, 3> half{};
  for (double& x : half) x = dice.between(0.02, 0.3);

  std::array<double, 3> square{};   // integrals of x x, y y, z z
  std::array<double, 3> product{};  // of x y, x z, y z
  std::array<double, 3> moment{};
  std::vector<std::array<double, 3>> offsets;
  for (int corner = 0; corner < 4; ++corner) {
    std::array<double, 3> offset{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double sign = corner == 3 || corner == static_cast<int>(k) ? 1 : -1;
      offset[k] = symmetric ? sign * half[k] : dice.between(-half[k], half[k]);
    }
    offsets.push_back(offset);
    offsets.push_back({-offset[0], -offset[1], -offset[2]});
  }
  for (const auto& offset : offsets) {
    const double m = mass / static_cast<double>(offsets.size());
    const double x = centre[0] + offset[0], y = centre[1] + offset[1], z = centre[2] + offset[2];
    square[0] += m * x * x, square[1] += m * y * y, square[2] += m * z * z;
    product[0] += m * x * y, product[1] += m * x * z, product[2] += m * y * z;
    moment[0] += m * x, moment[1] += m * y, moment[2] += m * z;
  }
  // Sums that cancel in exact arithmetic leave rounding noise, where documents write zeros.
  const auto clean = [mass](double x) { return std::abs(x) < 1e-14 * mass ? 0.0 : x; };

  Inertia result;
  result.mass = Quantity(mass);
  for (std::size_t k = 0; k < 3; ++k) result.com[k] = Quantity(clean(moment[k]) / mass);
  result.ixx = Quantity(square[1] + square[2]);
  result.iyy = Quantity(square[0] + square[2]);
  result.izz = Quantity(square[0] + square[1]);
  result.ixy = Quantity(clean(product[0]));
  result.ixz = Quantity(clean(product[1]));
  result.iyz = Quantity(clean(product[2]));
  return result;
}

void connect(KinematicTree& robot, int parent, int child, Joint joint) {
  joint.parent = parent;
  joint.child = child;
  robot.joints.push_back(std::move(joint));
  const int index = robot.dof() - 1;
  robot.links[at(parent)].child_joints.push_back(index);
  robot.links[at(child)].parent_joint = index;
}

// Returns the parent of the next link, after `grown` links have been added.
int parent_of_next(Dice& dice, Shape shape, double chain_likeness, int grown) {
  if (shape == Shape::chain) return grown;
  if (shape == Shape::star) return 0;
  return dice.chance(chain_likeness) ? grown : dice.below(grown + 1);
}

KinematicTree shuffled(const KinematicTree& robot, Dice& dice) {
  const auto order = [&](std::size_t size, int fixed) {
    std::vector<int> list(size);
    std::iota(list.begin(), list.end(), 0);
    for (int k = static_cast<int>(size) - 1; k > fixed; --k)
      std::swap(list[at(k)], list[at(fixed + dice.below(k - fixed + 1))]);
    return list;
  };
  return reordered(robot, order(robot.links.size(), 1), order(robot.joints.size(), 0));
}

// True if the condition number of H, after scaling its diagonal to ones, is at most about a million at a few positions.
bool well_conditioned(const KinematicTree& robot) {
  const reference::Tables tables = reference_tables(robot);
  Dice dice(1);
  for (int trial = 0; trial < 3; ++trial) {
    Vector<double> q(robot.dof());
    for (int j = 0; j < q.rows(); ++j) q(j) = dice.between(-1, 1);
    Matrix<double> H = reference::joint_space_inertia(tables.robot(), q);
    Vector<double> scale(H.rows());
    for (int i = 0; i < H.rows(); ++i) scale(i) = std::sqrt(H(i, i));
    for (int j = 0; j < H.cols(); ++j) {
      for (int i = 0; i < H.rows(); ++i) H(i, j) /= scale(i) * scale(j);
      H(j, j) -= 1e-6;
    }
    if (!reference::positive_definite(H)) return false;
  }
  return true;
}

void add_odd_parts(KinematicTree& robot, Dice& dice) {
  for (std::size_t i = 1; i < robot.links.size(); ++i) {
    Link& link = robot.links[i];
    if (link.child_joints.empty() || !dice.chance(0.1)) continue;
    const std::optional<Inertia> kept = link.inertia;
    link.inertia.reset();
    if (!well_conditioned(robot)) robot.links[i].inertia = kept;
  }
  for (Link& link : robot.links) {
    if (link.inertia && dice.chance(0.15)) link.inertia->reference = placement(dice);
  }
}

// Makes some joints of some robots helical.
void make_screws(KinematicTree& robot, std::uint64_t seed) {
  Dice dice(seed + 0x2545f4914f6cdd1d);
  if (!dice.chance(0.4)) return;
  const double share = dice.between(0.1, 0.6);
  for (Joint& joint : robot.joints) {
    if (!dice.chance(share)) continue;
    joint.type = JointType::helical;
    joint.pitch = Quantity(dice.sign() * (dice.chance(0.2) ? 1.0 : dice.between(0.001, 0.3)));
  }
}

}  // namespace

KinematicTree random_robot(std::uint64_t seed, const RobotOptions& options) {
  Dice dice(seed);
  KinematicTree robot;
  robot.name = "random_" + std::to_string(seed);
  robot.floating_base = dice.chance(0.4);
  const double share = std::pow(dice.unit(), 4);  // favours small robots: a fifth of the maximum on average
  const int joints = options.min_joints + static_cast<int>(share * (options.max_joints - options.min_joints + 1));
  const double chain_likeness = dice.unit();
  const double revolute = dice.chance(0.5) ? 1.0 : dice.unit();

  robot.links.push_back({"base", {}, -1, {}, {}});
  if (robot.floating_base || dice.chance(0.5)) robot.links[0].inertia = inertia(dice);
  for (int k = 0; k < joints; ++k) {
    const std::string number = std::to_string(k + 1);
    robot.links.push_back({"link" + number, inertia(dice), -1, {}, {}});
    Joint joint;
    joint.name = "j" + number;
    joint.type = dice.chance(revolute) ? JointType::revolute : JointType::prismatic;
    joint.placement = placement(dice);
    connect(robot, parent_of_next(dice, options.shape, chain_likeness, k), k + 1, joint);
  }
  if (options.screws) make_screws(robot, seed);
  // Parallel prismatic joints, or axes that coincide, make H singular or nearly so: spread the joints. Long chains are
  // badly conditioned for any placement of their frames.
  for (int trial = 0; trial < 5 && !well_conditioned(robot); ++trial) {
    for (Joint& joint : robot.joints) {
      for (Quantity& t : joint.placement.translation) t = Quantity(dice.between(-0.5, 0.5));
      if (trial > 0) {
        joint.type = JointType::revolute;
        joint.pitch = Quantity();
      }
    }
  }
  for (int k = dice.below(4); k > 0; --k)
    robot.user_frames.push_back({"frame" + std::to_string(k), dice.below(joints + 1), placement(dice), false, {}});
  if (options.odd_documents) {
    add_odd_parts(robot, dice);
    if (dice.chance(0.3)) robot = shuffled(robot, dice);
  }
  return robot;
}

model::DesiredTransforms random_desired(std::uint64_t seed, const KinematicTree& robot) {
  Dice dice(seed + 0x9e3779b97f4a7c15);
  const std::vector<model::Frame> frames = robot.frames();
  const auto any = [&] { return frames[at(dice.below(static_cast<int>(frames.size())))]; };
  model::DesiredTransforms desired;
  // Three frames form a triangle, with one edge in both directions, so that compositions and inverses can be checked.
  const model::Frame a = any(), b = any(), c = any();
  desired.transforms = {{a, b}, {b, c}, {a, c}, {b, a}, {frames[0], any()}, {any(), any()}};
  desired.jacobians = {{frames[0], a}, {a, b}, {b, a}, {any(), any()}};
  const auto unique = [](std::vector<model::FramePair>& list) {
    std::vector<model::FramePair> kept;
    for (const model::FramePair& pair : list) {
      if (std::find(kept.begin(), kept.end(), pair) == kept.end()) kept.push_back(pair);
    }
    list = kept;
  };
  unique(desired.transforms);
  unique(desired.jacobians);
  return desired;
}

KinematicTree without_leaf(const KinematicTree& robot, int leaf) {
  const int joint = robot.links[at(leaf)].parent_joint;
  // Move the link and its joint to the ends of their lists, then remove them.
  const auto order = [](std::size_t size, int last) {
    std::vector<int> list;
    for (int k = 0; k < static_cast<int>(size); ++k) {
      if (k != last) list.push_back(k);
    }
    list.push_back(last);
    return list;
  };
  KinematicTree result = reordered(robot, order(robot.links.size(), leaf), order(robot.joints.size(), joint));
  const int gone_joint = result.dof() - 1;
  const int gone_link = static_cast<int>(result.links.size()) - 1;
  std::vector<int>& siblings = result.links[at(result.joints.back().parent)].child_joints;
  siblings.erase(std::find(siblings.begin(), siblings.end(), gone_joint));
  std::erase_if(result.user_frames, [&](const UserFrame& frame) { return frame.link == gone_link; });
  result.links.pop_back();
  result.joints.pop_back();
  return result;
}

KinematicTree shrink(KinematicTree robot, const std::function<bool(const KinematicTree&)>& fails) {
  const auto smaller = [&]() -> std::optional<KinematicTree> {
    for (int i = static_cast<int>(robot.links.size()) - 1; i > 0; --i) {
      if (!robot.links[at(i)].child_joints.empty()) continue;
      KinematicTree candidate = without_leaf(robot, i);
      // A massless link must not become a leaf.
      const bool sound = std::all_of(candidate.links.begin() + 1, candidate.links.end(), [](const Link& link) {
        return link.inertia || !link.child_joints.empty();
      });
      if (sound && fails(candidate)) return candidate;
    }
    for (std::size_t k = 0; k < robot.user_frames.size(); ++k) {
      KinematicTree candidate = robot;
      candidate.user_frames.erase(candidate.user_frames.begin() + static_cast<std::ptrdiff_t>(k));
      if (fails(candidate)) return candidate;
    }
    return std::nullopt;
  };
  while (const std::optional<KinematicTree> next = smaller()) robot = *next;
  return robot;
}

namespace {

std::string describe_type(const Joint& joint) {
  switch (joint.type) {
    case JointType::revolute:
      break;
    case JointType::prismatic:
      return "p_joint";
    case JointType::helical:
      return "h_joint of pitch " + model::print(joint.pitch, {});
    case JointType::spherical:
      return "component of s_joint";
  }
  return "r_joint";
}

}  // namespace

std::string describe(const KinematicTree& robot) {
  const auto triple = [&](const std::array<Quantity, 3>& v) {
    std::string text = "(";
    for (const Quantity& x : v) text += (text.size() > 1 ? ", " : "") + model::print(x, robot.parameters);
    return text + ")";
  };
  std::string text = robot.name + (robot.floating_base ? ", floating base\n" : ", fixed base\n");
  for (const Link& link : robot.links) {
    text += "  " + link.name;
    if (link.parent_joint >= 0) {
      const Joint& joint = robot.joints[at(link.parent_joint)];
      text += " on " + robot.links[at(joint.parent)].name + " by " + describe_type(joint) + " " + joint.name + " at " +
              triple(joint.placement.translation) + " " + triple(joint.placement.rotation);
    }
    if (link.inertia) {
      const Inertia& I = *link.inertia;
      text += ", mass " + model::print(I.mass, robot.parameters) + " at " + triple(I.com) + ", inertia " +
              triple({I.ixx, I.iyy, I.izz}) + " " + triple({I.ixy, I.ixz, I.iyz});
      if (I.reference) text += " in frame " + triple(I.reference->translation) + " " + triple(I.reference->rotation);
    }
    text += "\n";
  }
  for (const UserFrame& frame : robot.user_frames)
    text += "  frame " + frame.name + " of " + robot.links[at(frame.link)].name + " at " +
            triple(frame.placement.translation) + " " + triple(frame.placement.rotation) + "\n";
  return text;
}

}  // namespace robcogen::numeric
