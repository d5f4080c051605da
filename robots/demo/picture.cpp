#include "picture.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "svg.h"

namespace demo {
namespace {

using svg::circle, svg::fill, svg::fixed, svg::label, svg::line, svg::Point, svg::polyline, svg::px, svg::stroke;

// Layout, in pixels of the picture. A metre is as long forwards as upwards, so that the leg keeps its shape.
constexpr double kWidth = 1060;
constexpr double kHeight = 530;
constexpr double kLeft = 70;           // at time 0
constexpr double kRight = 970;         // at the end
constexpr double kFigureRight = 1050;  // the last leg needs room
constexpr double kGround = 340;        // height 0
constexpr double kPixelsPerMetre = 340;
constexpr double kForceZero = 490;
constexpr double kForceTop = 405;
constexpr double kFigureInterval = 0.06;  // s between two stick figures

// Middle tones, like kInk.
using svg::kInk;
constexpr const char* kHip = "#2a7ad8";
constexpr const char* kFoot = "#d05a1e";
constexpr const char* kForce = "#2b8a3e";

// The time axis runs to the right; a leg is drawn around its time.
struct Axes {
  double duration;   // s
  double top_force;  // N

  double at_time(double time) const { return kLeft + (kRight - kLeft) * time / duration; }
  Point at(double time, const Eigen::Vector2d& position) const {
    return {at_time(time) + kPixelsPerMetre * position.x(), kGround - kPixelsPerMetre * position.y()};
  }
  Point at_force(double time, double force) const {
    return {at_time(time), kForceZero - (kForceZero - kForceTop) * force / top_force};
  }
};

// Grid, ground, ticks and their labels.
std::string scales(const Axes& axes) {
  std::string text;
  for (const double height : {0.0, 0.2, 0.4, 0.6, 0.8}) {
    const double y = kGround - kPixelsPerMetre * height;
    text += line(
        {kLeft - 5, y}, {kFigureRight, y}, stroke(kInk, height == 0 ? 2.5 : 0.5, height == 0 ? "" : "opacity=\"0.5\""));
    text += label({kLeft - 10, y + 4}, fixed(height, 1), "text-anchor=\"end\"");
  }
  for (double x = kLeft; x < kFigureRight; x += 12)
    text += line({x + 8, kGround + 1}, {x, kGround + 9}, stroke(kInk, 1));
  text += label({16, 185}, "height above the ground [m]", "text-anchor=\"middle\" transform=\"rotate(-90 16 185)\"");

  for (double force = 0; force <= axes.top_force; force += 200) {
    const double y = axes.at_force(0, force).y;
    text +=
        line({kLeft - 5, y}, {kRight, y}, stroke(kInk, force == 0 ? 1.5 : 0.5, force == 0 ? "" : "opacity=\"0.5\""));
    text += label({kLeft - 10, y + 4}, fixed(force, 0), "text-anchor=\"end\"");
  }
  text += label({16, 448}, "force [N]", "text-anchor=\"middle\" transform=\"rotate(-90 16 448)\"");

  for (int tick = 0; 0.5 * tick <= axes.duration; ++tick) {
    const double x = axes.at_time(0.5 * tick);
    text += line({x, kForceZero}, {x, kForceZero + 5}, stroke(kInk, 1.5));
    text += label({x, kForceZero + 18}, fixed(0.5 * tick, 1), "text-anchor=\"middle\"");
  }
  text += label({(kLeft + kRight) / 2, kForceZero + 36}, "time [s]", "text-anchor=\"middle\"");
  return text;
}

std::string stick_figure(const Axes& axes, const Instant& instant) {
  const Point hip = axes.at(instant.time, instant.hip);
  const Point knee = axes.at(instant.time, instant.knee);
  const Point foot = axes.at(instant.time, instant.foot);
  // Figures in the air are paler than those on the ground.
  const std::string opacity = instant.ground_force > 0 ? "opacity=\"1\"" : "opacity=\"0.6\"";
  return "<g " + opacity + ">" +
         polyline(
             {hip, knee, foot},
             "fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" " + stroke(kInk, 2.5)) +
         circle(hip, 4, fill(kHip)) + circle(knee, 2.5, fill(kInk)) + circle(foot, 3, fill(kFoot)) + "</g>\n";
}

}  // namespace

std::string picture(const std::vector<Instant>& instants) {
  double highest = 0;
  for (const Instant& instant : instants) highest = std::max(highest, instant.ground_force);
  const Axes axes{instants.back().time, 200 * std::ceil(highest / 200)};

  std::vector<Point> hip, foot, force;
  std::string figures;
  double next_figure = 0;
  for (const Instant& instant : instants) {
    hip.push_back(axes.at(instant.time, instant.hip));
    foot.push_back(axes.at(instant.time, instant.foot));
    force.push_back(axes.at_force(instant.time, instant.ground_force));
    if (instant.time + 1e-9 < next_figure) continue;
    figures += stick_figure(axes, instant);
    next_figure += kFigureInterval;
  }

  const double w = weight();
  std::string text = label(
      {kLeft, 22}, "The HyL leg drops and hops: one figure every " + fixed(1000 * kFigureInterval, 0) +
                       " ms, stronger while the foot is on the ground");
  text += scales(axes) + figures;
  text += polyline(hip, "fill=\"none\" " + stroke(kHip, 1.8)) + polyline(foot, "fill=\"none\" " + stroke(kFoot, 1.8));
  text += label({hip.front().x + 8, hip.front().y - 6}, "hip", fill(kHip));
  text += label({foot.front().x + 8, foot.front().y - 8}, "foot", fill(kFoot));
  text += line(axes.at_force(0, w), axes.at_force(axes.duration, w), stroke(kInk, 1.2, "stroke-dasharray=\"6 4\""));
  text += label({kRight + 6, axes.at_force(0, w).y + 4}, "weight");
  text += polyline(force, "fill=\"none\" " + stroke(kForce, 1.8));
  text += label({kLeft + 6, kForceTop - 8}, "vertical force of the ground on the foot", fill(kForce));
  return svg::document(kWidth, kHeight, "The HyL leg drops and hops", text);
}

}  // namespace demo
