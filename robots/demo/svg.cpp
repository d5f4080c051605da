#include "svg.h"

#include <charconv>

namespace svg {

std::string fixed(double value, int digits) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr;
  return {buffer, end};
}

std::string px(double value) {
  return fixed(value, 1);
}

std::string line(Point a, Point b, const std::string& style) {
  return "<line x1=\"" + px(a.x) + "\" y1=\"" + px(a.y) + "\" x2=\"" + px(b.x) + "\" y2=\"" + px(b.y) + "\" " + style +
         "/>\n";
}

std::string polyline(const std::vector<Point>& points, const std::string& style) {
  std::string text = "<polyline points=\"";
  for (const Point& p : points) text += px(p.x) + "," + px(p.y) + " ";
  return text + "\" " + style + "/>\n";
}

std::string circle(Point centre, double radius, const std::string& style) {
  return "<circle cx=\"" + px(centre.x) + "\" cy=\"" + px(centre.y) + "\" r=\"" + px(radius) + "\" " + style + "/>\n";
}

std::string label(Point at, const std::string& text, const std::string& style) {
  return "<text x=\"" + px(at.x) + "\" y=\"" + px(at.y) + "\" " + style + ">" + text + "</text>\n";
}

std::string stroke(const char* colour, double width, const std::string& more) {
  return std::string("stroke=\"") + colour + "\" stroke-width=\"" + px(width) + "\" " + more;
}

std::string fill(const char* colour) {
  return std::string("fill=\"") + colour + "\"";
}

std::string document(double width, double height, const std::string& title, const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(width) + " " + px(height) +
         "\" font-family=\"sans-serif\" font-size=\"13\" " + fill(kInk) + ">\n<title>" + title + "</title>\n" +
         content + "</svg>\n";
}

}  // namespace svg
