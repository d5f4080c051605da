#include "chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace robcogen::bench {
namespace {

// Coordinates are written with two decimals.
constexpr double kPixels = 0.011;

std::vector<ChartPanel> example() {
  const std::vector<ChartSeries> series = {
      {"RobCoGen", {{"Leg", 2, false, 10}, {"Arm", 4, false, 100}, {"Dog", 6, true, 1000}}},
      {"A < \"B\" & C", {{"Leg", 2, false, 250}, {"Dog", 6, true, 9000}}}};
  return {{"inverse dynamics", series}, {"forward dynamics", series}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

// The text between < and > of all tags, in order.
std::vector<std::string> tags(const std::string& xml) {
  std::vector<std::string> result;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    result.push_back(xml.substr(at + 1, xml.find('>', at) - at - 1));
  }
  return result;
}

std::string name(const std::string& tag) {
  return tag.substr(0, tag.find(' '));
}

// The value of an attribute; empty if there is none.
std::string attribute(const std::string& tag, const std::string& key) {
  const std::string start = " " + key + "=\"";
  const std::size_t at = tag.find(start);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + start.size();
  return tag.substr(begin, tag.find('"', begin) - begin);
}

// Whether the text after a tag's name consists of ` key="value"` only.
bool has_good_attributes(const std::string& tag) {
  std::size_t at = name(tag).size();
  while (at < tag.size()) {
    const std::size_t equals = tag.find("=\"", at);
    if (tag[at] != ' ' || equals == std::string::npos) return false;
    if (tag.find_first_of(" \"", at + 1) < equals) return false;
    const std::size_t end = tag.find('"', equals + 2);
    if (end == std::string::npos) return false;
    at = end + 1;
  }
  return true;
}

// The first fault of tags, attributes or text; empty for well-formed XML of the simple kind that is written here:
// elements, attributes in double quotes, entities, and no > except those of tags.
std::string fault(const std::string& xml) {
  if (count(xml, "<") != count(xml, ">")) return "a < or > of its own";
  std::size_t entities = 0;
  for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;"}) entities += count(xml, entity);
  if (entities != count(xml, "&")) return "an & of its own";
  std::vector<std::string> open;
  int roots = 0;
  for (std::string tag : tags(xml)) {
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "closes " + tag;
      open.pop_back();
      continue;
    }
    if (open.empty()) ++roots;
    const bool empty = tag.back() == '/';
    if (empty) tag.pop_back();
    if (!has_good_attributes(tag)) return "attributes of " + tag;
    if (!empty) open.push_back(name(tag));
  }
  if (!open.empty()) return "open: " + open.back();
  return roots == 1 && xml.front() == '<' && xml.substr(xml.size() - 2) == ">\n" ? "" : "more than one element";
}

// The numeric values of an attribute of all circles, which are the markers of the first series, in the order of the
// drawing.
std::vector<double> circles(const std::string& xml, const std::string& key) {
  std::vector<double> values;
  for (const std::string& tag : tags(xml)) {
    if (name(tag) == "circle") values.push_back(std::strtod(attribute(tag, key).c_str(), nullptr));
  }
  return values;
}

TEST(Chart, LogarithmicScale) {
  EXPECT_DOUBLE_EQ(log_position(10, 10, 1000), 0);
  EXPECT_DOUBLE_EQ(log_position(100, 10, 1000), 0.5);
  EXPECT_DOUBLE_EQ(log_position(1000, 10, 1000), 1);
  EXPECT_DOUBLE_EQ(log_position(2, 1, 8), 1.0 / 3);
  EXPECT_LT(log_position(5, 10, 1000), 0);
}

TEST(Chart, NeighboursAreSpread) {
  EXPECT_EQ(spread({1, 2, 3, 50}, 10), (std::vector<double>{1, 11, 21, 50}));
  EXPECT_EQ(spread({1, 20}, 10), (std::vector<double>{1, 20}));
  EXPECT_TRUE(spread({}, 10).empty());
}

TEST(Chart, IsWellFormed) {
  EXPECT_EQ(fault(svg(example())), "");
  EXPECT_NE(fault("<a><b></a>\n"), "");
  EXPECT_NE(fault("<a>x < y</a>\n"), "");
  EXPECT_NE(fault("<a>x & y</a>\n"), "");
  EXPECT_NE(fault("<a b=c></a>\n"), "");
  EXPECT_NE(fault("<a b=\"c\"d></a>\n"), "");
  EXPECT_NE(fault("<a></a><b></b>\n"), "");
  EXPECT_EQ(fault("<a b=\"c\" d=\"e f\">x &amp; y<b/></a>\n"), "");
}

TEST(Chart, HasEverySeriesAndPoint) {
  const std::string drawing = svg(example());
  for (const char* library : {"RobCoGen", "A &lt; &quot;B&quot; &amp; C"}) {
    EXPECT_EQ(count(drawing, std::string(">") + library + "</text>"), 1) << "legend";
  }
  for (const char* point :
       {"RobCoGen, Leg: 10 ns", "RobCoGen, Arm: 100 ns", "RobCoGen, Dog: 1000 ns", "C, Dog: 9000 ns"}) {
    EXPECT_EQ(count(drawing, point), 2) << point << ", one a panel";
  }
  EXPECT_EQ(count(drawing, "class=\"marker\""), 2 * 5 + 2);  // two in the legend
  EXPECT_EQ(count(drawing, "<polyline"), 2 * 2);
  for (const char* label : {">inverse dynamics<", ">forward dynamics<", ">Leg, 2<", ">10 ns<", ">10 µs<"}) {
    EXPECT_GT(count(drawing, label), 0) << label;
  }
}

TEST(Chart, PlacesAreLinearInFreedomAndLogarithmicInTime) {
  const std::string drawing = svg(example());
  const std::vector<double> x = circles(drawing, "cx"), y = circles(drawing, "cy");
  ASSERT_EQ(x.size(), 7);  // one in the legend, three per panel
  for (const std::size_t first : {std::size_t{1}, std::size_t{4}}) {
    EXPECT_NEAR(x[first + 1] - x[first], x[first + 2] - x[first + 1], kPixels);
    EXPECT_GT(x[first + 1], x[first]);
    EXPECT_NEAR(y[first + 1] - y[first], y[first + 2] - y[first + 1], kPixels);
    EXPECT_LT(y[first + 1], y[first]);
  }
  EXPECT_GT(y[4], y[1]) << "the second panel is below the first";
}

TEST(Chart, FloatingBasesAreHollow) {
  const std::string drawing = svg(example());
  std::size_t hollow = 0;
  for (std::size_t at = drawing.find(", Dog:"); at != std::string::npos; at = drawing.find(", Dog:", at + 1)) {
    const std::size_t marker = drawing.rfind("<title>", at) - 1;
    hollow += attribute(drawing.substr(drawing.rfind('<', marker), marker), "fill") == "none" ? 1 : 0;
  }
  EXPECT_EQ(hollow, 4);
  EXPECT_EQ(count(drawing, "fill=\"none\""), 4 + 4) << "hollow markers and curves";
}

TEST(Chart, RobotsOfOneFreedomShareALabel) {
  const std::string drawing = svg({{"t", {{"s", {{"Left", 3, false, 10}, {"Right", 3, false, 30}}}}}});
  EXPECT_EQ(count(drawing, ">Left, Right, 3<"), 1);
}

TEST(Chart, TakesWhateverDataThereIs) {
  for (const std::vector<ChartPanel>& panels : std::vector<std::vector<ChartPanel>>{
           {},
           {{"nothing", {}}},
           {{"empty", {{"s", {}}}}},
           {{"one", {{"s", {{"Leg", 2, false, 100}}}}}},
           {{"still", {{"s", {{"Rock", 0, false, 1}}}}}}}) {
    const std::string drawing = svg(panels);
    EXPECT_EQ(fault(drawing), "");
    EXPECT_EQ(count(drawing, "nan") + count(drawing, "inf\""), 0) << drawing;
  }
}

// Relative luminance and contrast of the Web Content Accessibility Guidelines 2.1.
double luminance(const std::string& colour) {
  const auto channel = [&](std::size_t at) {
    const double c = static_cast<double>(std::strtol(colour.substr(at, 2).c_str(), nullptr, 16)) / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

double contrast(const std::string& a, const std::string& b) {
  const double light = std::max(luminance(a), luminance(b)), dark = std::min(luminance(a), luminance(b));
  return (light + 0.05) / (dark + 0.05);
}

// Graphics need a contrast of 3, large text too.
TEST(Chart, ColoursStandOutFromWhiteAndFromDark) {
  EXPECT_NEAR(contrast("#ffffff", "#000000"), 21, 1e-9);
  std::vector<ChartSeries> series;
  for (int i = 0; i < 8; ++i) series.push_back({std::string(1, static_cast<char>('a' + i)), {{"Leg", 2, false, 10}}});
  const std::string drawing = svg({{"t", series}});
  std::set<std::string> colours;
  for (const std::string& tag : tags(drawing)) {
    for (const char* key : {"fill", "stroke"}) {
      const std::string value = attribute(tag, key);
      if (!value.empty() && value != "none") colours.insert(value);
    }
  }
  EXPECT_EQ(colours.size(), 9) << "text and eight series";
  for (const std::string& c : colours) {
    for (const char* ground : {"#ffffff", "#0d1117", "#000000"})
      EXPECT_GE(contrast(c, ground), 3) << c << " on " << ground;
  }
}

}  // namespace
}  // namespace robcogen::bench
