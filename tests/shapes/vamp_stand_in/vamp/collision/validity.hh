// What generated headers call of the checks of VAMP: whether a sphere touches an obstacle in any lane.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <vamp/collision/environment.hh>

namespace vamp {

template <class Data>
bool any_touches(const std::vector<collision::Sphere<Data>>& list, Data x, Data y, Data z, Data r) {
  for (const auto& o : list)
    for (std::size_t k = 0; k < FloatVectorWidth; ++k)
      if (std::hypot(x.data[0][k] - o.x.data[0][k], y.data[0][k] - o.y.data[0][k], z.data[0][k] - o.z.data[0][k]) <
          r.data[0][k] + o.r.data[0][k])
        return true;
  return false;
}

template <class Data, class X, class Y, class Z, class R>
bool sphere_environment_in_collision(const collision::Environment<Data>& e, X x, Y y, Z z, R r) {
  return any_touches<Data>(e.spheres, x, y, z, r);
}

template <class Data, class X, class Y, class Z, class R>
std::vector<std::string> sphere_environment_get_collisions(const collision::Environment<Data>& e, X x, Y y, Z z, R r) {
  if (any_touches<Data>(e.spheres, x, y, z, r)) return {"obstacle"};
  return {};
}

template <class Data>
bool attachment_environment_collision(const collision::Environment<Data>&) {
  return false;
}

template <class Data, class X, class Y, class Z, class R>
bool attachment_sphere_collision(const collision::Environment<Data>& e, X x, Y y, Z z, R r) {
  return any_touches<Data>(e.attached, x, y, z, r);
}

}  // namespace vamp
