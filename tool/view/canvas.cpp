#include "view/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace robcogen::view {
namespace {

constexpr double kMargin = 46;                  // pixels around the points, for labels
constexpr double kCharacter = 6.4, kLine = 13;  // pixels of a label

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Rounded to tenths of a pixel, without negative zero.
std::string pixels(double value) {
  const double rounded = std::round(value * 10) / 10;
  return fmt::format("{:.1f}", rounded == 0 ? 0.0 : rounded);
}

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// The number of characters in UTF-8.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// The places for the label of a point, best first: the offset of its baseline, and its anchor.
struct LabelPlace {
  double dx = 0, dy = 0;
  const char* anchor = "start";
};
constexpr LabelPlace kPlaces[] = {{10, -6, "start"},  {10, 12, "start"}, {-10, -6, "end"},   {-10, 12, "end"},
                                  {0, -14, "middle"}, {0, 22, "middle"}, {14, -20, "start"}, {14, 26, "start"},
                                  {-14, -20, "end"},  {-14, 26, "end"}};

Box box_of(double x, double y, const LabelPlace& place, double width) {
  const std::string anchor = place.anchor;
  const double left = x + place.dx - (anchor == "end" ? width : anchor == "middle" ? width / 2 : 0);
  return {left, y + place.dy - kLine + 3, left + width, y + place.dy + 3};
}

}  // namespace

Canvas::Canvas(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  near_ = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  right_ = {-std::sin(a), std::cos(a), 0};
  down_ = {std::sin(e) * std::cos(a), std::sin(e) * std::sin(a), -std::cos(e)};
}

Point Canvas::seen(const Point& p) const {
  return {dot(right_, p), dot(down_, p), dot(near_, p)};
}

void Canvas::add(Item item, double nearer) {
  for (const Point& p : item.points) item.depth += dot(near_, p) / static_cast<double>(item.points.size());
  item.depth += nearer;
  items_.push_back(std::move(item));
}

void Canvas::line(const Point& from, const Point& to, std::string attributes, double nearer) {
  add({Item::Kind::line, {from, to}, 0, std::move(attributes)}, nearer);
}

void Canvas::disc(const Point& centre, double pixels, std::string attributes, double nearer) {
  add({Item::Kind::disc, {centre}, pixels, std::move(attributes)}, nearer);
}

void Canvas::polygon(const std::vector<Point>& corners, std::string attributes, double nearer) {
  add({Item::Kind::polygon, corners, 0, std::move(attributes)}, nearer);
}

void Canvas::symbol(const Point& centre, std::string elements, double nearer) {
  add({Item::Kind::symbol, {centre}, 0, std::move(elements)}, nearer);
}

void Canvas::label(const Point& at, std::string text, std::string attributes) {
  labels_.push_back({at, std::move(text), std::move(attributes)});
}

std::string Canvas::elements(double x, double y, double size) const {
  double low[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()},
         high[2] = {-low[0], -low[0]};
  for (const Item& item : items_) {
    for (const Point& p : item.points) {
      const Point s = seen(p);
      for (std::size_t i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], s[i]);
        high[i] = std::max(high[i], s[i]);
      }
    }
  }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], 1e-9});
  const double scale = (size - 2 * kMargin) / extent;
  const auto screen = [&](const Point& p) {
    const Point s = seen(p);
    return std::array<double, 2>{
        x + size / 2 + scale * (s[0] - (low[0] + high[0]) / 2), y + size / 2 + scale * (s[1] - (low[1] + high[1]) / 2)};
  };
  std::vector<const Item*> order;
  for (const Item& item : items_) order.push_back(&item);
  std::stable_sort(order.begin(), order.end(), [](const Item* a, const Item* b) { return a->depth < b->depth; });
  std::string text;
  for (const Item* item : order) {
    const auto p = screen(item->points.front());
    if (item->kind == Item::Kind::line) {
      const auto to = screen(item->points.back());
      text += fmt::format(
          "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", pixels(p[0]), pixels(p[1]), pixels(to[0]),
          pixels(to[1]), item->text);
    } else if (item->kind == Item::Kind::disc) {
      text += fmt::format(
          "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", pixels(p[0]), pixels(p[1]), pixels(item->radius), item->text);
    } else if (item->kind == Item::Kind::symbol) {
      text += fmt::format("<g transform=\"translate({} {})\">{}</g>\n", pixels(p[0]), pixels(p[1]), item->text);
    } else {
      std::string corners;
      for (const Point& corner : item->points) {
        const auto c = screen(corner);
        corners += (corners.empty() ? "" : " ") + pixels(c[0]) + "," + pixels(c[1]);
      }
      text += fmt::format("<polygon points=\"{}\" {}/>\n", corners, item->text);
    }
  }
  const Box paper = {x, y, x + size, y + size};
  std::vector<Box> taken;
  for (const Label& label : labels_) {
    const auto p = screen(label.at);
    for (const LabelPlace& place : kPlaces) {
      const Box box = box_of(p[0], p[1], place, kCharacter * static_cast<double>(length(label.text)));
      const bool is_inside =
          box.left >= paper.left && box.right <= paper.right && box.top >= paper.top && box.bottom <= paper.bottom;
      if (!is_inside || std::any_of(taken.begin(), taken.end(), [&](const Box& b) { return b.meets(box); })) continue;
      taken.push_back(box);
      text += fmt::format(
          "<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" {}>{}</text>\n", pixels(p[0] + place.dx), pixels(p[1] + place.dy),
          place.anchor, label.attributes, escaped(label.text));
      break;
    }
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

}  // namespace robcogen::view
