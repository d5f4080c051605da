// <name>/collision_check.h: the spheres of a robot's collision shapes, and functions that tell whether they touch.
#include <algorithm>
#include <utility>

#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "support/index.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

using model::CollisionTree;

// The arrays of a stage, under the names that all stages give them.
std::vector<KernelArray> arrays_of(const Kernel& kernel, bool is_inside) {
  std::vector<KernelArray> list = {{"q", false, false}, {symbolic::kWorkspace, !is_inside, false}};
  if (!is_inside) list.push_back({"links", true, false});
  if (is_inside)
    for (const char* name : {"bodies", "spheres"}) list.push_back({name, true, false});
  for (KernelArray& array : list)
    array.used = std::any_of(kernel.parameters.begin(), kernel.parameters.end(), [&](const KernelArray& parameter) {
      return parameter.name == array.name && parameter.used;
    });
  return list;
}

// Stages in turn are parts of one function; the others run only where something is near.
std::string print_stages(const Api& api, const backend::CollisionCheck& check) {
  std::vector<std::string> list;
  const std::size_t count = check.shapes.links.size();
  for (std::size_t k = 0; k < check.stages.list.size(); ++k) {
    const bool is_inside = k >= count;
    const std::string& name = api.library->tree.links[at(check.shapes.links[k % count].link)].name;
    Kernel kernel = lower(check.stages.list[k].program, check.stages.list[k].program.name);
    const std::string specifiers = is_inside ? "[[gnu::noinline]] void inside_" : "[[gnu::always_inline]] inline void around_";
    const std::string head = specifiers + std::to_string(k % count);
    list.push_back(
        comment((is_inside ? "The spheres of link " : "The sphere around link ") + name + ".") +
        signature(head, arrays_of(kernel, is_inside), kernel.lines.empty() ? " noexcept {}" : " noexcept {") +
        (kernel.lines.empty() ? "" : body(kernel) + "}\n"));
  }
  return paragraphs(list);
}

std::string array(const std::string& type, const std::string& name, const std::vector<std::string>& items,
                  const std::vector<std::string>& remarks = {}) {
  const std::string head = "static constexpr std::array<" + type + ", " + std::to_string(items.size()) + "> " + name;
  // Two pairs of braces: around the class, and around the array in it.
  if (items.empty()) return "  " + head + " = {};\n";
  std::string text = "  " + head + " = {{\n";
  std::string row;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!remarks.empty()) {
      text += "      " + items[i] + ",  // " + remarks[i] + "\n";
    } else {
      if (6 + row.size() + items[i].size() + 2 > kColumns) text += "      " + std::exchange(row, "") + "\n";
      row += (row.empty() ? "" : " ") + items[i] + ",";
    }
  }
  if (!row.empty()) text += "      " + row + "\n";
  return text + "  }};\n";
}

template <class Group>
std::string group(const Group& g) {
  return "{" + std::to_string(g.first) + ", " + std::to_string(g.count) + ", " + print_double(g.ball.radius) + "}";
}

std::string print_tables(const Api& api, const backend::CollisionCheck& check) {
  const CollisionTree& shapes = check.shapes;
  const auto number = [](int k) { return std::to_string(k); };
  std::vector<std::string> links, link_names, bodies, body_names, radii, link_pairs, body_pairs;
  for (const CollisionTree::Link& link : shapes.links) {
    links.push_back(group(link));
    link_names.push_back(api.library->tree.links[at(link.link)].name);
  }
  for (const CollisionTree::Body& body : shapes.bodies) {
    bodies.push_back(group(body));
    body_names.push_back(body.name);
  }
  for (const CollisionTree::Sphere& sphere : shapes.spheres) radii.push_back(print_double(sphere.ball.radius));
  for (const CollisionTree::LinkPair& pair : shapes.link_pairs)
    link_pairs.push_back(
        "{" + number(pair.a) + ", " + number(pair.b) + ", " + number(pair.first) + ", " + number(pair.count) + "}");
  for (const auto& [a, b] : shapes.body_pairs) body_pairs.push_back("{" + number(a) + ", " + number(b) + "}");
  return "  static constexpr int kLinkCount = " + number(static_cast<int>(links.size())) + ", kBodyCount = " +
         number(static_cast<int>(bodies.size())) + ", kSphereCount = " + number(static_cast<int>(radii.size())) +
         ", kWorkspace = " + number(std::max(check.stages.workspace, 1)) + ";\n" +
         "  // Of each link, the first of its bodies, their number, and the radius (m) of the sphere around them.\n" +
         array("robcogen::collision::Group", "kLinks", links, link_names) +
         "  // The same of each body and its spheres.\n" +
         array("robcogen::collision::Group", "kBodies", bodies, body_names) + "  // Of the spheres, m.\n" +
         array("double", "kRadii", radii) + "  // Links, and pairs of their bodies that are checked.\n" +
         array("robcogen::collision::LinkPair", "kLinkPairs", link_pairs) +
         array("robcogen::collision::Pair", "kBodyPairs", body_pairs);
}

