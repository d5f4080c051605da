// Several numbers as one value: each operation applies to every lane.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__GNUC__)
#define ROBCOGEN_INLINE inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE inline
#endif

// Vectors are an extension of gcc and clang. Elsewhere, and where ROBCOGEN_PLAIN_LANES is defined, lanes are scalars.
#if defined(__GNUC__) && !defined(ROBCOGEN_PLAIN_LANES)
#define ROBCOGEN_HAS_VECTORS 1
#define ROBCOGEN_VECTOR_SIZE(bytes) __attribute__((vector_size(bytes)))
#else
#define ROBCOGEN_HAS_VECTORS 0
#define ROBCOGEN_VECTOR_SIZE(bytes)
#endif

#if ROBCOGEN_HAS_VECTORS && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define ROBCOGEN_HAS_SHUFFLES 1
#endif
#endif
#if !defined(ROBCOGEN_HAS_SHUFFLES)
#define ROBCOGEN_HAS_SHUFFLES 0
#endif

namespace robcogen {

// Files of one program may be compiled for different processors. An unnamed namespace is separate in each file,
// so that the linker never replaces a function for one processor by that for another.
namespace {
namespace lanes {

#if defined(__AVX512F__)
constexpr int kRegisterBytes = 64;
#elif defined(__AVX2__)
constexpr int kRegisterBytes = 32;
#else
constexpr int kRegisterBytes = 16;
#endif

// The number of scalars in a register of the processor.
template <class Scalar>
constexpr int kInRegister = 1;
#if ROBCOGEN_HAS_VECTORS
template <>
constexpr int kInRegister<double> = kRegisterBytes / static_cast<int>(sizeof(double));
template <>
constexpr int kInRegister<float> = kRegisterBytes / static_cast<int>(sizeof(float));
#endif

// A vector type of the compiler with kSize elements, which has the operators of an element. For one element it is the
// element itself.
template <class Element, int kSize>
struct VectorOf {
  typedef Element type ROBCOGEN_VECTOR_SIZE(kSize * sizeof(Element));
};

template <class Element>
struct VectorOf<Element, 1> {
  using type = Element;
};

template <class Element, int kSize>
using Vector = typename VectorOf<Element, kSize>::type;

// Converts each element to the nearest number of the other type. (The result is not returned: how vectors that are
// longer than a register are returned depends on the processor.)
template <class From, class To>
ROBCOGEN_INLINE void convert(const From& from, To& to) noexcept {
  if constexpr (std::is_same_v<To, From>) {
    to = from;
  } else {
#if ROBCOGEN_HAS_VECTORS
    to = __builtin_convertvector(from, To);
#endif
  }
}

// Not std::sqrt: its overload for float is a library function, for which the linker keeps the copy of only one file.
template <class Scalar>
ROBCOGEN_INLINE Scalar square_root(const Scalar& x) noexcept {
#if defined(__GNUC__)
  if constexpr (std::is_same_v<Scalar, float>) return __builtin_sqrtf(x);
  if constexpr (std::is_same_v<Scalar, double>) return __builtin_sqrt(x);
#endif
  using std::sqrt;
  return sqrt(x);
}

}  // namespace lanes

// kSize scalars (a power of two): one vector if a register of the processor holds it, otherwise two halves. A lane may
// have any type that is a scalar to generated code, even Lanes.
//
// Like a plain number, it is not initialized unless it is given a value.
template <class Scalar, int kSize, bool kIsVector = (kSize <= lanes::kInRegister<Scalar> || kSize == 1)>
class Lanes;

template <class Scalar, int kSize>
class Lanes<Scalar, kSize, true> {
 public:
  using Vector = lanes::Vector<Scalar, kSize>;

  Lanes() = default;
  // The same number in all lanes.
  explicit ROBCOGEN_INLINE Lanes(const Scalar& x) noexcept {
    if constexpr (kSize == 1) {
      vector_ = x;
    } else {
      vector_ = x - Vector{};  // broadcasts x: subtracting 0 leaves every number as it is
    }
  }
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number> && !std::is_same_v<Number, Scalar>>>
  explicit ROBCOGEN_INLINE Lanes(Number x) noexcept : Lanes(static_cast<Scalar>(x)) {}

