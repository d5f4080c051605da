#include "picture.h"

#include <algorithm>
#include <cmath>

#include "svg.h"

namespace identification {
namespace {

using svg::fixed, svg::kInk, svg::label, svg::line, svg::Point, svg::polyline, svg::stroke;

// Layout, in pixels.
constexpr double kWidth = 900, kLeft = 60, kRight = 880, kTop = 60, kPanel = 90, kGap = 34;
constexpr const char* kIdentified = "#2a7ad8";
constexpr const char* kGuessed = "#d05a1e";

std::string style(const char* colour, double width, const std::string& more = "") {
  return "fill=\"none\" " + stroke(colour, width, more);
}

// The panel of one joint, with time to the right and torques from -`most` to `most` upwards.
struct Panel {
  double top, most;
  Point at(double time, double value) const {
    return {kLeft + (kRight - kLeft) * time / Motion::kPeriod, top + kPanel / 2 * (1 - value / most)};
  }
};

template <class Value>
std::string curve(
    const Panel& panel,
    const std::vector<Instant>& instants,
    const std::string& attributes,
    const Value& value) {
  std::vector<Point> points;
  for (const Instant& instant : instants) points.push_back(panel.at(instant.time, value(instant)));
  return polyline(points, attributes);
}

}  // namespace

std::string picture(const std::vector<Instant>& instants, const Unknowns& guessed, const Unknowns& identified) {
  std::string text;
  double x = kLeft;
  for (const auto& [name, attributes] :
       {std::pair{"measured", style(kInk, 1, "opacity=\"0.8\"")}, std::pair{"guessed parameters", style(kGuessed, 1.6)},
        std::pair{"identified parameters", style(kIdentified, 1.6)}}) {
    text += polyline({{x, 20}, {x + 30, 20}}, attributes) + label({x + 36, 24}, name);
    x += 200;
  }
  double top = kTop;
  for (int joint = 0; joint < kJoints; ++joint, top += kPanel + kGap) {
    double most = 0;
    for (const Instant& i : instants) most = std::max(most, 1.1 * std::abs(i.measured[joint]));
    const Panel panel{top, most};
    text += label({kLeft, top - 8}, "torque of J" + std::to_string(joint + 1) + ", N m", "font-weight=\"bold\"");
    for (const double share : {-0.5, 0.0, 0.5}) {
      const Point left = panel.at(0, share * most), right = panel.at(Motion::kPeriod, share * most);
      text += line(left, right, stroke(kInk, 0.6, "opacity=\"0.5\""));
      text += label({left.x - 8, left.y + 4}, fixed(share * most, most < 10 ? 1 : 0), "text-anchor=\"end\"");
    }
    const auto predicted = [joint](const Unknowns& unknowns) {
      return [&unknowns, joint](const Instant& i) { return rows(i).row(joint).dot(unknowns); };
    };
    text += curve(
        panel, instants, style(kInk, 1, "opacity=\"0.8\""), [joint](const Instant& i) { return i.measured[joint]; });
    text += curve(panel, instants, style(kGuessed, 1.6), predicted(guessed));
    text += curve(panel, instants, style(kIdentified, 1.6), predicted(identified));
  }
  text += label({(kLeft + kRight) / 2, top}, "time [s], 0 to 10", "text-anchor=\"middle\"");
  return svg::document(kWidth, top + 14, "Torques of the PUMA 560, measured and predicted", text);
}

}  // namespace identification
