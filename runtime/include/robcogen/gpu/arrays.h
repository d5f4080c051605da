// Arrays of functions for GPUs: those of one state, which functions take, and those of all states, which kernels take.
#pragma once

namespace robcogen::gpu {

// Kernels never write what they read, so that a load may take the path for constant data.
template <class Number>
RC_DEVICE Number loaded(const Number* from) {
#if defined(__CUDA_ARCH__) && !defined(ROBCOGEN_GPU_STUB)
  return __ldg(from);
#else
  return *from;
#endif
}

// Element k is at data[k * stride].
template <class Number>
struct Strided {
  Number* data;
  int stride;
  RC_DEVICE Number& operator[](int k) const { return data[k * stride]; }
  RC_DEVICE Strided operator+(int k) const { return {data + k * stride, stride}; }
};
template <class Number>
struct Strided<const Number> {
  const Number* data;
  int stride;
  RC_DEVICE Number operator[](int k) const { return loaded(data + k * stride); }
  RC_DEVICE Strided operator+(int k) const { return {data + k * stride, stride}; }
};

// The same with a stride that the compiler knows, so that the places of elements are constants in instructions.
template <class Number, int kStride>
struct Spaced {
  Number* data;
  RC_DEVICE Number& operator[](int k) const { return data[k * kStride]; }
  RC_DEVICE Spaced operator+(int k) const { return {data + k * kStride}; }
};
template <class Number, int kStride>
struct Spaced<const Number, kStride> {
  const Number* data;
  RC_DEVICE Number operator[](int k) const { return loaded(data + k * kStride); }
  RC_DEVICE Spaced operator+(int k) const { return {data + k * kStride}; }
};

// States in a tile: the first element of each, then the second one of each, …
constexpr int kTile = 32;

// Arrays of all states: in tiles, or with strides that are chosen when the program runs.
template <class Number>
struct Tiles {
  Number* data;
  template <int kSize>
  RC_DEVICE Spaced<Number, kTile> state(int i) const {
    return {data + i / kTile * (kTile * kSize) + i % kTile};
  }
};
template <class Number>
struct Strides {
  Number* data;
  robcogen_gpu_strides strides;
  template <int kSize>
  RC_DEVICE Strided<Number> state(int i) const {
    return {data + (i >> strides.shift) * strides.outer + (i & ((1 << strides.shift) - 1)), strides.element};
  }
};

// The lower triangle of a symmetric matrix in another array of one state: what is written above the diagonal is
// dropped.
template <class Elements, int kRows>
struct LowerTriangle {
  Elements elements;

  struct Element {
    const Elements& elements;
    int place;
    template <class Number>
    RC_DEVICE Number operator=(Number value) const {
      if (place % kRows >= place / kRows) elements[place] = value;
      return value;
    }
  };
  RC_DEVICE Element operator[](int k) const { return {elements, k}; }
};
template <class Number, int kRows>
struct LowerTiles {
  Number* data;
  template <int kSize>
  RC_DEVICE LowerTriangle<Spaced<Number, kTile>, kRows> state(int i) const {
    return {Tiles<Number>{data}.template state<kSize>(i)};
  }
};

}  // namespace robcogen::gpu
