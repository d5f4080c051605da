// The numerical geometry of a loop: where its joints are, how far its ends are apart, and how they move.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

using Numbers3 = std::array<double, 3>;

Numbers3 cross(const Numbers3& a, const Numbers3& b);
double dot(const Numbers3& a, const Numbers3& b);
double norm(const Numbers3& a);
Numbers3 operator-(const Numbers3& a, const Numbers3& b);

// The screw of a joint, in coordinates of the last link that carries both ends.
struct LoopScrew {
  int joint = -1;
  int end = 0;
  bool turns = true;
  double slide = 0.0;  // m per unit of the joint's position
  Numbers3 axis{};     // unit
  Numbers3 origin{};   // on the axis
};

struct LoopPosture {
  std::vector<LoopScrew> screws;                  // of the joints of the first end, then of the second end
  std::array<Numbers3, 2> points{};               // origins of the frames at the ends
  std::array<std::array<Numbers3, 3>, 2> axes{};  // their x, y and z axes
};

// Returns the posture of the loop at positions q (rad, m), by joint.
LoopPosture posture(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& q,
    const std::vector<double>& parameters);

// The closing error between the first end and the second, in rows, and its derivatives, one column per screw. For a
// planar closure, the error along the two axes of the plane; for a distance, half the difference of the squared
// distances, divided by the length.
struct LoopError {
  std::vector<double> rows;
  std::vector<std::vector<double>> columns;
};
LoopError error_of(const Closure& closure, const LoopPosture& at, double length);

// Moves the dependent joints from their present positions until the loop closes. Returns the remaining gap (m).
double close(
    const KinematicTree& tree,
    const Closure& closure,
    std::vector<double>& q,
    const std::vector<double>& parameters);

// By dependent joint and screw: the displacement of the joint per unit motion of the screw; zero for screws of
// dependent joints.
std::vector<std::vector<double>> rate_factors(const Closure& closure, const LoopPosture& at, const LoopError& error);

// How well the dependent joints are determined: 1 if their directions are perpendicular to one another, 0 if the loop
// is stretched.
double conditioning(const Closure& closure, const LoopPosture& at, const LoopError& error);

// The sign of the square root with which the formulas find this posture, in which the loop is closed. For two joints
// that turn, it tells on which side the vertex of the triangle is; for a joint that slides, where along its axis the
// vertex is.
double branch_of(const KinematicTree& tree, const Closure& closure, const LoopPosture& at);

}  // namespace robcogen::model
