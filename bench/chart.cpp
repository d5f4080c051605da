#include "chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace robcogen::bench {

namespace {

// Pixels.
constexpr double kWidth = 860, kLeft = 74, kRight = 24, kPanelHeight = 230, kPanelGap = 44, kLegendTop = 24;
constexpr double kLegendLine = 24, kTick = 5, kMarker = 5, kNameDistance = 21;

// Colours of medium lightness: the contrast to white and to black is at least 3, that of text 4.3.
constexpr const char* kText = "#797979";
constexpr std::array<const char*, 8> kColours = {"#e8590c", "#2f7fd8", "#2b9348", "#a259d9",
                                                 "#a87b00", "#d6409f", "#0f8f8f", "#7d7d00"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// Common to all panels.
struct Axes {
  double most_freedom = 1;
  double low = 1, high = 10;           // ns, powers of ten
  std::map<int, std::string> robots;   // by degrees of freedom
  std::vector<std::string> libraries;  // in the order of their first appearance
};

Axes axes(const std::vector<ChartPanel>& panels) {
  Axes a;
  double least = HUGE_VAL, most = 0;
  std::map<int, std::vector<std::string>> robots;
  for (const ChartPanel& panel : panels) {
    for (const ChartSeries& series : panel.series) {
      if (std::find(a.libraries.begin(), a.libraries.end(), series.name) == a.libraries.end()) {
        a.libraries.push_back(series.name);
      }
      for (const ChartPoint& p : series.points) {
        least = std::min(least, p.nanoseconds);
        most = std::max(most, p.nanoseconds);
        a.most_freedom = std::max<double>(a.most_freedom, p.degrees_of_freedom);
        std::vector<std::string>& names = robots[p.degrees_of_freedom];
        if (std::find(names.begin(), names.end(), p.robot) == names.end()) names.push_back(p.robot);
      }
    }
  }
  if (most > 0) {
    a.low = std::pow(10, std::floor(std::log10(least)));
    a.high = std::pow(10, std::ceil(std::log10(most)));
    if (a.high <= a.low) a.high = 10 * a.low;
  }
  for (const auto& [freedom, names] : robots) {
    std::string& all = a.robots[freedom];
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  }
  return a;
}

// Room for the names of robots, which are written upwards to the right, and the name of the axis.
double names_height(const Axes& a) {
  constexpr double kLeast = 120, kMargin = 52, kOfCharacter = 4.9;
  std::size_t longest = 0;
  for (const auto& [freedom, names] : a.robots) longest = std::max(longest, names.size());
  return std::max(kLeast, kMargin + kOfCharacter * static_cast<double>(longest));
}

double x_of(const Axes& a, double freedom) {
  return kLeft + (kWidth - kLeft - kRight) * freedom / (a.most_freedom + 1);
}

double y_of(const Axes& a, double top, double nanoseconds) {
  return top + kPanelHeight * (1 - log_position(nanoseconds, a.low, a.high));
}

// A closed shape with radius kMarker about a point: a circle, a polygon or a star, depending on the series.
std::string marker(std::size_t series, double x, double y, bool hollow, std::string_view content) {
  const char* colour = kColours[series % kColours.size()];
  const std::string style =
      fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\" class=\"marker\"", hollow ? "none" : colour, colour);
  struct Shape {
    int corners;
    double turn;   // of the first corner from the top, as a fraction of the circle
    double inner;  // of a star: radius between the corners
    double size;   // so that all shapes look equally large
  };
  static constexpr std::array<Shape, 7> kShapes = {
      {{4, 0.125, 0, 1.25},
       {3, 0, 0, 1.3},
       {4, 0, 0, 1.3},
       {3, 0.5, 0, 1.3},
       {5, 0, 0, 1.15},
       {5, 0, 0.45, 1.5},
       {6, 0, 0, 1.1}}};
  if (series == 0) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" {}>{}</circle>\n", x, y, kMarker, style, content);
  }
  const Shape& shape = kShapes[(series - 1) % kShapes.size()];
  const int count = shape.inner > 0 ? 2 * shape.corners : shape.corners;
  std::string points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * (shape.turn + static_cast<double>(i) / count);
    const double radius = kMarker * shape.size * (shape.inner > 0 && i % 2 == 1 ? shape.inner : 1);
    points +=
        fmt::format("{}{:.2f},{:.2f}", i == 0 ? "" : " ", x + radius * std::sin(angle), y - radius * std::cos(angle));
  }
  return fmt::format("<polygon points=\"{}\" {}>{}</polygon>\n", points, style, content);
}

std::string text(
    double x,
    double y,
    const std::string& anchor,
    const std::string& content,
    const std::string& more = "") {
  return fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more, escaped(content));
}

std::string line(double x1, double y1, double x2, double y2, double opacity) {
  return fmt::format(
      "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" stroke-opacity=\"{}\"/>\n", x1, y1,
      x2, y2, kText, opacity);
}

std::string duration(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:g} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:g} µs", nanoseconds / 1e3);
  return fmt::format("{:g} ms", nanoseconds / 1e6);
}

