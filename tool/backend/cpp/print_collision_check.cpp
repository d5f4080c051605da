// <name>/collision_check.h: the spheres of a robot's collision shapes, and functions that tell whether they touch.
#include <algorithm>
#include <utility>

#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/member_array.h"
#include "backend/cpp/printers.h"
#include "support/index.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

using model::CollisionTree;

// A stage as a function: what it places is an element of an array, and of a list of the tables.
struct PlacingStage {
  const symbolic::Program* program;
  const char* placed;  // `parts`, `groups` or `spheres`
  int place;           // of the part, or of the group
  std::string what;

  bool places_parts() const { return std::string(placed) == "parts"; }
  std::string name() const { return std::string(placed) + (places_parts() ? "" : "_" + std::to_string(place)); }
};

// In the order of CollisionCheck::stages.
std::vector<PlacingStage> placing_stages(const Api& api, const backend::CollisionCheck& check) {
  std::vector<PlacingStage> list;
  const auto add = [&](const char* placed, std::size_t place, const std::string& what) {
    list.push_back({&check.stages.list[list.size()].program, placed, static_cast<int>(place), what});
  };
  const CollisionTree& shapes = check.shapes;
  const auto name_of = [&](const CollisionTree::Part& part) { return api.library->tree.links[at(part.link)].name; };
  add("parts", 0, "The spheres around all parts");
  for (std::size_t k = 0; k < shapes.parts.size(); ++k)
    if (shapes.parts[k].count > 1) add("groups", k, "The spheres around the groups of " + name_of(shapes.parts[k]));
  for (std::size_t g = 0; g < shapes.groups.size(); ++g)
    if (shapes.groups[g].count > 1) add("spheres", g, "The spheres of a group: " + shapes.groups[g].name);
  return list;
}

// The arrays of a stage, under the names that all stages give them.
std::vector<KernelArray> arrays_of(const Kernel& kernel, const PlacingStage& stage) {
  std::vector<KernelArray> list = {
      {"q", false, false}, {symbolic::kWorkspace, stage.places_parts(), false}, {stage.placed, true, false}};
  for (KernelArray& array : list)
    array.used = std::any_of(kernel.parameters.begin(), kernel.parameters.end(), [&](const KernelArray& parameter) {
      return parameter.name == array.name && parameter.used;
    });
  return list;
}

std::string print_stages(const std::vector<PlacingStage>& stages) {
  std::vector<std::string> list;
  for (const PlacingStage& stage : stages) {
    const Kernel kernel = lower(*stage.program, stage.program->name);
    list.push_back(
        comment(stage.what + ".") + signature("void " + stage.name(), arrays_of(kernel, stage), " noexcept {") +
        body(kernel) + "}\n");
  }
  return paragraphs(list);
}

// A list of names that fits behind numbers in a line.
std::string shortened(const std::string& names) {
  constexpr std::size_t kMost = 80;
  if (names.size() <= kMost) return names;
  const std::size_t end = names.rfind(", ", kMost);
  return end == std::string::npos ? names : names.substr(0, end) + ", …";
}

template <class Spheres>
std::string group(const Spheres& g) {
  return "{" + std::to_string(g.first) + ", " + std::to_string(g.count) + ", " + print_double(g.ball.radius) + "}";
}

std::string print_tables(const Api& api, const backend::CollisionCheck& check) {
  const CollisionTree& shapes = check.shapes;
  const auto number = [](int k) { return std::to_string(k); };
  std::vector<std::string> parts, part_names, groups, group_names, radii, pairs;
  for (const CollisionTree::Part& part : shapes.parts) {
    parts.push_back(group(part));
    part_names.push_back(api.library->tree.links[at(part.link)].name);
  }
  for (const CollisionTree::Group& g : shapes.groups) {
    groups.push_back(group(g));
    group_names.push_back(shortened(g.name));
  }
  for (const CollisionTree::Sphere& sphere : shapes.spheres) radii.push_back(print_double(sphere.ball.radius));
  for (const auto& [a, b] : shapes.pairs) pairs.push_back("{" + number(a) + ", " + number(b) + "}");
  return "  static constexpr int kPartCount = " + number(static_cast<int>(parts.size())) +
         ", kGroupCount = " + number(static_cast<int>(groups.size())) +
         ", kSphereCount = " + number(static_cast<int>(radii.size())) +
         ", kWorkspace = " + number(std::max(check.stages.workspace, 1)) + ";\n" +
         comment(
             "Of each part of a link, the first of its groups, their number, and the radius (m) of the sphere around "
             "them.",
             2) +
         member_array("robcogen::collision::Group", "kParts", parts, part_names) +
         "  // The same of each group and its spheres.\n" +
         member_array("robcogen::collision::Group", "kGroups", groups, group_names) + "  // Of the spheres, m.\n" +
         member_array("double", "kRadii", radii) + "  // Parts that are checked against each other.\n" +
         member_array("robcogen::collision::Pair", "kPairs", pairs);
}

