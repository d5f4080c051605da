#include "picture.h"

#include <algorithm>
#include <cmath>

#include "svg.h"

namespace tracking {
namespace {

using svg::fill, svg::fixed, svg::kInk, svg::label, svg::line, svg::Point, svg::polyline, svg::stroke;

// Layout, in pixels.
constexpr double kWidth = 900, kLeft = 70, kRight = 880, kTop = 64, kPanel = 170, kGap = 54;
constexpr double kLegendWidth = 215;
constexpr double kFrom = 0.6, kUntil = 1.2;  // s, the time that is shown: three periods

// Middle tones: contrast at least 3.5 on white and on nearly black.
constexpr const char* kModel = "#2a7ad8";
constexpr const char* kNoModel = "#d05a1e";

double degrees(double radians) {
  return radians * 180 / M_PI;
}

const char* colour(const Result& run) {
  return run.law == Law::inverse_dynamics ? kModel : kNoModel;
}

// Curves of slow controllers are dashed.
std::string style(const Result& run) {
  return "fill=\"none\" " + stroke(colour(run), 1.8, run.rate < 500 ? "stroke-dasharray=\"7 3\"" : "");
}

// One panel, with time to the right and values from `low` to `high` upwards.
struct Panel {
  double top, low, high;

  Point at(double time, double value) const {
    return {kLeft + (kRight - kLeft) * (time - kFrom) / (kUntil - kFrom), top + kPanel * (high - value) / (high - low)};
  }
};

// Distance of about `count` ticks in a range: 1, 2 or 5 times a power of ten.
double tick_distance(double range, double count) {
  const double power = std::pow(10, std::floor(std::log10(range / count)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (range / (factor * power) <= count) return factor * power;
  return 10 * power;
}

std::string grid(const Panel& panel, const std::string& title) {
  const double distance = tick_distance(panel.high - panel.low, 5);
  const double first = std::ceil(panel.low / distance);
  std::string text = label({kLeft, panel.top - 10}, title, "font-weight=\"bold\"");
  for (int i = 0; (first + i) * distance <= panel.high; ++i) {
    const double value = (first + i) * distance;
    const Point left = panel.at(kFrom, value), right = panel.at(kUntil, value);
    text += line(left, right, stroke(kInk, 0.6, "opacity=\"0.5\""));
    text += label({left.x - 8, left.y + 4}, fixed(value, distance < 1 ? 1 : 0), "text-anchor=\"end\"");
  }
  for (int i = 0; i <= 6; ++i) {
    const double time = kFrom + 0.1 * i;
    const Point bottom = panel.at(time, panel.low);
    text += line({bottom.x, panel.top}, {bottom.x, bottom.y + 5}, stroke(kInk, 0.6, "opacity=\"0.5\""));
    text += label({bottom.x, bottom.y + 18}, fixed(time, 1), "text-anchor=\"middle\"");
  }
  return text;
}

template <class Value>
std::string curve(const Panel& panel, const Result& run, const std::string& attributes, const Value& value) {
  std::vector<Point> points;
  for (const Instant& instant : run.instants)
    if (instant.time >= kFrom - 1e-9 && instant.time <= kUntil + 1e-9)
      points.push_back(panel.at(instant.time, value(instant)));
  return polyline(points, attributes);
}

// A panel for values of all runs, large enough for the largest.
template <class Value>
Panel panel_of(double top, const std::vector<Result>& runs, const Value& value) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Result& run : runs) {
    for (const Instant& instant : run.instants) {
      low = std::min(low, value(instant));
      high = std::max(high, value(instant));
    }
  }
  const double margin = 0.05 * (high - low) + 1e-6;
  return {top, low - margin, high + margin};
}

std::string legend(const std::vector<Result>& runs) {
  const std::string wanted = "fill=\"none\" " + stroke(kInk, 3, "opacity=\"0.7\"");
  std::string text;
  double x = kLeft;
  const auto entry = [&](const std::string& name, const std::string& attributes, double width) {
    text += polyline({{x, 20}, {x + 30, 20}}, attributes) + label({x + 36, 24}, name);
    x += width;
  };
  entry("wanted", wanted, 105);
  for (const Result& run : runs) entry(name_of(run), style(run), run.law == Law::inverse_dynamics ? kLegendWidth : 130);
  return text;
}

}  // namespace

std::string name_of(const Result& run) {
  return std::string(run.law == Law::inverse_dynamics ? "inverse dynamics" : "PD") + ", " + fixed(run.rate, 0) + " Hz";
}

std::string picture(const std::vector<Result>& runs) {
  std::string text = legend(runs);
  double top = kTop;
  for (int joint = 0; joint < 2; ++joint) {
    const auto found = [joint](const Instant& i) { return degrees(i.found[joint]); };
    const auto wanted = [joint](const Instant& i) { return degrees(i.wanted[joint]); };
    const Panel panel = panel_of(top, runs, found);
    text += grid(panel, joint == 0 ? "hip (HFE), degrees" : "knee (KFE), degrees");
    text += curve(panel, runs.front(), "fill=\"none\" " + stroke(kInk, 3, "opacity=\"0.7\""), wanted);
    for (const Result& run : runs) text += curve(panel, run, style(run), found);
    top += kPanel + kGap;
  }
  const auto error = [](const Instant& i) { return degrees((i.found - i.wanted).norm()); };
  const Panel panel = panel_of(top, runs, error);
  text += grid(panel, "error of both together, degrees");
  for (const Result& run : runs) text += curve(panel, run, style(run), error);
  text += label({(kLeft + kRight) / 2, top + kPanel + 36}, "time [s]", "text-anchor=\"middle\"");
  return svg::document(kWidth, top + kPanel + 46, "The HyL leg tracks a sinusoid of 5 Hz", text);
}

}  // namespace tracking
