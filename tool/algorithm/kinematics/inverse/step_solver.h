// The equation of a step, solved with expressions.
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

struct SolvedJoint {
  JointValue value;
  Expression root;  // that the sign multiplies, with the sign; zero where both roots meet
};

class StepSolver {
 public:
  // `references`: positions by joint of the chain, for joints that have no effect. `lengths_agree`, by joint: whether
  // the vectors of a vector step have equal lengths across the axis, whatever the target.
  StepSolver(
      Graph& graph,
      const SerialChain& chain,
      Target target,
      std::vector<Expression> references,
      std::vector<bool> lengths_agree = {});

  // The joint of a step, with this sign (1 or -1) of the root if it has two. nullopt if the step cannot find it.
  std::optional<SolvedJoint> solve(const Step& step, const JointValues& values, const Expression& sign);

  // The root of a step with two, with its sign, at known positions of all joints.
  Expression root(const Step& step, const JointValues& values) const;

  // E_1 … E_n x: a point, or a direction, of the last link in the first frame.
  Vector3 moved(const Vector3& x, bool is_direction, const JointValues& values) const {
    return moved(x, is_direction, values, 0, chain_.joints);
  }
  // The same past the joints from begin to before end.
  Vector3 moved(const Vector3& x, bool is_direction, const JointValues& values, int begin, int end) const {
    return along({x, is_direction}, begin, end, values, false).v;
  }
  // Where the target puts x of the last link.
  Vector3 of_target(const Vector3& x, bool is_direction) const { return by_target({x, is_direction}, false).v; }

  // Of the places of a feature that the joints before it and those behind it tell, in coordinates of the link before
  // the joint `cut`, which is none of its own.
  Vector3 difference(const Feature& feature, int cut, const JointValues& values) const;

  // By vector step that was solved: the squared lengths of its vectors across the axis.
  struct Lengths {
    int joint;
    Expression a, b;
  };
  const std::vector<Lengths>& lengths() const { return lengths_; }

 private:
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
  // A discriminant whose terms are small where axes align: lengths - k^2.
  struct Discriminant {
    Expression lengths, k;
  };

  Graph& graph_;
  const SerialChain& chain_;
  Target target_;
  std::vector<Expression> references_;
  std::vector<bool> lengths_agree_;
  std::vector<Basis> bases_;
  Expression tiny_;  // 2^-59 to 2^-58
  std::vector<Lengths> lengths_;

  Vector3 constant(const Numbers3& v) const;
  Basis basis_of(const Numbers3& h) const;
  Item item(const Feature& f) const;
  Vector3 axis_point(int joint) const { return constant(chain_.axis(joint).point); }

  Item past(int joint, const Item& x, const JointValues& values, bool inverse) const;
  Item along(Item x, int begin, int end, const JointValues& values, bool inverse) const;
  Item by_target(const Item& x, bool inverse) const;
  // A feature b in coordinates of the link before a, through the target; and from there back.
  Item around(const Item& b, const Step& step, const JointValues& values) const;
  // The items of both features, and of a plane's normal, next to the joint. `direct`: positions of all joints are
  // known.
  Sides sides(const Step& step, const JointValues& values, bool direct) const;
  Item next_to_joint(const Item& x, bool is_a, const Step& step, const JointValues& values, bool direct) const;

  std::optional<SolvedJoint> two_roots(
      int joint,
      const Vector3& left,
      const Vector3& right,
      const Expression& value,
      const Expression& sign,
      const std::optional<Discriminant>& discriminant);
  std::optional<SolvedJoint> turned(int joint, const Vector3& from, const Vector3& to, bool is_backward);
  std::optional<SolvedJoint> solved(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> by_vector(const Step& step, const JointValues& values);
  std::optional<SolvedJoint> by_angle(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> by_distance(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> by_height(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> at_meeting_axes(
      const Step& step,
      const JointValues& values,
      const Expression& sign,
      const Numbers3& meeting);
  Discriminant of_aligned(
      int joint,
      const Vector3& a,
      const Vector3& b,
      const Vector3& a_far,
      const Vector3& b_far,
      const Expression& value) const;
};

}  // namespace robcogen::algorithm::inversion
