#include "view/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algorithm/catalogue/catalogue.h"
#include "driver/failure.h"
#include "support/index.h"
#include "view/canvas.h"

namespace robcogen::view {
namespace {

constexpr double kPaper = 640;   // pixels, of the robot and of the pattern
constexpr double kCaption = 34;  // pixels, of the title and of the legend
constexpr double kPlain = 280;   // pixels, of the paper of a plain drawing, of which kBorder is cut off at each side
constexpr double kBorder = 38;

// Colours of medium lightness, which stand out from both white and black.
constexpr const char* kStyle =
    "<style>text{font:12px sans-serif;fill:#7d7d7d}line,polygon,path{stroke-linecap:round;stroke-linejoin:round}"
    ".bar{stroke:#6d8fb5}.tip{stroke:#6d8fb5;stroke-opacity:.55}.base{fill:#8a8a8a;fill-opacity:.3;stroke:#8a8a8a}"
    ".turn{stroke:#d08a2e;stroke-width:2.5}.slide{stroke:#a06cc0;stroke-width:2.5}.hub{fill:#d08a2e}"
    ".ball{fill:#d08a2e;fill-opacity:.4;stroke:#d08a2e;stroke-width:2}.sledge{fill:#a06cc0}.x{stroke:#d9534f}.y{stroke:"
    "#4a9f4f}.z{stroke:#4a86d8}.x,.y,.z{stroke-width:2}"
    ".joint{fill:#b87820;font-style:italic}.frame{fill:#7d7d7d}.title{font-size:15px}"
    ".cell{fill:#6d8fb5}.grid{fill:none;stroke:#8a8a8a;stroke-opacity:.5}</style>\n";

std::array<double, 3> origin(const Pose& pose) {
  return {pose[0][3], pose[1][3], pose[2][3]};
}

// The point at this distance along an axis of the pose.
std::array<double, 3> along(const Pose& pose, std::size_t axis, double distance) {
  std::array<double, 3> p = origin(pose);
  for (std::size_t i = 0; i < 3; ++i) p[i] += distance * pose[i][axis];
  return p;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// A centre of mass as in technical drawings: a disc whose quarters alternate.
std::string centre_of_mass(double r) {
  const std::string all = fmt::format("{0:.1f}", r);
  return fmt::format(
      "<circle r=\"{0}\" fill=\"#9a9a9a\" fill-opacity=\".25\" stroke=\"#7d7d7d\"/>"
      "<path d=\"M0 0V-{0}A{0} {0} 0 0 1 {0} 0ZM0 0V{0}A{0} {0} 0 0 1 -{0} 0Z\" fill=\"#7d7d7d\"/>",
      all);
}

struct Drawing {
  const ViewedRobot& robot;
  const Posture& posture;
  Canvas canvas;
  double length = 1;                     // of the robot: the largest distance of a frame from the base
  double width = 6;                      // pixels, of bars
  std::vector<const Pose*> joints = {};  // of joint frames

  const Pose& link(int l) const { return posture.frames[static_cast<std::size_t>(l)]; }
  const Pose& joint(std::size_t j) const { return *joints[j]; }
};

void add_base(Drawing& d) {
  const double r = 0.06 * d.length;
  const Pose& base = d.link(0);
  std::vector<Point> corners;
  for (const auto& [x, y] : {std::pair(-r, -r), std::pair(r, -r), std::pair(r, r), std::pair(-r, r)}) {
    Point p = along(base, 0, x);
    for (std::size_t i = 0; i < 3; ++i) p[i] += y * base[i][1];
    corners.push_back(p);
  }
  d.canvas.polygon(corners, "class=\"base\"", -0.01 * d.length);
}

// `joint` is an index of the model, `index` the place in the list of joints.
void add_joint(Drawing& d, int joint, std::size_t index) {
  const model::KinematicTree& tree = d.robot.library.tree;
  const model::JointType type = tree.joints[at(joint)].type;
  const bool turns = model::turns(type);
  const Pose& parent = d.link(model::parent_link(tree, joint));
  const Pose& placed = d.joint(index);
  const Pose& child = d.link(model::child_link(tree, joint));
  const double half = 0.05 * d.length;
  const std::string bar = fmt::format("class=\"bar\" stroke-width=\"{:.1f}\"", d.width);
  if (distance(origin(parent), origin(placed)) > 1e-9) d.canvas.line(origin(parent), origin(placed), bar);
  const std::string axis = turns ? "class=\"turn\"" : "class=\"slide\"";
  if (type == model::JointType::spherical) {
    d.canvas.disc(origin(child), d.width * 1.2, "class=\"ball\"", 0.012 * d.length);
    return;
  }
  // Rails reach as far as the child has slid.
  if (distance(origin(placed), origin(child)) > 1e-9) d.canvas.line(origin(placed), origin(child), axis);
  const Point tip = along(child, 2, half);
  d.canvas.line(along(child, 2, turns ? -half / 2 : -half), tip, axis, 0.01 * d.length);
  for (const double side : {-1.0, 1.0}) {
    Point barb = along(child, 2, 0.7 * half);
    for (std::size_t i = 0; i < 3; ++i) barb[i] += side * 0.15 * half * (child[i][0] + child[i][1]);
    d.canvas.line(barb, tip, axis, 0.01 * d.length);
  }
  d.canvas.disc(origin(child), d.width * 0.75, turns ? "class=\"hub\"" : "class=\"sledge\"", 0.012 * d.length);
}

// A link without children reaches its farthest frame, or otherwise its centre of mass. Rays lead to other frames.
void add_tips(Drawing& d) {
  const model::KinematicTree& tree = d.robot.library.tree;
  const std::size_t link_count = at(tree.link_count());
  const std::string tip = fmt::format("class=\"tip\" stroke-width=\"{:.1f}\"", d.width * 0.6);
  std::vector<bool> carries_joint(link_count);
  for (const int j : model::independent_joints_first(tree)) carries_joint[at(model::parent_link(tree, j))] = true;
  std::vector<std::vector<Point>> ends_of(link_count);
  for (std::size_t f = 0; f < d.robot.frames.size(); ++f)
    if (d.robot.frames[f].kind == ViewedFrame::Kind::user)
      ends_of[static_cast<std::size_t>(d.robot.frames[f].link)].push_back(origin(d.posture.frames[f]));
  for (std::size_t l = 0; l < link_count; ++l) {
    const bool is_leaf = !carries_joint[l];
    std::vector<Point>& ends = ends_of[l];
    if (is_leaf && ends.empty() && d.posture.masses[l] > 0) ends.push_back(d.posture.centres[l]);
    const Point from = origin(d.posture.frames[l]);
    const auto farthest = std::max_element(ends.begin(), ends.end(), [&](const Point& p, const Point& q) {
      return distance(from, p) < distance(from, q);
    });
    for (auto end = ends.begin(); end != ends.end(); ++end)
      d.canvas.line(from, *end, is_leaf && end == farthest ? tip : "class=\"ray\"", -0.005 * d.length);
  }
}

// A disc that closes a loop, or a bar between frames that keep a distance.
void add_loop(Drawing& d, const ViewedLoop& loop) {
  const auto [from, to] = loop.frames;
  const Point a = origin(d.posture.frames[from]), b = origin(d.posture.frames[to]);
  if (distance(a, b) > 1e-6 * d.length)
    d.canvas.line(a, b, fmt::format("class=\"tip\" stroke-width=\"{:.1f}\"", d.width * 0.6));
  for (const Point& end : {a, b})
    d.canvas.disc(end, d.width * 0.5, "class=\"loop\" fill=\"#d08a2e\"", 0.012 * d.length);
}

void add_frame(Drawing& d, const Pose& pose, double size) {
  constexpr const char* kAxes[] = {"class=\"x\"", "class=\"y\"", "class=\"z\""};
  for (std::size_t a = 0; a < 3; ++a) d.canvas.line(origin(pose), along(pose, a, size), kAxes[a], 0.02 * d.length);
}

void add_masses(Drawing& d) {
  double total = 0;
  Point centre{};
  for (std::size_t l = 0; l < d.posture.masses.size(); ++l) {
    const double mass = d.posture.masses[l];
    if (!(mass > 0)) continue;
    d.canvas.symbol(d.posture.centres[l], centre_of_mass(4), 0.03 * d.length);
    total += mass;
    for (std::size_t i = 0; i < 3; ++i) centre[i] += mass * d.posture.centres[l][i];
  }
  if (total == 0) return;
  for (double& c : centre) c /= total;
  d.canvas.symbol(centre, centre_of_mass(8), 0.04 * d.length);
}

// The median distance from the origin of a link to the joints that it carries.
double median_bar(const Drawing& d) {
  std::vector<double> lengths;
  const model::KinematicTree& tree = d.robot.library.tree;
  const std::vector<int> joints = model::independent_joints_first(tree);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double l = distance(origin(d.link(model::parent_link(tree, joints[j]))), origin(d.joint(j)));
    if (l > 1e-9) lengths.push_back(l);
  }
  if (lengths.empty()) return d.length / 4;
  std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2), lengths.end());
  return lengths[lengths.size() / 2];
}

