// Runs a function of the library over the arrays of a call.
#pragma once

#include <algorithm>
#include <memory>
#include <type_traits>
#include <vector>

#include "robcogen/python/results.h"

namespace robcogen::python {

inline constexpr std::ptrdiff_t kBlock = 64;  // states whose arrays are copied at a time: they stay in the cache

// Memory for copies of numbers, on the stack while they are few.
template <class Scalar>
class Scratch {
 public:
  Scalar* take(std::ptrdiff_t count) {
    if (used_ + count <= kFew) {
      used_ += count;
      return few_ + used_ - count;
    }
    many_.emplace_back(new Scalar[static_cast<std::size_t>(count)]);
    return many_.back().get();
  }

 private:
  static constexpr std::ptrdiff_t kFew = 512;
  Scalar few_[kFew];
  std::ptrdiff_t used_ = 0;
  std::vector<std::unique_ptr<Scalar[]>> many_;
};

template <class Scalar>
const Scalar* parameters_in(const Entry& entry, const Inputs& inputs) {
  if (!inputs.caches) return nullptr;
  const ParameterTable& table = entry.module->tables->parameters;
  if constexpr (sizeof(Scalar) == 4) {
    return table.in_float(inputs.caches);
  } else {
    return table.in_double(inputs.caches);
  }
}

inline void run(const Variant& variant, const double* const* in, double* const* out) {
  variant.in_double(in, out);
}
inline void run(const Variant& variant, const float* const* in, float* const* out) {
  variant.in_float(in, out);
}

template <class Scalar>
Batch<Scalar> batch_of(const Variant& variant) {
  if constexpr (sizeof(Scalar) == 4) {
    return variant.batch_in_float;
  } else {
    return variant.batch_in_double;
  }
}

// Computes state by state. Arrays that the library cannot read or write in place are copied.
template <class Scalar>
void compute_each(const Entry& entry, const Inputs& inputs, Results& results) {
  const Function& function = *entry.function;
  const Scalar* const parameters = parameters_in<Scalar>(entry, inputs);
  Scratch<Scalar> scratch;
  const Scalar* in[kMaxArrays];
  Scalar *copies[kMaxArrays] = {}, *out[kMaxArrays], *written[kMaxArrays] = {};
  for (std::ptrdiff_t state = 0; state < inputs.states; ++state) {
    for (std::size_t k = 0; k < inputs.count(); ++k) {
      if (function.arguments[k].is_parameters) {
        in[k] = parameters;
        continue;
      }
      const View& view = inputs.views[k];
      in[k] = view.template in_place<Scalar>(state);
      if (in[k]) continue;
      if (!copies[k]) copies[k] = scratch.take(size(function.arguments[k]));
      view.gather(state, copies[k]);
      in[k] = copies[k];
    }
    for (std::size_t r = 0; r < function.results.size(); ++r) {
      out[r] = results.views[r].template in_place<Scalar>(state);
      if (out[r]) continue;
      if (!written[r]) written[r] = scratch.take(size(function.results[r]));
      out[r] = written[r];
    }
    run(*inputs.variant, in, out);
    for (std::size_t r = 0; r < function.results.size(); ++r)
      if (out[r] == written[r]) results.views[r].scatter(state, out[r]);
  }
}

// Whether functions over many states can read or write the array in place, which `states` then describes.
template <class Number>
bool is_strided(const View& view, batch::Strided<Number>& states) {
  states.data = view.template first<Number>();
  return view.template strides<std::remove_const_t<Number>>(states.element, states.state);
}

// Computes all states by a function over many states. Arrays that it cannot read or write in place are copied, one
// block of states at a time.
template <class Scalar>
void compute_together(const Entry& entry, Batch<Scalar> batch, const Inputs& inputs, Results& results) {
  const Function& function = *entry.function;
  batch::Strided<const Scalar> in[kMaxArrays] = {};
  batch::Strided<Scalar> out[kMaxArrays] = {};
  Scalar *copies[kMaxArrays] = {}, *written[kMaxArrays] = {};
  Scratch<Scalar> scratch;
  std::ptrdiff_t block = inputs.states;
  for (std::size_t k = 0; k < inputs.count(); ++k) {
    const Argument& a = function.arguments[k];
    const View& view = inputs.views[k];
    if (a.is_parameters || is_strided(view, in[k])) continue;
    const bool is_same = !view.is_batch() || view.states() == 1;
    if (!is_same) block = std::min(block, kBlock);
    Scalar* const copy = scratch.take(size(a) * (is_same ? 1 : kBlock));
    in[k] = {copy, 1, is_same ? 0 : size(a)};
    if (is_same)
      view.gather(0, copy);
    else
      copies[k] = copy;
  }
  for (std::size_t r = 0; r < function.results.size(); ++r) {
    if (is_strided(results.views[r], out[r])) continue;
    block = std::min(block, kBlock);
    written[r] = scratch.take(size(function.results[r]) * kBlock);
    out[r] = {written[r], 1, size(function.results[r])};
  }
  for (std::ptrdiff_t first = 0; first < inputs.states; first += block) {
    const std::ptrdiff_t count = std::min(block, inputs.states - first);
    for (std::size_t k = 0; k < inputs.count(); ++k)
      if (copies[k]) inputs.views[k].gather(first, count, copies[k]);
    batch(count, parameters_in<Scalar>(entry, inputs), in, out);
    for (std::size_t r = 0; r < function.results.size(); ++r)
      if (written[r]) results.views[r].scatter(first, count, written[r]);
    for (std::size_t k = 0; k < inputs.count(); ++k)
      if (!copies[k]) in[k].data += block * in[k].state;
    for (std::size_t r = 0; r < function.results.size(); ++r)
      if (!written[r]) out[r].data += block * out[r].state;
  }
}

template <class Scalar>
void compute_in(const Entry& entry, const Inputs& inputs, Results& results) {
  const Batch<Scalar> batch = inputs.is_batch && inputs.states > 1 ? batch_of<Scalar>(*inputs.variant) : nullptr;
  if (batch)
    compute_together(entry, batch, inputs, results);
  else
    compute_each<Scalar>(entry, inputs, results);
}

// Computes in the scalar type of the arrays, or in double if the library has nothing else.
inline void compute(const Entry& entry, const Inputs& inputs, Results& results) {
  if (inputs.is_float && inputs.variant->in_float)
    compute_in<float>(entry, inputs, results);
  else
    compute_in<double>(entry, inputs, results);
}

}  // namespace robcogen::python