// A function that places what is inside of one link or group: nothing if that has one member only.
std::string print_choice(const std::vector<PlacingStage>& stages, const std::string& placed, const char* of) {
  std::string cases;
  for (const PlacingStage& stage : stages)
    if (stage.placed == placed)
      cases += "      case " + std::to_string(stage.place) + ":\n        kernel::collision_check::" + stage.name() +
               "(q, workspace, " + placed + ");\n        break;\n";
  const std::string name = "place_" + placed, of_name = of;
  if (cases.empty())
    return "  template <class Scalar>\n" +
           declaration("static void " + name, {"int", "const Scalar*", "const Scalar*", "Scalar*"}, " noexcept {}", 2);
  return "  template <class Scalar>\n" +
         declaration(
             "[[gnu::noinline]] static void " + name,
             {"int " + of_name, "const Scalar* q", "const Scalar* workspace", "Scalar* " + placed}, " noexcept {", 2) +
         "    switch (" + of_name + ") {\n" + cases + "      default:\n        break;\n    }\n  }\n";
}

std::string print_members(const std::vector<PlacingStage>& stages) {
  return "  // Places the spheres around the parts.\n"
         "  template <class Scalar>\n"
         "  static void place_parts(const Scalar* q, Scalar* workspace, Scalar* parts) noexcept {\n"
         "    kernel::collision_check::parts(q, workspace, parts);\n  }\n"
         "  // Place the spheres around the groups of a part, and those of a group, if there are several.\n" +
         print_choice(stages, "groups", "part") + print_choice(stages, "spheres", "group");
}

std::string print_functions(const Api& api, const std::string& scalar) {
  const std::string vector =
      model::has_own_positions(api.library->tree) ? "PositionVector<" + scalar + ">" : "JointVector<" + scalar + ">";
  return "// Whether shapes of links overlap whose pair is checked.\n"
         "inline bool self_collision(const " +
         vector +
         "& q) noexcept {\n"
         "  return robcogen::self_collision<CollisionShapes>(q.data());\n}\n\n"
         "// The same, or whether a shape touches an obstacle: obstacles(x, y, z, radius) tells whether a sphere does, "
         "whose\n// centre (m) is in base axes.\n"
         "template <class Obstacles>\n"
         "bool in_collision(const " +
         vector +
         "& q, const Obstacles& obstacles) noexcept {\n"
         "  return robcogen::in_collision<CollisionShapes>(q.data(), obstacles);\n}\n";
}

}  // namespace

std::string print_collision_check(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  if (!library.collision_check)
    return paragraphs(
        {banner(library, path, "no checks, because the robot has no collision shapes, or parameters that move them"),
         "#pragma once\n"});
  const backend::CollisionCheck& check = *library.collision_check;
  const std::vector<PlacingStage> stages = placing_stages(api, check);
  const std::string shapes =
      (check.shapes.is_exact
           ? ""
           : comment("Shapes that are not spheres are rows of spheres that contain their capsules.")) +
      "struct CollisionShapes {\n" + print_tables(api, check) + "\n" + print_members(stages) + "};\n";
  const std::string kernels = print_stages(stages);
  std::vector<std::string> headers = {
      "\"robcogen/collision_check.h\"", "\"robcogen/sincos_of.h\"", "\"robcogen/version.h\""};
  if (kernels.find(kMagnitude) != std::string::npos) headers.push_back("\"robcogen/magnitude.h\"");
  if (kernels.find(kArcTangent) != std::string::npos) headers.push_back("\"robcogen/arc_tangent.h\"");
  const std::string single = library.has_single_precision ? in_namespace("f32", print_functions(api, "float")) : "";
  return paragraphs(
      {banner(library, path, "whether the robot touches itself or an obstacle"), "#pragma once\n",
       includes({"<array>", "<cmath>"}), includes(headers), includes({quoted(header_path(folder(library), "types"))}),
       runtime_check(api), in_namespace(api.space + "::kernel::collision_check", kernels),
       in_namespace(api.space, paragraphs({shapes, print_functions(api, "double"), single}))});
}

}  // namespace robcogen::backend::cpp