// The names of the libraries in as many lines as they need; sets `bottom` to where the legend ends.
std::string legend(const Axes& a, double& bottom) {
  // Generous, because the font is unknown.
  const auto width = [](const std::string& name) { return 40 + 8.0 * static_cast<double>(name.size()); };
  std::string drawing;
  double x = kLeft, y = kLegendTop;
  for (std::size_t i = 0; i < a.libraries.size(); ++i) {
    const std::string& name = a.libraries[i];
    if (x > kLeft && x + width(name) > kWidth - kRight) {
      x = kLeft;
      y += kLegendLine;
    }
    drawing += marker(i, x + kMarker, y - 4.5, false, "") + text(x + 18, y, "start", name);
    x += width(name);
  }
  y += kLegendLine;
  drawing += text(
      kLeft, y, "start", "filled markers: fixed base; hollow markers: floating base, its 6 degrees of freedom counted");
  bottom = y;
  return drawing;
}

std::string grid(const Axes& a, double top) {
  const double right = kWidth - kRight, bottom = top + kPanelHeight;
  std::string drawing;
  for (double decade = a.low; decade <= a.high * 1.001; decade *= 10) {
    const double y = y_of(a, top, decade);
    drawing += line(kLeft - kTick, y, right, y, 0.45) + text(kLeft - 9, y + 4.5, "end", duration(decade));
    for (int i = 2; i < 10 && decade < a.high / 1.001; ++i) {
      const double minor = y_of(a, top, decade * i);
      drawing += line(kLeft, minor, right, minor, 0.12);
    }
  }
  for (const auto& [freedom, names] : a.robots) {
    drawing += line(x_of(a, freedom), top, x_of(a, freedom), bottom + kTick, 0.25);
  }
  return drawing + line(kLeft, top, kLeft, bottom, 0.8) + line(kLeft, bottom, right, bottom, 0.8);
}

// The text below the lowest panel: degrees of freedom and the robots that have them.
std::string names(const Axes& a, double top) {
  std::vector<double> places;
  for (const auto& [freedom, robots] : a.robots) places.push_back(x_of(a, freedom));
  const std::vector<double> labels = spread(places, kNameDistance);
  std::string drawing;
  std::size_t i = 0;
  for (const auto& [freedom, robots] : a.robots) {
    drawing += line(places[i], top + kTick, labels[i], top + 14, 0.45);
    drawing += text(
        labels[i] + 4, top + 24, "end", fmt::format("{}, {}", robots, freedom),
        fmt::format(" transform=\"rotate(-45 {:.2f} {:.2f})\"", labels[i] + 4, top + 24));
    ++i;
  }
  return drawing + text(
                       (kLeft + kWidth - kRight) / 2, top + names_height(a), "middle",
                       "robot, degrees of freedom (linear scale)");
}

std::string curve(const Axes& a, double top, const ChartSeries& series) {
  const std::size_t number =
      static_cast<std::size_t>(std::find(a.libraries.begin(), a.libraries.end(), series.name) - a.libraries.begin());
  std::vector<ChartPoint> points = series.points;
  std::stable_sort(points.begin(), points.end(), [](const ChartPoint& l, const ChartPoint& r) {
    return l.degrees_of_freedom < r.degrees_of_freedom;
  });
  std::string path, markers;
  for (const ChartPoint& p : points) {
    const double x = x_of(a, p.degrees_of_freedom), y = y_of(a, top, p.nanoseconds);
    path += fmt::format("{}{:.2f},{:.2f}", path.empty() ? "" : " ", x, y);
    markers += marker(
        number, x, y, p.floating_base,
        fmt::format(
            "<title>{}</title>", escaped(fmt::format("{}, {}: {:.4g} ns", series.name, p.robot, p.nanoseconds))));
  }
  return fmt::format(
             "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path,
             kColours[number % kColours.size()], number == 0 ? 2.2 : 1.3) +
         markers;
}

std::string panel(const Axes& a, const ChartPanel& content, double top) {
  const double middle = top + kPanelHeight / 2;
  std::string drawing = grid(a, top);
  drawing += text(kLeft, top - 10, "start", content.title, " font-weight=\"bold\"");
  drawing += text(
      16, middle, "middle", "time of a call (logarithmic)",
      fmt::format(" transform=\"rotate(-90 16 {:.2f})\"", middle));
  // The first series is drawn last, above all others.
  for (auto series = content.series.rbegin(); series != content.series.rend(); ++series) {
    drawing += curve(a, top, *series);
  }
  return drawing;
}

}  // namespace

double log_position(double value, double low, double high) {
  return std::log(value / low) / std::log(high / low);
}

std::vector<double> spread(std::vector<double> places, double distance) {
  for (std::size_t i = 1; i < places.size(); ++i) places[i] = std::max(places[i], places[i - 1] + distance);
  return places;
}

std::string svg(const std::vector<ChartPanel>& panels) {
  const Axes a = axes(panels);
  double top = 0;
  std::string drawing = legend(a, top);
  for (const ChartPanel& content : panels) {
    top += kPanelGap;
    drawing += panel(a, content, top);
    top += kPanelHeight;
  }
  drawing += names(a, top);
  const double height = top + names_height(a) + 14;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" height=\"{1:.0f}\" "
             "font-family=\"system-ui, sans-serif\" font-size=\"13\" fill=\"{2}\">\n"
             "<title>Time of a call against degrees of freedom</title>\n",
             kWidth, height, kText) +
         drawing + "</svg>\n";
}

}  // namespace robcogen::bench
