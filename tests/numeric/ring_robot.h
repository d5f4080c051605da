// A mechanism with one loop, as documents that differ in where they cut the loop.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dice.h"

namespace robcogen::numeric {

// A closed chain of links in a plane: pivot k joins links k and k + 1, and the last pivot joins the last link and link
// 0, which is the base. Link 2 carries an arm on a skew joint, `extra`. At q = 0 the axes of all links are parallel to
// those of the base.
class Ring {
 public:
  enum class Shape { any, parallelogram, flat };

  // `size` is the number of pivots, four or five; parallelograms have four.
  Ring(int size, std::uint64_t seed, Shape shape = Shape::any);

  int size() const { return size_; }
  static std::string name(int pivot);

  // The tree without pivot `cut`, and a loop of this type that closes it.
  std::string document(int cut, const std::vector<int>& leaders, const std::string& type) const;

  // All choices of pivots that can lead together with `extra`.
  std::vector<std::vector<int>> choices_of_leaders(int cut) const;

  // 1 if the position of the pivot is that of the tree's joint, -1 if it is the opposite: links up to the cut hang on
  // their first pivots, links behind it on their second ones.
  static double sense(int pivot, int cut) { return pivot < cut ? 1.0 : -1.0; }

 private:
  struct Point {
    double x, y;
  };

  int size_;
  Dice dice_;
  std::vector<Point> pivots_;
  std::vector<double> heights_;  // one per link
  std::vector<std::string> bodies_;
  Point arm_ = {};
  std::string turn_of_arm_;

  double noise();
  std::string body();
  Point origin(int link, int cut) const;
  std::string place(int link, int cut, const Point& p, double height) const;
  std::string children(int link, int cut) const;
  std::string frames(int link, int cut) const;
  std::string joint(int pivot, int cut) const;
};

}  // namespace robcogen::numeric
