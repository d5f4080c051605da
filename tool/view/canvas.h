// Lines, discs and labels in space, seen from a direction, as SVG.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace robcogen::view {

using Point = std::array<double, 3>;

// Each label is placed near its point, where it hides no other. Labels that find no place are left out; earlier labels
// take precedence.
class Canvas {
 public:
  // The direction to the viewer in degrees: azimuth from x to y, elevation towards z.
  Canvas(double azimuth, double elevation);

  // `attributes` are put into the element: class and style. Elements nearer to the viewer are drawn later.
  void line(const Point& from, const Point& to, std::string attributes, double nearer = 0);
  void disc(const Point& centre, double pixels, std::string attributes, double nearer = 0);
  void polygon(const std::vector<Point>& corners, std::string attributes, double nearer = 0);
  // Elements that are drawn about the origin and moved to the point.
  void symbol(const Point& centre, std::string elements, double nearer = 0);
  void label(const Point& at, std::string text, std::string attributes);

  // The elements, fitted into a square of this many pixels, whose corner is at (x, y).
  std::string elements(double x, double y, double pixels) const;

 private:
  struct Item {
    enum class Kind { line, disc, polygon, symbol };
    Kind kind = Kind::line;
    std::vector<Point> points;
    double radius = 0;  // pixels
    std::string text;
    double depth = 0;  // larger is nearer
  };
  struct Label {
    Point at;
    std::string text, attributes;
  };

  Point seen(const Point& p) const;  // right, down, towards the viewer
  void add(Item item, double nearer);

  Point right_, down_, near_;
  std::vector<Item> items_;
  std::vector<Label> labels_;
};

// The text, escaped for SVG.
std::string escaped(const std::string& text);

}  // namespace robcogen::view