std::string robot_elements(const ViewedRobot& robot, const Posture& posture, const DrawingOptions& options) {
  Drawing d = {robot, posture, Canvas(options.azimuth, options.elevation)};
  const model::KinematicTree& tree = robot.library.tree;
  const std::vector<int> joints = model::independent_joints_first(tree);
  const auto is_first = [&](std::size_t j) { return tree.joints[at(joints[j])].is_first(); };
  d.joints.resize(joints.size());
  for (std::size_t f = 0; f < robot.frames.size(); ++f)
    if (robot.frames[f].kind == ViewedFrame::Kind::joint)
      d.joints[static_cast<std::size_t>(robot.frames[f].index)] = &posture.frames[f];
  for (std::size_t j = 0; j < d.joints.size(); ++j)
    if (!is_first(j)) d.joints[j] = d.joints[j - 1];
  d.length = 0;
  for (const Pose& pose : posture.frames)
    d.length = std::max(d.length, distance(origin(pose), origin(posture.frames[0])));
  if (d.length < 1e-9) d.length = 1;
  d.width = std::clamp(median_bar(d) / d.length * 30, 2.5, 9.0);
  add_base(d);
  add_tips(d);
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (is_first(j)) add_joint(d, joints[j], j);
  for (const ViewedLoop& loop : robot.loops) add_loop(d, loop);
  if (options.is_plain) return d.canvas.elements(0, 0, kPlain);
  add_frame(d, d.link(0), 0.12 * d.length);
  for (std::size_t f = 0; f < robot.frames.size(); ++f)
    if (robot.frames[f].kind == ViewedFrame::Kind::user) add_frame(d, posture.frames[f], 0.06 * d.length);
  add_masses(d);
  d.canvas.label(origin(d.link(0)), tree.links.front().name, "class=\"frame\"");
  for (std::size_t f = 0; f < robot.frames.size(); ++f)
    if (robot.frames[f].kind == ViewedFrame::Kind::user)
      d.canvas.label(origin(posture.frames[f]), robot.frames[f].name, "class=\"frame\"");
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (is_first(j))
      d.canvas.label(
          origin(d.link(model::child_link(tree, joints[j]))), tree.joints[at(joints[j])].declared_name(),
          "class=\"joint\"");
  return d.canvas.elements(0, kCaption, kPaper);
}

