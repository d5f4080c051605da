// What generated headers use of the obstacles of VAMP.
#pragma once

#include <vector>

#include <vamp/vector.hh>

namespace vamp::collision {

template <class Data>
struct Sphere {
  Data x, y, z, r;
};

template <class Data>
struct Environment {
  std::vector<Sphere<Data>> spheres, attached;
};

template <class Data, class Pose>
void set_attachment_pose(const Environment<Data>&, const Pose&) {}

}  // namespace vamp::collision
