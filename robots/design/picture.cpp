#include "picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "svg.h"

namespace design {
namespace {

using svg::circle, svg::fill, svg::fixed, svg::kInk, svg::label, svg::line, svg::Point, svg::polyline, svg::stroke;

// Layout, in pixels.
constexpr double kWidth = 760, kLeft = 80, kRight = 600, kLegs = 175, kTop = 215, kBottom = 475, kHeight = 525;
constexpr double kPixelsPerMetre = 240;  // of the legs

// Middle tones: contrast at least 3.5 on white and on nearly black.
constexpr const char* kColours[] = {"#2a7ad8", "#d05a1e", "#2b8a3e"};

// Values from left to right and from bottom to top, with a line of the grid at each tick.
struct Axes {
  double first, last, low, high, x_tick, y_tick;
  int x_digits, y_digits;

  Point at(double x, double y) const {
    return {
        kLeft + (kRight - kLeft) * (x - first) / (last - first), kBottom - (kBottom - kTop) * (y - low) / (high - low)};
  }
};

std::string grid(const Axes& axes, const std::string& x_label, const std::string& y_label) {
  constexpr double kRounding = 1e-9;
  std::string text;
  for (int i = 0; axes.low + i * axes.y_tick < axes.high + kRounding; ++i) {
    const double value = axes.low + i * axes.y_tick;
    const Point left = axes.at(axes.first, value);
    text += line(left, {kRight, left.y}, stroke(kInk, i == 0 ? 1.5 : 0.6, i == 0 ? "" : "opacity=\"0.5\""));
    text += label({left.x - 8, left.y + 4}, fixed(value, axes.y_digits), "text-anchor=\"end\"");
  }
  for (int i = 0; axes.first + i * axes.x_tick < axes.last + kRounding; ++i) {
    const Point bottom = axes.at(axes.first + i * axes.x_tick, axes.low);
    text += line(bottom, {bottom.x, bottom.y + 5}, stroke(kInk, 1.5));
    text +=
        label({bottom.x, bottom.y + 18}, fixed(axes.first + i * axes.x_tick, axes.x_digits), "text-anchor=\"middle\"");
  }
  const double middle = (kTop + kBottom) / 2;
  text += label({(kLeft + kRight) / 2, kBottom + 38}, x_label, "text-anchor=\"middle\"");
  text += label({22, middle}, y_label, "text-anchor=\"middle\" transform=\"rotate(-90 22 " + fixed(middle, 0) + ")\"");
  return text;
}

std::string curve(const Axes& axes, const std::vector<Sample>& samples, const std::string& style) {
  std::vector<Point> points;
  for (const Sample& sample : samples) points.push_back(axes.at(sample.x, sample.value));
  return polyline(points, "fill=\"none\" stroke-linejoin=\"round\" " + style);
}

std::string name(const Axes& axes, const Sample& end, const std::string& text, const char* colour) {
  const Point at = axes.at(end.x, end.value);
  return label({kRight + 8, at.y + 4}, text, fill(colour));
}

// The left front leg as the quadruped stands on it, its hip this far above the foot.
std::string leg(double x, double upper, double lower, double height, const std::string& text) {
  constexpr double kHip = 0.08;  // m, below the origin of the trunk
  const Parameters parameters(with_lengths(upper, lower));
  const JointState q = posture(parameters, feet_below_hips(-kHip - height), bent_knees());
  const Eigen::Matrix4d X = quadruped::transforms::homogeneous::fr_trunk_X_fr_LF_lowerleg(parameters, q);
  const Feet feet = feet_below_hips(-kHip);
  const auto at = [&](double forward, double up) {
    return Point{x + kPixelsPerMetre * (forward - feet[0]), kLegs - kPixelsPerMetre * (up + kHip + height)};
  };
  const Point hip = at(feet[0], -kHip), knee = at(X(0, 3), X(2, 3)), foot = at(feet[0], -kHip - height);
  return line({x - 40, kLegs}, {x + 40, kLegs}, stroke(kInk, 1.5)) +
         polyline(
             {hip, knee, foot}, "fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" " + stroke(kInk, 4)) +
         circle(hip, 6, fill(kColours[0])) + circle(knee, 4, fill(kInk)) + circle(foot, 4, fill(kColours[1])) +
         label({x, kLegs + 18}, text, "text-anchor=\"middle\" font-size=\"12\"");
}

const Sample& highest(const std::vector<Sample>& samples) {
  return *std::max_element(
      samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.value < b.value; });
}

std::string centimetres(double upper, double lower) {
  return fixed(100 * upper, 1) + " + " + fixed(100 * lower, 1) + " cm";
}

}  // namespace

std::string jump_picture(const std::vector<JumpCurve>& curves) {
  const Axes axes{0.26, 0.48, 0.5, 1.1, 0.02, 0.1, 2, 1};
  std::string text = label({kLeft, 22}, "Squat jump, upper leg of 36.4 cm", "font-weight=\"bold\"");
  for (const double length : {0.26, 0.36, 0.48})
    text += leg(axes.at(length, 0).x, kUpperLength, length, kStarts[0] - 0.08, centimetres(kUpperLength, length));
  text += grid(axes, "length of the lower leg [m]", "rise of the trunk / length of the lower leg");
  for (const JumpCurve& c : curves) {
    const char* colour = kColours[c.start == kStarts[0] ? 0 : 1];
    const bool is_limited = c.torque_limit < std::numeric_limits<double>::infinity();
    text += curve(axes, c.samples, stroke(colour, 2, is_limited ? "" : "stroke-dasharray=\"6 4\""));
    if (is_limited) text += circle(axes.at(highest(c.samples).x, highest(c.samples).value), 4.5, fill(colour));
    const std::string limit = is_limited ? fixed(c.torque_limit, 0) + " N m" : "no limit";
    text += name(axes, c.samples.back(), "from " + fixed(c.start, 2) + " m, " + limit, colour);
  }
  return svg::document(kWidth, kHeight, "A quadruped jumps: rise over the length of its lower legs", text);
}

std::string trot_picture(const std::vector<TrotCurve>& curves) {
  const Axes axes{0.4, 1.9, 0.85, 1.2, 0.1, 0.05, 1, 2};
  std::string text = label({kLeft, 22}, "Trot, upper and lower leg of 68 cm together", "font-weight=\"bold\"");
  for (const double ratio : {0.5, 1.0, 1.8}) {
    const double lower = kTotalLength / (1 + ratio);
    text += leg(axes.at(ratio, 0).x, kTotalLength - lower, lower, 0.52, centimetres(kTotalLength - lower, lower));
  }
  text += grid(axes, "length of the upper leg / length of the lower leg", "power / power of equal lengths");
  int colour = 0;
  for (const TrotCurve& c : curves) {
    const double equal = mechanical_power_value(with_lengths(kTotalLength / 2, kTotalLength / 2), Trot{c.speed});
    std::vector<Sample> relative = c.samples;
    for (Sample& sample : relative) sample.value /= equal;
    text += curve(axes, relative, stroke(kColours[colour], 2));
    text += name(axes, relative.back(), fixed(c.speed, 1) + " m/s, " + fixed(equal, 0) + " W a leg", kColours[colour]);
    ++colour;
  }
  return svg::document(kWidth, kHeight, "A quadruped trots: power over the place of the knee", text);
}

}  // namespace design