std::string print_members(std::size_t count) {
  std::string place, inside;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string number = std::to_string(k);
    place += "    kernel::collision_check::around_" + number + "(q, workspace, links);\n    if (placed(" + number +
             ")) return true;\n";
    inside += "      case " + number + ":\n        return kernel::collision_check::inside_" + number +
              "(q, workspace, bodies, spheres);\n";
  }
  return "  // Places the spheres around the links, each of which `placed` may say to be the last one.\n"
         "  template <class Scalar, class Placed>\n"
         "  static bool place(const Scalar* q, Scalar* workspace, Scalar* links, const Placed& placed) noexcept {\n" +
         place +
         "    return false;\n  }\n"
         "  // Places the spheres of a link.\n"
         "  template <class Scalar>\n"
         "  static void place_inside(\n"
         "      int link, const Scalar* q, const Scalar* workspace, Scalar* bodies, Scalar* spheres) noexcept {\n"
         "    switch (link) {\n" +
         inside + "      default:\n        break;\n    }\n  }\n";
}

std::string print_functions(const Api& api) {
  const bool has_positions = model::has_own_positions(api.library->tree);
  const std::string vector = has_positions ? "PositionVector<Scalar>" : "JointVector<Scalar>";
  return "// Whether shapes of links overlap whose pair is checked.\n"
         "template <class Scalar>\n"
         "bool self_collision(const " + vector + "& q) noexcept {\n"
         "  return robcogen::self_collision<CollisionShapes>(q.data());\n}\n\n"
         "// The same, or whether a shape touches an obstacle: obstacles(x, y, z, radius) tells whether a sphere does, "
         "whose\n// centre (m) is in base axes.\n"
         "template <class Scalar, class Obstacles>\n"
         "bool in_collision(const " + vector + "& q, const Obstacles& obstacles) noexcept {\n"
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
  const std::string shapes =
      (check.shapes.is_exact ? ""
                             : comment("Shapes that are not spheres are rows of spheres that contain their capsules.")) +
      "struct CollisionShapes {\n" + print_tables(api, check) + "\n" + print_members(check.shapes.links.size()) + "};\n";
  const std::string stages = print_stages(api, check);
  std::vector<std::string> headers = {"\"robcogen/collision_check.h\"", "\"robcogen/sincos_of.h\"",
                                      "\"robcogen/version.h\""};
  if (stages.find(kMagnitude) != std::string::npos) headers.push_back("\"robcogen/magnitude.h\"");
  if (stages.find(kArcTangent) != std::string::npos) headers.push_back("\"robcogen/arc_tangent.h\"");
  return paragraphs(
      {banner(library, path, "whether the robot touches itself or an obstacle"), "#pragma once\n",
       includes({"<array>", "<cmath>"}), includes(headers),
       includes({quoted(header_path(folder(library), "types"))}), runtime_check(api),
       in_namespace(api.space + "::kernel::collision_check", stages),
       in_namespace(api.space, paragraphs({shapes, print_functions(api)}))});
}

}  // namespace robcogen::backend::cpp
