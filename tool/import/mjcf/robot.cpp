// Chooses the robot among the bodies of a scene.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "import/mjcf/read.h"
#include "support/index.h"

namespace robcogen::import::from_mjcf {

namespace {

class Chooser {
 public:
  Chooser(const Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {
    const std::vector<Body>& bodies = document.bodies;
    trees_.resize(bodies.size());
    for (std::size_t b = 1; b < bodies.size(); ++b) {
      const Body& body = bodies[b];
      trees_[b] = body.parent == 0 ? b : trees_[at(body.parent)];
      const std::size_t tree = trees_[b];
      if (body.floats()) floating_.push_back(b);
      if (body.joints.empty() || bodies[tree].floats()) continue;
      if (standing_.empty() || standing_.back() != tree) standing_.push_back(tree);
    }
  }

  // The only robot of the document.
  Robot only() {
    if (floating_.empty()) return standing_on_world(0);
    const std::size_t base = floating_.front();
    if (floating_.size() > 1) {
      report_second(floating_[1], document_.bodies[floating_[1]].free_joint->place);
    } else if (!standing_.empty()) {
      const auto moves = [&](const Body& b) { return !b.joints.empty() && trees_[index_of(b)] == standing_.front(); };
      const Body& body = *std::find_if(document_.bodies.begin(), document_.bodies.end(), moves);
      report_second(index_of(body), body.joints.front().name.place);
    }
    return floating(base);
  }

  // The robot of this name.
  Robot named(const std::string& name) {
    if (name == "world" && !standing_.empty()) return standing_on_world(0);
    for (const std::size_t b : floating_)
      if (label_of(document_, b) == name) return floating(b);
    for (const std::size_t b : standing_)
      if (label_of(document_, b) == name) return standing_on_world(b);
    report_unknown(name);
    return standing_on_world(0);
  }

 private:
  std::size_t index_of(const Body& body) const { return static_cast<std::size_t>(&body - document_.bodies.data()); }

  Robot floating(std::size_t base) const {
    Robot robot{base, {}};
    for (const std::size_t tree : trees_) robot.has.push_back(tree == base);
    return robot;
  }

  // The trees that the world carries, or the one whose root is `only`, and the bodies that cannot move.
  Robot standing_on_world(std::size_t only) const {
    const auto contains = [](const std::vector<std::size_t>& all, std::size_t tree) {
      return std::find(all.begin(), all.end(), tree) != all.end();
    };
    Robot robot;
    for (const std::size_t tree : trees_)
      robot.has.push_back(!contains(floating_, tree) && (only == 0 || tree == only || !contains(standing_, tree)));
    return robot;
  }

  std::vector<std::string> candidates() const {
    std::vector<std::string> names;
    for (std::size_t b = 1; b < trees_.size(); ++b)
      if (trees_[b] == b && (document_.bodies[b].floats() || std::count(standing_.begin(), standing_.end(), b) > 0))
        names.push_back(label_of(document_, b));
    if (standing_.size() > 1) names.emplace_back("world");
    return names;
  }

  std::string list() const {
    constexpr std::size_t kShown = 6;
    std::vector<std::string> names = candidates();
    std::string rest;
    if (names.size() > kShown) {
      rest = fmt::format(" and {} more", names.size() - kShown);
      names.resize(kShown);
    }
    return fmt::format("'{}'{}", fmt::join(names, "', '"), rest);
  }

  void report_second(std::size_t body, const Place& place) {
    const std::size_t base = floating_.front();
    Diagnostic& error = diagnostics_.error(
        "second-robot", place,
        fmt::format(
            "body '{}' moves, but is not part of the robot whose base is '{}'", label_of(document_, body),
            label_of(document_, base)));
    error.notes.push_back(
        {document_.bodies[base].free_joint->place, "this free joint makes the base of the robot floating"});
    error.hint = fmt::format("choose one robot by --robot (ROBOT in CMake): {}", list());
  }

  void report_unknown(const std::string& name) {
    const auto source = std::make_shared<const Source>("--robot", name);
    Diagnostic& error = diagnostics_.error(
        "unknown-robot", {source, {0, name.size()}}, fmt::format("the model has no robot '{}'", name));
    const std::vector<std::string> names = candidates();
    error.hint = did_you_mean(name, names);
    if (error.hint.empty())
      error.hint =
          names.empty() ? "nothing in it moves" : fmt::format("a robot is named by its first body: {}", list());
  }

  const Document& document_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> trees_;                // by body: the body of the world that carries it; 0 for the world
  std::vector<std::size_t> floating_, standing_;  // trees that move
};

}  // namespace

std::string label_of(const Document& document, std::size_t body) {
  const std::string& name = document.bodies[body].name.text;
  return name.empty() ? fmt::format("body_{}", body) : name;
}

Robot choose_robot(const Document& document, const std::string& name, Diagnostics& diagnostics) {
  Chooser chooser(document, diagnostics);
  return name.empty() ? chooser.only() : chooser.named(name);
}

}  // namespace robcogen::import::from_mjcf