std::string pattern_elements(const Pattern& pattern, double x) {
  constexpr double kMaxNamed = 42;
  std::size_t longest = 0;
  for (const std::string& name : pattern.names) longest = std::max(longest, name.size());
  const double names = 20 + 6.2 * static_cast<double>(longest);
  const auto n = static_cast<double>(pattern.rows.size());
  const double room = kPaper - names - 30, cell = std::min(24.0, room / n);
  const bool is_named = n <= kMaxNamed;
  const double left = x + (is_named ? names : 20), top = kCaption + (is_named ? names : 20);
  std::string text = fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"title\">Joint-space inertia matrix: structural zeros are blank</text>\n",
      x + 20, kCaption - 12);
  int zeros = 0;
  for (std::size_t r = 0; r < pattern.rows.size(); ++r) {
    const double y = top + cell * static_cast<double>(r);
    if (is_named) {
      text += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" font-size=\"11\">{}</text>\n", left - 6,
          y + cell / 2 + 4, escaped(pattern.names[r]));
      text += fmt::format(
          "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" font-size=\"11\">{}</text>\n",
          left + cell * (static_cast<double>(r) + 0.5) + 4, top - 6, escaped(pattern.names[r]));
    }
    for (std::size_t c = 0; c < pattern.rows.size(); ++c) {
      if (!pattern.rows[r][c])
        ++zeros;
      else
        text += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"cell\"/>\n",
            left + cell * static_cast<double>(c) + 0.5, y + 0.5, cell - 1, cell - 1);
    }
  }
  text += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"grid\"/>\n", left, top, cell * n,
      cell * n);
  return text + fmt::format(
                    "<text x=\"{:.1f}\" y=\"{:.1f}\">{} of {} elements are zero in every position</text>\n", left,
                    top + cell * n + 20, zeros, pattern.rows.size() * pattern.rows.size());
}

}  // namespace

