// The arguments of a call as arrays, and the overload that takes them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

#include "robcogen/python/arguments.h"

namespace robcogen::python {

inline constexpr double kStandardGravity[3] = {0, 0, -9.81};

// Views by index. Only those that are used are constructed.
class Views {
 public:
  Views() = default;
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;
  ~Views() {
    for (std::size_t k = 0; k < count_; ++k) (*this)[k].~View();
  }
  // Constructs the views up to this index, and returns the last.
  View& add(std::size_t k) {
    for (; count_ <= k; ++count_) new (memory_ + count_ * sizeof(View)) View;
    return (*this)[k];
  }
  View& operator[](std::size_t k) { return *std::launder(reinterpret_cast<View*>(memory_ + k * sizeof(View))); }
  const View& operator[](std::size_t k) const {
    return *std::launder(reinterpret_cast<const View*>(memory_ + k * sizeof(View)));
  }

 private:
  std::size_t count_ = 0;
  alignas(View) unsigned char memory_[kMaxArrays * sizeof(View)];
};

struct Inputs {
  const Variant* variant = nullptr;
  const void* caches = nullptr;  // of parameters
  Views views;
  bool is_float = false;  // all arrays are of float
  bool is_batch = false;
  std::ptrdiff_t states = 1;

  std::size_t count() const { return static_cast<std::size_t>(variant->inputs); }
};

// Returns the first overload that takes all given arguments, or nullptr if there is none.
inline const Variant* variant_for(const Function& function, PyObject* const* given) {
  int last = function.required;
  for (std::size_t k = 0; k < function.arguments.size(); ++k)
    if (given[k]) last = std::max(last, static_cast<int>(k) + 1);
  for (const Variant& v : function.variants)
    if (v.inputs >= last) return &v;
  return nullptr;
}

// Sets an argument that is missing before others that are given: only gravity and external wrenches have a default.
inline bool set_default(const Entry& entry, const Argument& a, View& view) {
  const bool is_gravity = std::strcmp(a.name, "gravity") == 0;
  if (!is_gravity && std::strcmp(a.name, "external") != 0)
    return refuse(entry, std::string(a.name) + " is missing", PyExc_TypeError);
  const std::vector<double> zeros(static_cast<std::size_t>(size(a)), 0.0);
  view.set_constant(is_gravity ? kStandardGravity : zeros.data(), a);
  return true;
}

// A quaternion of any other length would make results wrong without a word. The tolerance admits numbers that were
// printed with four digits.
inline constexpr double kUnitTolerance = 1e-4;

// What is wrong with the quaternions of the states; empty if all have unit length. NaN affects only its own state.
inline std::string wrong_quaternion(const Argument& a, const View& view) {
  if (a.quaternions.empty()) return "";
  std::vector<double> values(static_cast<std::size_t>(size(a)));
  for (std::ptrdiff_t state = 0; state < view.states(); ++state) {
    view.gather(state, values.data());
    for (const int first : a.quaternions) {
      const double* const q = values.data() + first;
      const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      if (!(std::abs(norm - 1) > kUnitTolerance)) continue;
      char text[32];
      std::snprintf(text, sizeof text, "%.6g", norm);
      const std::string of = std::string(a.name) + "[" + std::to_string(first) + ":" + std::to_string(first + 4) + "]";
      const std::string where = view.is_batch() ? " in state " + std::to_string(state) : "";
      const bool is_pose = std::strcmp(a.name, "base_pose") == 0;
      const char* const order = std::strcmp(a.name, "orientation") == 0 ? "x, y, z, w" : "w, x, y, z";
      std::string message = of + " must be a unit quaternion " + order;
      if (is_pose) message += ", followed by the position";
      message.append(": its norm").append(where).append(" is ").append(text);
      if (is_pose) message += "; base_pose_from_mujoco and base_pose_from_ros take other orders";
      return message;
    }
  }
  return "";
}

inline bool check_quaternions(const Entry& entry, const Argument& a, const View& view) {
  const std::string wrong = wrong_quaternion(a, view);
  return wrong.empty() || refuse(entry, wrong);
}

// Returns whether it succeeded; otherwise an exception is set.
inline bool read_inputs(const Entry& entry, PyObject* const* given, Inputs& inputs) {
  const Function& function = *entry.function;
  inputs.variant = variant_for(function, given);
  if (!inputs.variant) return false;
  bool has_float = false, has_double = false;
  const char* first = nullptr;
  for (std::size_t k = 0; k < inputs.count(); ++k) {
    const Argument& a = function.arguments[k];
    View& view = inputs.views.add(k);
    if (a.is_parameters) {
      inputs.caches = reinterpret_cast<ParametersObject*>(given[k])->caches;
      continue;
    }
    if (!given[k]) {
      if (!set_default(entry, a, view)) return false;
      continue;
    }
    if (!view.read(given[k], a, function.name) || !check_quaternions(entry, a, view)) return false;
    (view.is_float() ? has_float : has_double) |= view.is_array();
    if (!view.is_batch()) continue;
    inputs.is_batch = true;
    if (view.states() == 1) continue;
    if (first && view.states() != inputs.states)
      return refuse(
          entry, std::string(first) + " has " + std::to_string(inputs.states) + " states, " + a.name + " has " +
                     std::to_string(view.states()));
    first = a.name;
    inputs.states = view.states();
  }
  inputs.is_float = has_float && !has_double;
  for (std::size_t k = 0; k < inputs.count(); ++k) inputs.views[k].broadcast();
  return true;
}

}  // namespace robcogen::python
