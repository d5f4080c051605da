// Functions of collision shapes.
#include <string>
#include <vector>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/kinematics/collision.h"
#include "model/collision.h"

namespace robcogen::algorithm::catalogue {
namespace {

template <bool are_spheres>
std::vector<std::string> names_of_shapes(const Subject& s) {
  std::vector<std::string> result;
  for (const model::Capsule& capsule : model::capsules(s.tree))
    if (capsule.is_sphere() == are_spheres) result.push_back(capsule.name);
  return result;
}

template <bool are_spheres>
int count_of_shapes(const Subject& s) {
  return static_cast<int>(names_of_shapes<are_spheres>(s).size());
}

template <bool are_spheres>
bool has_any(const Subject& s) {
  return count_of_shapes<are_spheres>(s) > 0;
}

bool has_few_pairs(const Subject& s) {
  const std::size_t pairs = model::collision_pairs(s.tree, model::capsules(s.tree)).size();
  return pairs > 0 && pairs <= model::kMaxCollisionPairs;
}

}  // namespace

Declarations collision_declarations() {
  return {
      {"collision",
       {{.name = "collision_spheres",
         .exists = has_any<true>,
         .summary = {"Collision shapes that are spheres: their centres (m) in base axes, a column for each, and their "
                     "radii (m), which are constant."},
         .signature = {{q}, {matrix("centers", rows<3>, count_of_shapes<true>), value("radii", count_of_shapes<true>)}},
         .program = {by<collision_spheres>},
         .labels = names_of_shapes<true>},
        {.name = "collision_capsules",
         .exists = has_any<false>,
         .summary =
             {"Collision shapes that are not spheres, as capsules: the two ends (m) of their axes in base axes, a "
              "column of six rows for each, and their radii (m), which are constant. A capsule is itself; "
              "cylinders, boxes and meshes are inside theirs."},
         .signature = {{q}, {matrix("ends", rows<6>, count_of_shapes<false>), value("radii", count_of_shapes<false>)}},
         .program = {by<collision_capsules>},
         .labels = names_of_shapes<false>},
        {.name = "self_distance",
         .exists = has_few_pairs,
         .summary =
             {"Smallest distance (m) between spheres and capsules of links whose pair is checked; negative where "
              "two overlap."},
         .signature = {{q}, {{"distance", Role::distance, rows<1>}}},
         .program = {by<self_distance>}}}}};
}

}  // namespace robcogen::algorithm::catalogue
