#include "algorithm/spatial/motion_force.h"

namespace robcogen::algorithm {

Motion& operator+=(Motion& a, const Motion& b) {
  a.angular += b.angular;
  a.linear += b.linear;
  return a;
}

Motion operator*(const Expression& k, const Motion& a) {
  return {k * a.angular, k * a.linear};
}

Force& operator+=(Force& a, const Force& b) {
  a.moment += b.moment;
  a.linear += b.linear;
  return a;
}

Force operator+(const Force& a, const Force& b) {
  return {a.moment + b.moment, a.linear + b.linear};
}

Force& operator-=(Force& a, const Force& b) {
  a.moment -= b.moment;
  a.linear -= b.linear;
  return a;
}

Force operator*(const Expression& k, const Force& a) {
  return {k * a.moment, k * a.linear};
}

Expression dot(const Force& a, const Motion& b) {
  const Expression angular = dot(a.moment, b.angular);
  return angular + dot(a.linear, b.linear);
}

Force cross(const Motion& S, const Force& F) {
  const Vector3 moment = cross(S.angular, F.moment);
  return {moment + cross(S.linear, F.linear), cross(S.angular, F.linear)};
}

}  // namespace robcogen::algorithm
