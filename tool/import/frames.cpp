#include "import/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "import/parameters.h"

namespace robcogen::import {

using language::AxisStep;
using language::FramesHeader;
using language::Name;
using model::ParameterKind;
using model::Quantity;

namespace {

// Frames and amounts of a document of either language.
class FramesReader {
 public:
  FramesReader(std::shared_ptr<const Source> source, const FramesHeader& header, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics), reader_(source_, diagnostics, PlainName::variable) {
    for (const language::ParameterGroup& group : header.groups) reader_.declare_group(group);
    if (!header.frames) return;
    is_listed_ = true;
    for (const Name& name : *header.frames) list(name);
  }

  void declare_names_in(const std::vector<AxisStep>& steps) {
    for (const AxisStep& step : steps) reader_.declare_names_in(*step.amount);
  }

  // Reports a frame that is not in the document's list. If there is no list, every frame that is named exists.
  void use(const Name& name) {
    if (index_.contains(name.text)) return;
    if (is_listed_) {
      std::vector<std::string> known;
      for (const auto& [frame, declared] : index_) known.push_back(frame);
      diagnostics_
          .error("unknown-frame", place(name.span), fmt::format("frame '{}' is not in the list of frames", name.text))
          .hint = did_you_mean(name.text, known);
    }
    index_.insert({name.text, place(name.span)});
    frames_.push_back(name.text);
  }

  Quantity read(const AxisStep& step) {
    return reader_.read(*step.amount, step.rotation ? ParameterKind::angle : ParameterKind::length);
  }

  // Reports a user-given name that was used before.
  void name(const Name& name) {
    const auto [earlier, is_new] = names_.insert({name.text, place(name.span)});
    if (is_new) return;
    diagnostics_.error("duplicate-name", place(name.span), fmt::format("the name '{}' is given twice", name.text))
        .notes.push_back({earlier->second, "first given here"});
  }

  Place place(const Span& span) const { return {source_, span}; }
  // In the order of the list, or of first use if there is no list.
  const std::vector<std::string>& frames() const { return frames_; }
  const QuantityReader& quantities() const { return reader_; }

 private:
  void list(const Name& name) {
    const auto [earlier, is_new] = index_.insert({name.text, place(name.span)});
    if (is_new) {
      frames_.push_back(name.text);
      return;
    }
    diagnostics_.error("duplicate-frame", place(name.span), fmt::format("frame '{}' is listed twice", name.text))
        .notes.push_back({earlier->second, "first listed here"});
  }

  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  QuantityReader reader_;
  bool is_listed_ = false;
  std::vector<std::string> frames_;
  std::map<std::string, Place> index_;
  std::map<std::string, Place> names_;
};

// A disjoint-set forest of the frames that the motions so far connect: each frame leads to the representative of its
// tree.
class Forest {
 public:
  // Returns false if the frames are already connected.
  bool connect(const std::string& a, const std::string& b) {
    const std::string root_a = root(a), root_b = root(b);
    if (root_a == root_b) return false;
    parents_[root_a] = root_b;
    return true;
  }

 private:
  std::string root(std::string frame) {
    for (auto parent = parents_.find(frame); parent != parents_.end(); parent = parents_.find(frame))
      frame = parent->second;
    return frame;
  }

  std::map<std::string, std::string> parents_;
};

class MotionsReader {
 public:
  MotionsReader(const language::motion::Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics), reader_(document.source, document.header, diagnostics) {
    for (const language::motion::Motion& motion : document.motions) reader_.declare_names_in(motion.steps);
  }

  model::RigidMotions read() {
    model::RigidMotions motions;
    motions.name = document_.header.model.text;
    motions.convention = document_.convention == language::motion::Convention::local ? model::MotionConvention::local
                                                                                     : model::MotionConvention::fixed;
    for (const language::motion::Motion& motion : document_.motions) {
      check(motion);
      motions.motions.push_back(read(motion));
    }
    mention_empty_motions();
    motions.parameters = reader_.quantities().parameters();
    reader_.quantities().report_accidents();
    motions.variables = reader_.quantities().variables();
    motions.frames = reader_.frames();
    return motions;
  }

