#include "algorithm/kinematics/frame_poses.h"

#include <vector>

#include "algorithm/kinematics/path.h"
#include "model/rigid_motions.h"

namespace robcogen::algorithm {
namespace {

using model::Frame;
using model::KinematicTree;

// Advances from one frame to another along their path.
void advance_along(
    Trace& trace,
    const model::MotionGraph& motions,
    const Frame& from,
    const Frame& to,
    const std::vector<Expression>& q,
    PathPose& here) {
  for (const PathSegment& segment : path_between(trace.tree, motions, {from, to}))
    advance(here, pose_of(trace, segment, q));
}

// Forgets how the rotation was reached, except for its last factor, which merges with a turn about the same axis: the
// history would grow along a chain, and with it the time of each step.
void forget(PathPose& here) {
  constexpr std::ptrdiff_t kAngles = 8;
  const auto shorten = [](auto& list, std::ptrdiff_t count) {
    if (std::ssize(list) > count) list.erase(list.begin(), list.end() - count);
  };
  shorten(here.before, 1);
  shorten(here.planes, 1);
  shorten(here.angles, kAngles);
}

class Placing {
 public:
  Placing(Trace& trace, const std::vector<Expression>& q)
      : trace_(trace),
        q_(q),
        motions_(model::motions_of(trace.tree)),
        graph_(motions_),
        links_(trace.tree.links.size()),
        frames_(trace.tree.frames()) {}

  const std::vector<PathPose>& links() {
    place_links();
    return links_;
  }

  std::vector<Expression> poses() {
    place_links();
    std::vector<Expression> values;
    for (const Frame& frame : frames_) {
      PathPose here = links_[at(trace_.tree.link_of(frame))];
      if (frame.kind == Frame::Kind::link) {
        here = links_[at(frame.index)];
      } else {
        trace_.section(frame.name, "frame ", "");
        advance_along(trace_, graph_, link_frame(trace_.tree.link_of(frame)), frame, q_, here);
      }
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t r = 0; r < 3; ++r) values.push_back(here.rotation[r][c]);
      for (std::size_t r = 0; r < 3; ++r) values.push_back(here.position[r]);
    }
    return values;
  }

 private:
  Trace& trace_;
  const std::vector<Expression>& q_;
  model::RigidMotions motions_;
  model::MotionGraph graph_;
  std::vector<PathPose> links_;  // in the base; not of repeated links
  std::vector<Frame> frames_;

  Frame link_frame(int link) const {
    return {Frame::Kind::link, link, model::implicit_frame_name(trace_.tree.links[at(link)].name)};
  }

  // Parents first, whatever their order in the document.
  void place_links() {
    const KinematicTree& tree = trace_.tree;
    links_[0] = start(trace_.graph);
    std::vector<int> open = {0};
    while (!open.empty()) {
      const int link = open.back();
      open.pop_back();
      for (const int child : children_of(link)) {
        trace_.section(tree.links[at(child)].name, "link ", "");
        PathPose here = links_[at(link)];
        advance_along(trace_, graph_, link_frame(link), link_frame(child), q_, here);
        forget(here);
        name_path_pose(here, tree.links[at(child)].name);
        links_[at(child)] = std::move(here);
        open.push_back(child);
      }
    }
  }

  // The links that joints connect to this one, past the repeated links of spherical joints.
  std::vector<int> children_of(int link) const {
    std::vector<int> children;
    for (const int joint : trace_.tree.links[at(link)].child_joints) {
      int child = trace_.tree.joints[at(joint)].child;
      while (trace_.tree.links[at(child)].is_repeated)
        child = trace_.tree.joints[at(trace_.tree.links[at(child)].child_joints.front())].child;
      children.push_back(child);
    }
    return children;
  }
};

}  // namespace

std::vector<PathPose> link_poses(Trace& trace, const std::vector<Expression>& q) {
  return Placing(trace, q).links();
}

symbolic::Program frame_poses(const KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", symbolic::Role::joint_position);
  const std::vector<Expression> poses = Placing(trace, q).poses();
  trace.output("poses", symbolic::Role::value, 12, static_cast<int>(poses.size()) / 12, poses);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