  static ROBCOGEN_INLINE Lanes of_vector(const Vector& vector) noexcept {
    Lanes result;
    result.vector_ = vector;
    return result;
  }
  ROBCOGEN_INLINE const Vector& vector() const noexcept { return vector_; }

  // A number for each lane.
  template <class... Number>
  static ROBCOGEN_INLINE Lanes of(const Number&... x) noexcept {
    static_assert(sizeof...(Number) == kSize, "a number for each lane");
    if constexpr (kSize == 1) {
      return of_vector(Scalar(x)...);
    } else {
      return of_vector(Vector{Scalar(x)...});
    }
  }

  // Load from and store to kSize contiguous numbers, of this or another precision. Those that have no vectors are
  // converted one by one: clang packs vectors of long double more tightly than arrays.
  template <class Number>
  static ROBCOGEN_INLINE Lanes load(const Number* from) noexcept {
    if constexpr (kSize == 1) {
      return of_vector(static_cast<Scalar>(*from));
    } else if constexpr (lanes::kInRegister<Number> == 1) {
      Lanes result;
      for (int i = 0; i < kSize; ++i) result.vector_[i] = static_cast<Scalar>(from[i]);
      return result;
    } else {
      lanes::Vector<Number, kSize> numbers;
      std::memcpy(&numbers, from, sizeof(numbers));
      Lanes result;
      lanes::convert(numbers, result.vector_);
      return result;
    }
  }
  template <class Number>
  ROBCOGEN_INLINE void store(Number* to) const noexcept {
    if constexpr (kSize == 1) {
      *to = static_cast<Number>(vector_);
    } else if constexpr (lanes::kInRegister<Number> == 1) {
      for (int i = 0; i < kSize; ++i) to[i] = static_cast<Number>(vector_[i]);
    } else {
      lanes::Vector<Number, kSize> numbers;
      lanes::convert(vector_, numbers);
      std::memcpy(to, &numbers, sizeof(numbers));
    }
  }

  // Load from and store to numbers at this stride.
  static ROBCOGEN_INLINE Lanes gather(const Scalar* from, std::ptrdiff_t stride) noexcept {
    return gather(from, stride, std::make_integer_sequence<int, kSize>());
  }
  ROBCOGEN_INLINE void scatter(Scalar* to, std::ptrdiff_t stride) const noexcept {
    for (int i = 0; i < kSize; ++i) to[i * stride] = (*this)[i];
  }

  ROBCOGEN_INLINE Scalar operator[](int lane) const noexcept {
    if constexpr (kSize == 1) {
      return vector_;
    } else {
      return vector_[lane];
    }
  }

  friend ROBCOGEN_INLINE Lanes operator+(const Lanes& a, const Lanes& b) noexcept {
    return of_vector(a.vector_ + b.vector_);
  }
  friend ROBCOGEN_INLINE Lanes operator-(const Lanes& a, const Lanes& b) noexcept {
    return of_vector(a.vector_ - b.vector_);
  }
  friend ROBCOGEN_INLINE Lanes operator*(const Lanes& a, const Lanes& b) noexcept {
    return of_vector(a.vector_ * b.vector_);
  }
  friend ROBCOGEN_INLINE Lanes operator/(const Lanes& a, const Lanes& b) noexcept {
    return of_vector(a.vector_ / b.vector_);
  }
  friend ROBCOGEN_INLINE Lanes operator-(const Lanes& a) noexcept { return of_vector(-a.vector_); }
  friend ROBCOGEN_INLINE Lanes sqrt(const Lanes& a) noexcept {
    if constexpr (kSize == 1) {
      return of_vector(lanes::square_root(a.vector_));
    } else {
      Lanes result = a;
      for (int i = 0; i < kSize; ++i) result.vector_[i] = lanes::square_root(a[i]);
      return result;
    }
  }

