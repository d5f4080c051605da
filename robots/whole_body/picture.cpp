#include "picture.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "svg.h"

namespace whole_body {
namespace {

using svg::circle, svg::fill, svg::fixed, svg::kInk, svg::label, svg::line, svg::Point, svg::polyline, svg::stroke;

// Layout, in pixels: figures above, two charts below, with one time axis.
constexpr double kWidth = 920, kHeight = 560, kLeft = 70, kRight = 890;
constexpr double kGround = 240;
constexpr double kUpper = 300, kMiddle = 400, kLower = 440, kBottom = 520;
constexpr double kPixelsPerMetre = 110;
constexpr int kFigures = 7;

// Middle tones: contrast at least 3.5 on white and on nearly black.
constexpr const char* kColours[] = {"#2a7ad8", "#d05a1e", "#2b8a3e", "#a24bc0"};

double at_time(const Motion& motion, double time) {
  return kLeft + (kRight - kLeft) * time / motion.instants.back().time;
}

// The projection of a point, seen from the right and from above.
Point seen(double x, const Eigen::Vector3d& p) {
  return {x + kPixelsPerMetre * (p.x() - 0.4 * p.y()), kGround - kPixelsPerMetre * (p.z() + 0.25 * p.y())};
}

std::string figures(const Motion& motion) {
  std::string text = line({kLeft, kGround}, {kRight, kGround}, stroke(kInk, 0.6, "opacity=\"0.5\""));
  for (int k = 0; k < kFigures; ++k) {
    const double share = (k + 0.5) / kFigures;
    const auto& instant =
        motion.instants[static_cast<std::size_t>(share * static_cast<double>(motion.instants.size()))];
    const double x = at_time(motion, instant.time);
    for (const auto& places : instant.lines) {
      std::vector<Point> points;
      for (const Eigen::Vector3d& p : places) points.push_back(seen(x, p));
      text += polyline(points, "fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" " + stroke(kInk, 2.2));
    }
    text += circle(seen(x, instant.com), 4, fill(kColours[1]));
    text += label({x, kGround + 28}, fixed(instant.time, 1) + " s", "text-anchor=\"middle\"");
  }
  return text;
}

// Values over time, from `low` to `high`, with one curve per name.
std::string chart(
    const Motion& motion,
    double top,
    double bottom,
    const std::string& title,
    const std::vector<double>& ticks,
    const std::vector<std::string>& names,
    const std::function<double(const Instant&, std::size_t)>& value) {
  const double low = ticks.front(), high = ticks.back();
  const auto at = [&](double y) { return bottom - (bottom - top) * (y - low) / (high - low); };
  std::string text = label({kLeft, top - 8}, title, "font-weight=\"bold\"");
  for (const double tick : ticks) {
    text += line({kLeft, at(tick)}, {kRight, at(tick)}, stroke(kInk, 0.6, "opacity=\"0.5\""));
    text += label({kLeft - 8, at(tick) + 4}, fixed(tick, 0), "text-anchor=\"end\"");
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<Point> points;
    for (const Instant& i : motion.instants) points.push_back({at_time(motion, i.time), at(value(i, k))});
    text += polyline(points, "fill=\"none\" " + stroke(kColours[k], 1.6));
    text += label(
        {kRight - 60.0 * static_cast<double>(names.size() - k - 1), top - 8}, names[k],
        std::string("text-anchor=\"end\" ") + fill(kColours[k]));
  }
  return text;
}

// At least three multiples of a round number that enclose the values.
std::vector<double> ticks(double low, double high) {
  const double rough = (high - low) / 3, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = power * (rough > 5 * power ? 10 : rough > 2 * power ? 5 : 2);
  std::vector<double> result;
  for (double tick = step * std::floor(low / step); tick < high + step; tick += step) result.push_back(tick);
  return result;
}

std::vector<double> ticks_of(
    const Motion& motion,
    std::size_t count,
    const std::function<double(const Instant&, std::size_t)>& value) {
  double low = 0, high = 1;
  for (const Instant& i : motion.instants)
    for (std::size_t k = 0; k < count; ++k) {
      low = std::min(low, value(i, k));
      high = std::max(high, value(i, k));
    }
  return ticks(low, high);
}

}  // namespace

std::string picture(const Motion& motion) {
  const Eigen::Vector3d start = motion.instants.front().com;
  const auto moved = [&](const Instant& i, std::size_t k) {
    return 1e3 * (i.com - start)[static_cast<Eigen::Index>(k)];
  };
  const auto load = [](const Instant& i, std::size_t k) { return i.loads[k]; };
  const std::vector<std::string> feet = motion.instants.front().loads.size() == 4
                                            ? std::vector<std::string>{"LF", "RF", "LH", "RH"}
                                            : std::vector<std::string>{"left", "right"};
  std::string push;
  if (motion.push_ends > motion.push_begins) {
    const double x = at_time(motion, motion.push_begins);
    push = line({x, kUpper - 4}, {x, kBottom}, stroke(kInk, 1, "stroke-dasharray=\"4 4\"")) +
           label(
               {x + 5, kUpper + 12},
               fixed(motion.push.norm(), 0) + " N for " + fixed(motion.push_ends - motion.push_begins, 1) + " s");
  }
  return svg::document(
      kWidth, kHeight, motion.title,
      figures(motion) +
          chart(
              motion, kUpper, kMiddle, "centre of mass moves by [mm]", ticks_of(motion, 3, moved),
              {"forward", "left", "up"}, moved) +
          chart(
              motion, kLower, kBottom, "vertical forces of the ground [N]", ticks_of(motion, feet.size(), load), feet,
              load) +
          push + label({kRight, kBottom + 22}, fixed(motion.instants.back().time, 0) + " s", "text-anchor=\"end\"") +
          label({kLeft, kBottom + 22}, "0", "text-anchor=\"middle\""));
}

}  // namespace whole_body
