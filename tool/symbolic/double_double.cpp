#include "symbolic/double_double.h"

#include <array>
#include <functional>
#include <type_traits>

namespace robcogen::symbolic {
namespace {

// The number of terms 1 / n! of the Taylor series; later ones do not affect 32 digits.
constexpr int kTerms = 28;

std::array<DoubleDouble, kTerms> inverse_factorials() {
  std::array<DoubleDouble, kTerms> list;
  list[0] = {1.0, 0.0};
  for (std::size_t n = 1; n < list.size(); ++n) list[n] = list[n - 1] / DoubleDouble{static_cast<double>(n), 0.0};
  return list;
}

// The sum of every second term from `first` on, with alternating signs, in powers of `square`.
DoubleDouble series(const DoubleDouble& square, std::size_t first) {
  static const std::array<DoubleDouble, kTerms> factors = inverse_factorials();
  DoubleDouble sum;
  for (std::size_t k = kTerms / 2; k-- > 0;) sum = factors[first + 2 * k] - square * sum;
  return sum;
}

SineCosine computed(const DoubleDouble& angle) {
  // A quarter turn as the sum of three doubles, whose products with the number of turns are exact enough up to 1e5.
  constexpr std::array<double, 3> kQuarter = {
      1.570796326794896558e+00, 6.123233995736766036e-17, -1.497384904859169777e-33};
  const double turns = std::floor(angle.high * 6.366197723675813431e-01 + 0.5);
  DoubleDouble rest = angle;
  for (const double part : kQuarter) rest = rest - two_product(turns, part);
  const DoubleDouble square = rest * rest;
  const DoubleDouble sine = rest * series(square, 1), cosine = series(square, 0);
  const double quarter = turns - 4.0 * std::floor(turns / 4.0);
  if (quarter == 0.0) return {sine, cosine};
  if (quarter == 1.0) return {cosine, -sine};
  if (quarter == 2.0) return {-sine, -cosine};
  return {-cosine, sine};
}

struct Known {
  bool is_known = false;
  DoubleDouble angle;
  SineCosine value;
};

// A thread's last results, each in the place that its angle's hash gives. There is nothing to destroy: programs of MinGW
// release a thread's memory before they call the destructors of its variables (gcc bug 80816).
constexpr std::size_t kPlaces = 1 << 13;
using Table = std::array<Known, kPlaces>;
static_assert(std::is_trivially_destructible_v<Table>);

std::size_t place_of(const DoubleDouble& angle) {
  const std::hash<double> hash;
  const std::size_t mixed = hash(angle.high) * 31 + hash(angle.low);
  return (mixed ^ mixed >> 29) % kPlaces;
}

}  // namespace

// The programs of one robot use the same angles in the same states: each thread computes each of them once.
SineCosine sine_cosine(const DoubleDouble& angle) {
  thread_local Table table;
  Known& known = table[place_of(angle)];
  if (!known.is_known || known.angle.high != angle.high || known.angle.low != angle.low)
    known = {true, angle, computed(angle)};
  return known.value;
}

// Refines a rough angle in two steps. Each adds the arc sine of the remaining sine up to the third order, which
// multiplies the number of correct digits by five. The start is computed without the mathematical library, by a
// polynomial with an error of at most 4e-3 rad in the first eighth of the circle.
DoubleDouble atan2(const DoubleDouble& sine, const DoubleDouble& cosine) {
  const double s = std::abs(sine.high), c = std::abs(cosine.high);
  const double t = s < c ? s / c : s > 0.0 ? c / s : 0.0;
  double rough = t * (0.7853981633974483 + 0.273 * (1.0 - t));
  if (s >= c && s > 0.0) rough = 1.5707963267948966 - rough;
  if (cosine.high < 0.0) rough = 3.141592653589793 - rough;
  DoubleDouble angle = {sine.high < 0.0 ? -rough : rough, 0.0};
  const DoubleDouble length = sqrt(sine * sine + cosine * cosine);
  if (length.high == 0.0) return {};
  constexpr int kSteps = 2;
  for (int step = 0; step < kSteps; ++step) {
    const SineCosine now = sine_cosine(angle);
    const DoubleDouble rest = (sine * now.cosine - cosine * now.sine) / length;  // sine of the remaining angle
    angle = angle + rest + rest * rest * rest / DoubleDouble{6.0, 0.0};
  }
  return angle;
}

}  // namespace robcogen::symbolic