 private:
  template <int... kLane>
  static ROBCOGEN_INLINE Lanes
  gather(const Scalar* from, std::ptrdiff_t stride, std::integer_sequence<int, kLane...>) noexcept {
    return of_vector(Vector{from[kLane * stride]...});
  }

  Vector vector_;
};

template <class Scalar, int kSize>
class Lanes<Scalar, kSize, false> {
 public:
  using Half = Lanes<Scalar, kSize / 2>;
  static_assert(kSize > 0 && kSize % 2 == 0, "the number of lanes is a power of two");

  Lanes() = default;
  explicit ROBCOGEN_INLINE Lanes(const Scalar& x) noexcept : low_(x), high_(x) {}
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number> && !std::is_same_v<Number, Scalar>>>
  explicit ROBCOGEN_INLINE Lanes(Number x) noexcept : Lanes(static_cast<Scalar>(x)) {}
  ROBCOGEN_INLINE Lanes(const Half& low, const Half& high) noexcept : low_(low), high_(high) {}

  template <class... Number>
  static ROBCOGEN_INLINE Lanes of(const Number&... x) noexcept {
    static_assert(sizeof...(Number) == kSize, "a number for each lane");
    const Scalar* const all[] = {&x...};
    return of(all, std::make_integer_sequence<int, kSize / 2>());
  }

  ROBCOGEN_INLINE const Half& low() const noexcept { return low_; }
  ROBCOGEN_INLINE const Half& high() const noexcept { return high_; }

  template <class Number>
  static ROBCOGEN_INLINE Lanes load(const Number* from) noexcept {
    return {Half::load(from), Half::load(from + kSize / 2)};
  }
  template <class Number>
  ROBCOGEN_INLINE void store(Number* to) const noexcept {
    low_.store(to);
    high_.store(to + kSize / 2);
  }

  static ROBCOGEN_INLINE Lanes gather(const Scalar* from, std::ptrdiff_t stride) noexcept {
    return {Half::gather(from, stride), Half::gather(from + kSize / 2 * stride, stride)};
  }
  ROBCOGEN_INLINE void scatter(Scalar* to, std::ptrdiff_t stride) const noexcept {
    low_.scatter(to, stride);
    high_.scatter(to + kSize / 2 * stride, stride);
  }

  ROBCOGEN_INLINE Scalar operator[](int lane) const noexcept {
    return lane < kSize / 2 ? low_[lane] : high_[lane - kSize / 2];
  }

  friend ROBCOGEN_INLINE Lanes operator+(const Lanes& a, const Lanes& b) noexcept {
    return {a.low_ + b.low_, a.high_ + b.high_};
  }
  friend ROBCOGEN_INLINE Lanes operator-(const Lanes& a, const Lanes& b) noexcept {
    return {a.low_ - b.low_, a.high_ - b.high_};
  }
  friend ROBCOGEN_INLINE Lanes operator*(const Lanes& a, const Lanes& b) noexcept {
    return {a.low_ * b.low_, a.high_ * b.high_};
  }
  friend ROBCOGEN_INLINE Lanes operator/(const Lanes& a, const Lanes& b) noexcept {
    return {a.low_ / b.low_, a.high_ / b.high_};
  }
  friend ROBCOGEN_INLINE Lanes operator-(const Lanes& a) noexcept { return {-a.low_, -a.high_}; }
  friend ROBCOGEN_INLINE Lanes sqrt(const Lanes& a) noexcept { return {sqrt(a.low_), sqrt(a.high_)}; }

 private:
  template <int... kLane>
  static ROBCOGEN_INLINE Lanes of(const Scalar* const* x, std::integer_sequence<int, kLane...>) noexcept {
    return {Half::of(*x[kLane]...), Half::of(*x[kSize / 2 + kLane]...)};
  }

