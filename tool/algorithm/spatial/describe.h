// Describes values (symbolic::Graph::describe): scalars, and elements of vectors and matrices with their axes after the
// name. `_P` after a name: about the origin of the parent and in its axes.
#pragma once

#include <string>

#include "algorithm/spatial/motion_force.h"

namespace robcogen::algorithm {

// Whether the graph keeps names: text for one that does not would cost more than the rest of a trace.
inline bool keeps_names(const Expression& e) {
  return e.graph() && e.graph()->keeps_names();
}
inline bool keeps_names(const Vector3& v) {
  return keeps_names(v[0]) || keeps_names(v[1]) || keeps_names(v[2]);
}

inline void describe(const Expression& e, const std::string& name) {
  if (e.graph()) e.graph()->describe(e, name);
}

inline void describe(const Vector3& v, const std::string& name, const std::string& suffix = "") {
  if (!keeps_names(v)) return;
  for (std::size_t i = 0; i < 3; ++i) describe(v[i], name + "xyz"[i] + suffix);
}

inline void describe(const Matrix3& m, const std::string& name, const std::string& suffix = "") {
  if (!keeps_names(m[0]) && !keeps_names(m[1]) && !keeps_names(m[2])) return;
  for (std::size_t i = 0; i < 3; ++i) describe(m[i], name + "xyz"[i], suffix);
}

// `<name>_nx`, …, `<name>_fx`, ….
inline void describe(const Force& f, const std::string& name, const std::string& suffix = "") {
  if (!keeps_names(f.moment) && !keeps_names(f.linear)) return;
  describe(f.moment, name + "_n", suffix);
  describe(f.linear, name + "_f", suffix);
}

// `<name>_wx`, …, `<name>_vx`, ….
inline void describe(const Motion& v, const std::string& name, const std::string& suffix = "") {
  if (!keeps_names(v.angular) && !keeps_names(v.linear)) return;
  describe(v.angular, name + "_w", suffix);
  describe(v.linear, name + "_v", suffix);
}

}  // namespace robcogen::algorithm
