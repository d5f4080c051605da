#include "picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "svg.h"

namespace optimal_control {
namespace {

using svg::circle, svg::fill, svg::fixed, svg::kInk, svg::label, svg::line, svg::Point, svg::polyline, svg::stroke;

// Layout, in pixels: figures on the left, two charts on the right.
constexpr double kWidth = 920, kHeight = 440;
constexpr double kLeft = 560, kRight = 880, kTop = 50, kMiddle = 190, kLower = 250, kBottom = 390;
constexpr double kCentreX = 260, kCentreY = 235;
constexpr double kPixelsPerMetre = 165;
constexpr int kFigures = 25;

// Middle tones: contrast at least 3.5 on white and on nearly black.
constexpr const char* kColours[] = {"#2a7ad8", "#d05a1e", "#2b8a3e"};

struct Place {
  double forward, up;  // m
};
using Figure = std::vector<Place>;  // from the base to the tip

Point at(const Place& p, double scale) {
  return {kCentreX + scale * kPixelsPerMetre * p.forward, kCentreY - scale * kPixelsPerMetre * p.up};
}

// Figures that become stronger with time, and the path of the tip.
std::string figures(const std::vector<Figure>& all, double scale) {
  std::string text;
  std::vector<Point> path;
  for (const Figure& f : all) path.push_back(at(f.back(), scale));
  text += polyline(path, "fill=\"none\" " + stroke(kColours[1], 1.2, "opacity=\"0.8\""));
  for (int i = 0; i <= kFigures; ++i) {
    const double share = static_cast<double>(i) / kFigures;
    const Figure& f = all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
    std::vector<Point> points;
    for (const Place& p : f) points.push_back(at(p, scale));
    text += "<g opacity=\"" + fixed(0.15 + 0.85 * share * share, 2) + "\">" +
            polyline(
                points, "fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" " +
                            stroke(kInk, i == kFigures ? 4 : 2)) +
            circle(points.front(), 4, fill(kColours[0])) + circle(points.back(), 3, fill(kColours[1])) + "</g>\n";
  }
  return text;
}

// A chart with values from `low` to `high`, and a tick at each of `ticks`.
struct Chart {
  double top, bottom, last, low, high;

  Point at(double x, double y) const {
    return {kLeft + (kRight - kLeft) * x / last, bottom - (bottom - top) * (y - low) / (high - low)};
  }
  std::string grid(const std::string& title, const std::string& x_label, const std::vector<double>& ticks) const {
    std::string text = label({kLeft, top - 10}, title, "font-weight=\"bold\"");
    for (const double tick : ticks) {
      const Point left = at(0, tick);
      text += line(left, {kRight, left.y}, stroke(kInk, 0.6, "opacity=\"0.5\""));
      text += label({left.x - 8, left.y + 4}, fixed(tick, 0), "text-anchor=\"end\"");
    }
    text += label({kLeft, bottom + 18}, "0", "text-anchor=\"middle\"");
    text += label({kRight, bottom + 18}, fixed(last, 0) + " " + x_label, "text-anchor=\"end\"");
    return text;
  }
};

template <class Motion>
std::string charts(const Motion& motion, int count, const std::vector<std::string>& names, const std::string& unit) {
  const auto& trajectory = motion.trajectory;
  const double most = motion.limits.head(count).maxCoeff();
  const Chart forces{kTop, kMiddle, motion.time_step * static_cast<double>(trajectory.u.size()), -most, most};
  std::string text = forces.grid("forces of the joints [" + unit + "]", "s", {-most, 0, most});
  for (int joint = 0; joint < count; ++joint) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < trajectory.u.size(); ++k)
      points.push_back(forces.at(motion.time_step * static_cast<double>(k), motion.force(k)[joint]));
    text += polyline(points, "fill=\"none\" " + stroke(kColours[joint], 1.6));
    text += label(
        {kRight - 30.0 * (count - joint), kTop - 10}, names[static_cast<std::size_t>(joint)], fill(kColours[joint]));
  }
  std::vector<double> costs;
  for (const double cost : trajectory.costs) costs.push_back(std::log10(cost));
  const double low = std::floor(costs.back()), high = std::ceil(costs.front());
  const Chart chart{kLower, kBottom, static_cast<double>(costs.size() - 1), low, high};
  std::vector<double> ticks;
  for (double tick = low; tick <= high; ++tick) ticks.push_back(tick);
  text += chart.grid("cost, its decimal logarithm", "iterations", ticks);
  std::vector<Point> points;
  for (std::size_t i = 0; i < costs.size(); ++i) points.push_back(chart.at(static_cast<double>(i), costs[i]));
  return text + polyline(points, "fill=\"none\" " + stroke(kColours[0], 1.8));
}

}  // namespace

std::string picture(const CartPoleMotion& motion) {
  std::vector<Figure> all;
  for (const Eigen::Vector4d& x : motion.trajectory.x) {
    const Eigen::Vector2d q = x.head<2>();
    const Eigen::Matrix4d tip = cart_pole::transforms::homogeneous::fr_base_X_fr_tip(q);
    all.push_back({{q[0], 0}, {tip(1, 3), tip(2, 3)}});
  }
  const double rail = kPixelsPerMetre * 1.2;
  return svg::document(
      kWidth, kHeight, "A cart-pole swings up",
      line({kCentreX - rail, kCentreY}, {kCentreX + rail, kCentreY}, stroke(kInk, 1.5)) + figures(all, 1) +
          charts(motion, 1, {"RAIL"}, "N"));
}

std::string picture(const PumaMotion& motion) {
  namespace homogeneous = puma560_control::transforms::homogeneous;
  std::vector<Figure> all;
  const auto place = [](const Eigen::Matrix4d& X) { return Place{X(0, 3), X(2, 3)}; };
  for (const auto& x : motion.trajectory.x) {
    const Eigen::Matrix<double, 6, 1> q = x.head<6>();
    all.push_back(
        {{0, 0},
         place(homogeneous::fr_base_X_fr_link3(q)),
         place(homogeneous::fr_base_X_fr_link4(q)),
         place(homogeneous::fr_base_X_fr_ee(q))});
  }
  return svg::document(
      kWidth, kHeight, "The PUMA 560 swings up", figures(all, 1.15) + charts(motion, 3, {"J1", "J2", "J3"}, "N m"));
}

}  // namespace optimal_control
