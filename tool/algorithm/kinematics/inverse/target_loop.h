// The loop of a chain and its target: features seen from its links, moved along the chain or through the target.
#pragma once

#include <optional>
#include <vector>

#include "algorithm/kinematics/inverse/steps.h"
#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm::inversion {

// Sine and cosine of a joint that turns; the position of one that slides, and one.
struct JointValue {
  Expression sine, cosine;
};
using JointValues = std::vector<std::optional<JointValue>>;  // by joint of the chain; empty: not known

// The pose of the last frame in the first one.
struct Target {
  Matrix3 rotation;
  Vector3 position;
};

class TargetLoop {
 public:
  TargetLoop(Graph& graph, const SerialChain& chain, Target target);

  // A vector that moves with links: a point, or a direction.
  struct Item {
    Vector3 v;
    bool is_direction = false;
  };
  // Both sides of joint m, which turns what is on the right: left . R right = D.
  struct Sides {
    Item a, b;  // the features next to the joint
    bool is_a_left = true;
    Item normal;  // of a plane, next to the joint
  };
  struct Basis {
    Vector3 u, w, h;  // u x w = h
  };

  const Target& target() const { return target_; }

  Vector3 constant(const Numbers3& v) const;
  // Two unit vectors across h, with few elements other than zero; those across the axis of a joint.
  Basis basis_of(const Numbers3& h) const;
  const Basis& basis(int joint) const { return bases_[at(joint)]; }
  Vector3 axis_point(int joint) const { return constant(chain_.axis(joint).point); }
  Item item(const Feature& f) const;

  // E_begin … E_(end - 1) x, or the inverse of this product times x.
  Item along(Item x, int begin, int end, const JointValues& values, bool inverse) const;
  // The motion of the last link, X M^-1, or its inverse.
  Item by_target(const Item& x, bool inverse) const;
  // A feature b in coordinates of the link before a, through the target; and from there back.
  Item around(const Item& b, const Step& step, const JointValues& values) const;
  // A feature of a step next to its joint: a, or b. `direct`: positions of all joints are known.
  Item next_to_joint(const Item& x, bool is_a, const Step& step, const JointValues& values, bool direct) const;
  // The items of both features, and of a plane's normal, next to the joint.
  Sides sides(const Step& step, const JointValues& values, bool direct) const;

  // A point, or a direction, past the joints from begin to before end.
  Vector3 moved(const Vector3& x, bool is_direction, const JointValues& values, int begin, int end) const {
    return along({x, is_direction}, begin, end, values, false).v;
  }
  // Where the target puts x of the last link.
  Vector3 of_target(const Vector3& x, bool is_direction) const { return by_target({x, is_direction}, false).v; }
  // Of the places of a feature that the joints before it and those behind it tell, in coordinates of the link before
  // the joint `cut`, which is none of its own.
  Vector3 difference(const Feature& feature, int cut, const JointValues& values) const;

 private:
  Graph& graph_;
  const SerialChain& chain_;
  Target target_;
  std::vector<Basis> bases_;

  Item past(int joint, const Item& x, const JointValues& values, bool inverse) const;
};

}  // namespace robcogen::algorithm::inversion