 private:
  void check(const language::motion::Motion& motion) {
    reader_.use(motion.from);
    reader_.use(motion.to);
    if (motion.name) reader_.name(*motion.name);
    const Place place = reader_.place(motion.span);
    const std::string &from = motion.from.text, &to = motion.to.text;
    if (from == to) {
      diagnostics_.error("self-motion", place, fmt::format("this motion goes from frame '{}' to itself", from));
      return;
    }
    const auto [earlier, is_new] = pairs_.insert({std::minmax(from, to), place});
    if (!is_new) {
      diagnostics_
          .error("duplicate-motion", place, fmt::format("a second motion connects frames '{}' and '{}'", from, to))
          .notes.push_back({earlier->second, "the first one is here"});
    } else if (!forest_.connect(from, to)) {
      diagnostics_
          .error(
              "motion-loop", place,
              fmt::format(
                  "this motion closes a loop: other motions already connect frame '{}' to frame '{}'", from, to))
          .hint = "remove the motion that follows from the others";
    }
  }

  model::Motion read(const language::motion::Motion& motion) {
    model::Motion result = {motion.from.text, motion.to.text, {}, motion.name ? motion.name->text : ""};
    for (const AxisStep& step : motion.steps)
      result.steps.push_back({step.rotation, static_cast<model::Axis>(step.axis), reader_.read(step)});
    return result;
  }

  // Reports all of them in one note: the document of a robot has many such motions, for joints at the origin of their
  // links.
  void mention_empty_motions() {
    const auto is_empty = [](const language::motion::Motion& m) { return m.steps.empty(); };
    const auto& motions = document_.motions;
    const auto first = std::find_if(motions.begin(), motions.end(), is_empty);
    if (first == motions.end()) return;
    const auto count = std::count_if(first, motions.end(), is_empty);
    diagnostics_.note(
        "empty-motion", reader_.place(first->span),
        count == 1
            ? fmt::format("this motion has no steps: frames '{}' and '{}' coincide", first->from.text, first->to.text)
            : fmt::format("{} motions have no steps: their frames coincide; this is the first", count));
  }

  const language::motion::Document& document_;
  Diagnostics& diagnostics_;
  FramesReader reader_;
  std::map<std::pair<std::string, std::string>, Place> pairs_;
  Forest forest_;
};

}  // namespace

std::optional<model::RigidMotions> rigid_motions(const language::motion::Document& document, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  model::RigidMotions motions = MotionsReader(document, diagnostics).read();
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return motions;
}

std::optional<model::CoordinateTransforms> coordinate_transforms(
    const language::transforms::Document& document,
    Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  FramesReader reader(document.source, document.header, diagnostics);
  for (const language::transforms::Transform& transform : document.transforms)
    reader.declare_names_in(transform.primitives);
  model::CoordinateTransforms result;
  result.name = document.header.model.text;
  result.position = document.position == language::transforms::MovedFramePosition::left
                        ? model::MovedFramePosition::left
                        : model::MovedFramePosition::right;
  std::map<FrameNames, Place> pairs;
  for (const language::transforms::Transform& transform : document.transforms) {
    reader.use(transform.left);
    reader.use(transform.right);
    if (transform.name) reader.name(*transform.name);
    const std::string &left = transform.left.text, &right = transform.right.text;
    const Place place = reader.place(transform.span);
    const auto [earlier, is_new] = pairs.insert({{left, right}, place});
    if (left == right) {
      diagnostics.error("self-transform", place, fmt::format("this transform maps frame '{}' to itself", left));
    } else if (!is_new) {
      diagnostics
          .error("duplicate-transform", place, fmt::format("transform '{{{}}}_X_{{{}}}' is given twice", left, right))
          .notes.push_back({earlier->second, "the first one is here"});
    }
    model::CoordinateTransform read = {left, right, {}, transform.name ? transform.name->text : ""};
    for (const AxisStep& step : transform.primitives)
      read.primitives.push_back({step.rotation, static_cast<model::Axis>(step.axis), reader.read(step)});
    result.transforms.push_back(std::move(read));
  }
  result.parameters = reader.quantities().parameters();
  reader.quantities().report_accidents();
  result.variables = reader.quantities().variables();
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return result;
}

}  // namespace robcogen::import
