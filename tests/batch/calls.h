// A function of a library, over one state and over many states.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "robcogen/batch.h"

namespace robcogen::batch_test {

struct ElementLayout {
  template <class Value, class Number>
  static auto of(Number* data, std::ptrdiff_t stride) {
    return batch::by_element<Value>(data, stride);
  }
};

struct StateLayout {
  template <class Value, class Number>
  static auto of(Number* data, std::ptrdiff_t stride) {
    return batch::by_state<Value>(data, stride);
  }
};

// Arrays of n states and their strides.
template <class Scalar>
struct Arguments {
  template <class Value, class Layout>
  auto in(Layout, std::size_t i) const {
    return Layout::template of<Value>(inputs[i], input_strides[i]);
  }
  template <class Value, class Layout>
  auto out(Layout, std::size_t i) const {
    return Layout::template of<Value>(outputs[i], output_strides[i]);
  }

  std::ptrdiff_t n = 0;
  std::vector<const Scalar*> inputs;
  std::vector<Scalar*> outputs;
  std::vector<std::ptrdiff_t> input_strides, output_strides;
  batch::Level level = batch::Level::baseline;
};

template <class Scalar>
struct Call {
  // A negative size stands for gravity: the function over many states has no such argument and takes standard gravity.
  template <class Batch>
  Call(
      std::string call_name,
      const std::vector<int>& inputs,
      const std::vector<int>& outputs,
      void (*one)(const Scalar* const*, Scalar* const*),
      Batch batch,
      int lower = 0)
      : name(std::move(call_name)), output_sizes(outputs), lower_rows(lower), single(one) {
    for (const int size : inputs) {
      input_sizes.push_back(std::abs(size));
      is_standard_gravity.push_back(size < 0);
    }
    by_element = [batch](const Arguments<Scalar>& a) { batch(ElementLayout(), a); };
    by_state = [batch](const Arguments<Scalar>& a) { batch(StateLayout(), a); };
  }

  std::string name;
  std::vector<int> input_sizes, output_sizes;
  int lower_rows;  // rows of a matrix of which only the lower triangle is computed; 0 for others
  std::vector<bool> is_standard_gravity;
  std::function<void(const Scalar* const* in, Scalar* const* out)> single;
  std::function<void(const Arguments<Scalar>&)> by_element, by_state;
};

// All functions of a library.
template <class Scalar>
std::vector<Call<Scalar>> calls();

}  // namespace robcogen::batch_test
