// The geometry of a loop in numbers: where its joints are, how its ends miss one another, and how they move.
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

// In the last link that carries both ends.
struct LoopScrew {
  int joint = -1;
  int end = 0;
  bool turns = true;
  double slide = 0.0;  // m a unit of its position
  Numbers3 axis{};     // unit
  Numbers3 origin{};   // on the axis
};

struct LoopPosture {
  std::vector<LoopScrew> screws;                  // of the joints of the first end, then of the second
  std::array<Numbers3, 2> points{};               // origins of the ends' frames
  std::array<std::array<Numbers3, 3>, 2> axes{};  // their x, y and z axes
};

// At these positions, by joint.
LoopPosture posture(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& q,
    const std::vector<double>& parameters);

// How the first end misses the second, in rows, and their derivatives: a column for each screw. Of a closure in a
// plane: along its two axes. Of a distance: half the difference of the squares, by the length.
struct LoopError {
  std::vector<double> rows;
  std::vector<std::vector<double>> columns;
};
LoopError error_of(const Closure& closure, const LoopPosture& at, double length);

// Moves the dependent joints until the loop closes, from where they are. Returns how far it remains from closed, in m.
double close(
    const KinematicTree& tree,
    const Closure& closure,
    std::vector<double>& q,
    const std::vector<double>& parameters);

// By dependent joint and screw: what it moves by unit motion of the screw; zero for screws of dependent joints.
std::vector<std::vector<double>> rate_factors(const Closure& closure, const LoopPosture& at, const LoopError& error);

// How well the dependent joints are determined: one where their directions are normal to one another, zero where the
// loop is stretched.
double conditioning(const Closure& closure, const LoopPosture& at, const LoopError& error);

// The sign of the square root with which formulas find this posture, in which the loop is closed: of two joints that
// turn, the side of the triangle's vertex; of a joint that slides, where the vertex is along it.
double branch_of(const KinematicTree& tree, const Closure& closure, const LoopPosture& at);

}  // namespace robcogen::model
