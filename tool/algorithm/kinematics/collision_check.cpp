#include "algorithm/kinematics/collision_check.h"

#include <vector>

#include "algorithm/kinematics/frame_poses.h"
#include "algorithm/spatial/trace.h"
#include "support/index.h"
#include "symbolic/cut_outputs.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

enum Output { kLinks, kGroups, kSpheres };

void add_columns(symbolic::OutputElements& elements, Output output, int first, int count) {
  for (int k = 3 * first; k < 3 * (first + count); ++k) elements.push_back({output, k});
}

}  // namespace

symbolic::Program collision_check(
    const model::KinematicTree& tree,
    const model::CollisionTree& shapes,
    const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const std::vector<PathPose> poses = link_poses(trace, q);
  std::vector<Expression> links, groups, spheres;
  const auto place = [&](int link, const model::Ball& ball, std::vector<Expression>& centers) {
    const PathPose& pose = poses[at(link)];
    Vector3 center;
    for (std::size_t k = 0; k < 3; ++k) center.element[k] = trace.graph.constant(ball.center[k]);
    const Vector3 placed = pose.position + multiply(pose.rotation, center);
    centers.insert(centers.end(), placed.element.begin(), placed.element.end());
  };
  for (const model::CollisionTree::Link& link : shapes.links) {
    trace.section(tree.links[at(link.link)].name, "sphere around link ", "");
    place(link.link, link.ball, links);
    for (int g = link.first; g < link.first + link.count; ++g) {
      const model::CollisionTree::Group& group = shapes.groups[at(g)];
      trace.section(group.name, "spheres of ", "");
      place(link.link, group.ball, groups);
      for (int k = group.first; k < group.first + group.count; ++k) place(link.link, shapes.spheres[at(k)].ball, spheres);
    }
  }
  const auto output = [&](const char* array, const std::vector<Expression>& centers) {
    trace.output(array, Role::matrix, 3, static_cast<int>(centers.size()) / 3, centers);
  };
  output("links", links);
  output("groups", groups);
  output("spheres", spheres);
  return trace.program(name);
}

symbolic::Stages in_stages(const symbolic::Program& program, const model::CollisionTree& shapes) {
  std::vector<symbolic::OutputElements> in_turn;
  std::vector<symbolic::StageOnDemand> groups, spheres;
  for (std::size_t k = 0; k < shapes.links.size(); ++k) {
    const model::CollisionTree::Link& link = shapes.links[k];
    add_columns(in_turn.emplace_back(), kLinks, static_cast<int>(k), 1);
    if (link.count > 1) {
      groups.push_back({{}, static_cast<int>(k)});
      add_columns(groups.back().elements, kGroups, link.first, link.count);
    }
    for (int g = link.first; g < link.first + link.count; ++g) {
      const model::CollisionTree::Group& group = shapes.groups[at(g)];
      if (group.count == 1) continue;
      spheres.push_back({{}, static_cast<int>(k)});
      add_columns(spheres.back().elements, kSpheres, group.first, group.count);
    }
  }
  groups.insert(groups.end(), spheres.begin(), spheres.end());
  return symbolic::cut_outputs(program, in_turn, groups);
}

}  // namespace robcogen::algorithm
