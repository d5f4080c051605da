#include "algorithm/kinematics/collision_check.h"

#include <vector>

#include "algorithm/kinematics/frame_poses.h"
#include "algorithm/spatial/trace.h"
#include "support/index.h"
#include "symbolic/cut_outputs.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

enum Output { kParts, kGroups, kSpheres };

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
  std::vector<Expression> parts, groups, spheres;
  const auto place = [&](int link, const model::Ball& ball, std::vector<Expression>& centers) {
    const PathPose& pose = poses[at(link)];
    Vector3 center;
    for (std::size_t k = 0; k < 3; ++k) center.element[k] = trace.graph.constant(ball.center[k]);
    const Vector3 placed = pose.position + multiply(pose.rotation, center);
    centers.insert(centers.end(), placed.element.begin(), placed.element.end());
  };
  for (const model::CollisionTree::Part& part : shapes.parts) {
    trace.section(tree.links[at(part.link)].name, "sphere around link ", "");
    place(part.link, part.ball, parts);
    for (int g = part.first; g < part.first + part.count; ++g) {
      const model::CollisionTree::Group& group = shapes.groups[at(g)];
      trace.section(group.name, "spheres of ", "");
      place(part.link, group.ball, groups);
      for (int k = group.first; k < group.first + group.count; ++k)
        place(part.link, shapes.spheres[at(k)].ball, spheres);
    }
  }
  const auto output = [&](const char* array, const std::vector<Expression>& centers) {
    trace.output(array, Role::matrix, 3, static_cast<int>(centers.size()) / 3, centers);
  };
  output("parts", parts);
  output("groups", groups);
  output("spheres", spheres);
  return trace.program(name);
}

symbolic::Stages in_stages(const symbolic::Program& program, const model::CollisionTree& shapes) {
  symbolic::OutputElements parts;
  add_columns(parts, kParts, 0, static_cast<int>(shapes.parts.size()));
  std::vector<symbolic::StageOnDemand> groups, spheres;
  for (const model::CollisionTree::Part& part : shapes.parts) {
    if (part.count > 1) add_columns(groups.emplace_back().elements, kGroups, part.first, part.count);
    for (int g = part.first; g < part.first + part.count; ++g)
      if (const model::CollisionTree::Group& group = shapes.groups[at(g)]; group.count > 1)
        add_columns(spheres.emplace_back().elements, kSpheres, group.first, group.count);
  }
  groups.insert(groups.end(), spheres.begin(), spheres.end());
  return symbolic::cut_outputs(program, {parts}, groups);
}

}  // namespace robcogen::algorithm
