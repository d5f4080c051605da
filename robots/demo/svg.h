// Elements of SVG pictures. Lengths are in pixels, y points downwards; `style` holds further attributes.
#pragma once

#include <string>
#include <vector>

namespace svg {

// A middle tone with a contrast of at least 4 on white and on nearly black.
inline constexpr const char* kInk = "#7a7a7a";

struct Point {
  double x, y;
};

// The value with this number of decimal places, in any locale.
std::string fixed(double value, int digits);
std::string px(double value);

std::string line(Point a, Point b, const std::string& style);
std::string polyline(const std::vector<Point>& points, const std::string& style);
std::string circle(Point centre, double radius, const std::string& style);
std::string label(Point at, const std::string& text, const std::string& style = "");

// Attributes.
std::string stroke(const char* colour, double width, const std::string& more = "");
std::string fill(const char* colour);

// The whole file; no background.
std::string document(double width, double height, const std::string& title, const std::string& content);

}  // namespace svg