  Half low_, high_;
};

namespace lanes {

// Selected lanes of two values as one value; lanes of b are counted from kSize on. Arguments and result each fit into a
// register.
template <int... kLane, class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, sizeof...(kLane)> shuffled(
    const Lanes<Scalar, kSize>& a,
    const Lanes<Scalar, kSize>& b) noexcept {
  using Result = Lanes<Scalar, sizeof...(kLane)>;
#if ROBCOGEN_HAS_SHUFFLES
  if constexpr (kSize > 1 && sizeof...(kLane) > 1)
    return Result::of_vector(__builtin_shufflevector(a.vector(), b.vector(), kLane...));
  else
#endif
    return Result::of((kLane < kSize ? a[kLane] : b[kLane - kSize])...);
}

template <class Scalar, int kSize, int... kLane>
ROBCOGEN_INLINE Lanes<Scalar, 2 * kSize> joined(
    const Lanes<Scalar, kSize>& low,
    const Lanes<Scalar, kSize>& high,
    std::integer_sequence<int, kLane...>) noexcept {
  return shuffled<kLane...>(low, high);
}

// The lanes of both values as one value, which fits into a register.
template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, 2 * kSize> joined(
    const Lanes<Scalar, kSize>& low,
    const Lanes<Scalar, kSize>& high) noexcept {
  return joined(low, high, std::make_integer_sequence<int, 2 * kSize>());
}

// The first half of the lanes (0), or the second (1).
template <int kHalf, class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize / 2> half(const Lanes<Scalar, kSize>& x) noexcept {
  if constexpr (kSize > kInRegister<Scalar>) {
    return kHalf == 0 ? x.low() : x.high();
  } else if constexpr (kSize == 2) {
    return Lanes<Scalar, 1>(x[kHalf]);
  } else {
    Vector<Scalar, kSize / 2> halves[2];  // with a shuffle, gcc would not store the result to memory directly
    std::memcpy(halves, &x.vector(), sizeof(halves));
    return Lanes<Scalar, kSize / 2>::of_vector(halves[kHalf]);
  }
}

}  // namespace lanes

// Sum of all lanes, pairwise: each lane of the first half plus its counterpart in the second, and so on.
template <class Scalar, int kSize>
ROBCOGEN_INLINE Scalar sum_lanes(const Lanes<Scalar, kSize>& x) noexcept {
  if constexpr (kSize == 1) {
    return x[0];
  } else {
    return sum_lanes(lanes::half<0>(x) + lanes::half<1>(x));
  }
}

// Sums of the lanes of two values.
template <class Scalar>
struct TwoSums {
  Scalar first, second;
};

// Both sums at once: half as many instructions as one after the other, on processors that add neighbours.
template <class Scalar, int kSize>
ROBCOGEN_INLINE TwoSums<Scalar> sum_lanes(const Lanes<Scalar, kSize>& a, const Lanes<Scalar, kSize>& b) noexcept {
#if ROBCOGEN_HAS_VECTORS && defined(__SSE3__)
  if constexpr (std::is_same_v<Scalar, double> && kSize == 2) {
    const auto sums = __builtin_ia32_haddpd(a.vector(), b.vector());
    return {sums[0], sums[1]};
  }
#endif
#if ROBCOGEN_HAS_VECTORS && defined(__AVX2__)
  if constexpr (std::is_same_v<Scalar, double> && kSize == 4) {
    const auto neighbours = Lanes<Scalar, kSize>::of_vector(__builtin_ia32_haddpd256(a.vector(), b.vector()));
    const auto sums = lanes::half<0>(neighbours) + lanes::half<1>(neighbours);
    return {sums[0], sums[1]};
  }
#endif
  if constexpr (kSize == 1) {
    return {a[0], b[0]};
  } else {
    return sum_lanes(lanes::half<0>(a) + lanes::half<1>(a), lanes::half<0>(b) + lanes::half<1>(b));
  }
}

// Whether code that keeps limbs in lanes is faster for this scalar than code without lanes.
template <class Scalar>
constexpr bool kPrefersLanes = lanes::kInRegister<Scalar> > 1;

// As many lanes as fill a register, which is the fastest number.
template <class Scalar>
using NativeLanes = Lanes<Scalar, lanes::kInRegister<Scalar>>;

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
#undef ROBCOGEN_VECTOR_SIZE
#undef ROBCOGEN_HAS_SHUFFLES
