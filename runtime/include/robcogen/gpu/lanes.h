// Lanes of a GPU: each lane of a value is in another thread.
//
// Neighbouring threads of a warp hold one state, as many as a function in lanes says. Each computes its limbs; values
// without lanes are the same in all of them. In a value with fewer lanes than there are threads, threads repeat lanes.
//
// Where the text is compiled for the host, lanes exist for tests only: ROBCOGEN_GPU_EMULATES_LANES promises functions
// lane(), exchanged(), wait_for_lanes() and emulate(), by which lanes of the host work together as threads of a warp
// do.
#pragma once

#if defined(__CUDACC__) || defined(__CUDA__) || defined(__HIP__) || defined(ROBCOGEN_GPU_EMULATES_LANES)
#define RC_HAS_LANES 1
#else
#define RC_HAS_LANES 0
#endif

namespace robcogen::gpu {

// Of numbers of any type, as REAL; overloads below are those of lanes.
template <class REAL, class Number>
RC_DEVICE REAL square_root_of(Number x) {
  return square_root(REAL(x));
}
template <class REAL, class First, class Second>
RC_DEVICE REAL quotient_of(First a, Second b) {
  return quotient(REAL(a), REAL(b));
}

#if RC_HAS_LANES
#if !defined(ROBCOGEN_GPU_EMULATES_LANES)
RC_DEVICE int lane() {
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
  return static_cast<int>(threadIdx.x);
#else
  return 0;
#endif
}

// The number of another lane of the kSize neighbours to which this thread belongs.
template <int kSize, class Number>
RC_DEVICE Number exchanged(Number x, int other) {
#if defined(__CUDA_ARCH__)
  return __shfl_sync(0xffffffffU, x, other, kSize);
#elif defined(__HIP_DEVICE_COMPILE__)
  return __shfl(x, other, kSize);
#else
  (void)other;
  return x;
#endif
}

// Returns when all lanes have called it, and sees what they have written.
RC_DEVICE void wait_for_lanes() {
#if defined(__CUDA_ARCH__)
  __syncwarp();
#elif defined(__HIP_DEVICE_COMPILE__)
  __builtin_amdgcn_fence(__ATOMIC_ACQ_REL, "wavefront");
  __builtin_amdgcn_wave_barrier();
#endif
}
#endif

template <class Number, int kSize>
class Lanes {
 public:
  Lanes() = default;
  // The same number in all lanes.
  explicit RC_DEVICE Lanes(Number own) : own_(own) {}
  // A number for each lane.
  template <class... More>
  static RC_DEVICE Lanes of(Number first, More... more) {
    static_assert(sizeof...(More) + 1 == kSize, "a number for each lane");
    const Number all[] = {first, Number(more)...};
    return Lanes(chosen<kSize>(all));
  }

  static RC_DEVICE int this_lane() { return lane() & (kSize - 1); }
  RC_DEVICE Number own() const { return own_; }
  RC_DEVICE Number operator[](int k) const { return exchanged<kSize>(own_, k); }

  friend RC_DEVICE Lanes operator+(Lanes a, Lanes b) { return Lanes(a.own_ + b.own_); }
  friend RC_DEVICE Lanes operator-(Lanes a, Lanes b) { return Lanes(a.own_ - b.own_); }
  friend RC_DEVICE Lanes operator*(Lanes a, Lanes b) { return Lanes(a.own_ * b.own_); }
  friend RC_DEVICE Lanes operator-(Lanes a) { return Lanes(-a.own_); }

 private:
  // One of so many numbers, by the bits of the lane: selections without branches, which share their conditions.
  template <int kCount>
  static RC_DEVICE Number chosen(const Number* all) {
    if constexpr (kCount == 1) {
      return *all;
    } else {
      const Number low = chosen<kCount / 2>(all), high = chosen<kCount / 2>(all + kCount / 2);
      return lane() & (kCount / 2) ? high : low;
    }
  }

  Number own_;
};

template <class REAL, int kSize>
RC_DEVICE Lanes<REAL, kSize> square_root_of(Lanes<REAL, kSize> x) {
  return Lanes<REAL, kSize>(square_root(x.own()));
}
template <class REAL, int kSize>
RC_DEVICE Lanes<REAL, kSize> quotient_of(Lanes<REAL, kSize> a, Lanes<REAL, kSize> b) {
  return Lanes<REAL, kSize>(quotient(a.own(), b.own()));
}
template <class Number, int kSize>
RC_DEVICE void sincos(Lanes<Number, kSize> x, Lanes<Number, kSize>& sine, Lanes<Number, kSize>& cosine) {
  Number s, c;
  sincos(x.own(), s, c);
  sine = Lanes<Number, kSize>(s);
  cosine = Lanes<Number, kSize>(c);
}

// The sum of all lanes, which is the same in all threads to the last bit.
template <class Number, int kSize>
RC_DEVICE Number sum_lanes(Lanes<Number, kSize> x) {
  Number sum = x.own();
  for (int apart = kSize / 2; apart > 0; apart /= 2)
    sum = sum + exchanged<kSize>(sum, Lanes<Number, kSize>::this_lane() ^ apart);
  return sum;
}
template <class Number>
struct TwoSums {
  Number first, second;
};
template <class Number, int kSize>
RC_DEVICE TwoSums<Number> sum_lanes(Lanes<Number, kSize> a, Lanes<Number, kSize> b) {
  return {sum_lanes(a), sum_lanes(b)};
}

// Neighbouring elements of each lane, whose first ones are kStride apart.
template <class Value, int kCount>
struct Block {
  Value values[kCount];
  RC_DEVICE const Value& operator[](int k) const { return values[k]; }
};
template <class REAL, int kSize, int kCount, int kStride, class Array>
RC_DEVICE Block<Lanes<REAL, kSize>, kCount> load_lanes(Array from) {
  Block<Lanes<REAL, kSize>, kCount> block;
  const int begin = Lanes<REAL, kSize>::this_lane() * kStride;
  for (int k = 0; k < kCount; ++k) block.values[k] = Lanes<REAL, kSize>(from[begin + k]);
  return block;
}
template <int kStride, class Array, class REAL, int kSize, class... More>
RC_DEVICE void store_lanes(Array to, Lanes<REAL, kSize> first, More... more) {
  const Lanes<REAL, kSize> all[] = {first, more...};
  const int begin = Lanes<REAL, kSize>::this_lane() * kStride;
  for (int k = 0; k < static_cast<int>(sizeof...(More)) + 1; ++k) to[begin + k] = all[k].own();
}
// Some of these elements are written once more, perhaps by another lane.
template <int kCount, class Array, class Number>
RC_DEVICE void fill(Array to, Number x) {
  for (int k = 0; k < kCount; ++k) to[k] = x;
  wait_for_lanes();
}
#endif

}  // namespace robcogen::gpu