Pattern inertia_pattern(const driver::Model& model) {
  const driver::Robot& robot = *model.robot();
  const auto functions = algorithm::functions(robot.tree, robot.desired, "joint_space_inertia");
  if (functions.empty())
    throw driver::Failure{
        driver::wrong_input,
        fmt::format(
            "{}: error: robot '{}' has no joint-space inertia matrix: it has no mass properties [no-inertia]",
            model.file.string(), robot.tree.name)};
  const symbolic::OutputArray& H = functions.front().program.outputs.front();
  Pattern pattern;
  if (robot.tree.floating_base)
    for (const char* name : {"wx", "wy", "wz", "vx", "vy", "vz"}) pattern.names.push_back(std::string("base ") + name);
  for (const int j : robot.tree.coordinates())
    pattern.names.push_back(robot.tree.joints[static_cast<std::size_t>(j)].name);
  const auto n = static_cast<std::size_t>(H.rows);
  for (std::size_t r = 0; r < n; ++r) {
    std::vector<bool> row;
    for (std::size_t c = 0; c < n; ++c) {
      const symbolic::Operand& o = H.values[r + c * n];
      row.push_back(
          !symbolic::is_constant(o) ||
          !functions.front().program.constants[static_cast<std::size_t>(o.index)].is_zero());
    }
    pattern.rows.push_back(std::move(row));
  }
  return pattern;
}

std::string draw(const ViewedRobot& robot, const Posture& posture, const DrawingOptions& options) {
  if (options.is_plain)
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0:.0f} {0:.0f} {1:.0f} {1:.0f}\" "
               "width=\"{1:.0f}\" "
               "height=\"{1:.0f}\" fill=\"none\">\n<title>{2}</title>\n",
               kBorder, kPlain - 2 * kBorder, escaped(robot.library.title())) +
           kStyle + robot_elements(robot, posture, options) + "</svg>\n";
  const double width = options.pattern ? 2 * kPaper : kPaper, height = kPaper + 2 * kCaption;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "fill=\"none\">\n",
      width, height);
  const std::string name = escaped(robot.library.title());
  text += fmt::format("<title>{}</title>\n", name) + kStyle;
  text += fmt::format("<text x=\"20\" y=\"{:.1f}\" class=\"title\">{}</text>\n", kCaption - 12, name);
  text += robot_elements(robot, posture, options);
  if (options.pattern) text += pattern_elements(*options.pattern, kPaper);
  return text + fmt::format(
                    "<text x=\"20\" y=\"{:.1f}\">blue: links; orange: axes of revolute joints{}; violet: prismatic "
                    "joints; quartered discs: centres of mass</text>\n</svg>\n",
                    height - 14, !robot.library.tree.spherical_joints().empty() ? " and spherical joints" : "");
}

}  // namespace robcogen::view
