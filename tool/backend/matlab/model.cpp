// The structs of constants and of parameters, and the overview of a package.
#include <algorithm>
#include <utility>
#include <variant>

#include "backend/common/constants.h"
#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

using Item = std::vector<Constant>;
using Items = std::vector<Item>;

// The member of this name, or that of a record in the item; nullptr if there is none.
const Constant* find(const Item& item, const std::string& name) {
  for (const Constant& member : item) {
    if (member.name == name) return &member;
    if (const auto* record = std::get_if<Record>(&member.value))
      for (const Item& row : *record)
        if (const Constant* const found = find(row, name)) return found;
  }
  return nullptr;
}

std::string one_based(int index) {
  return std::to_string(index + 1);
}

// The members of this name, one per item. Numbers that an item does not have are zero.
std::vector<std::string> texts(const Items& items, const std::string& member) {
  std::vector<std::string> result;
  for (const Item& item : items) {
    const Constant* const found = find(item, member);
    const auto* const text = found ? std::get_if<std::string>(&found->value) : nullptr;
    const auto* const index = found ? std::get_if<int>(&found->value) : nullptr;
    result.push_back(
        text    ? quoted(*text)
        : index ? one_based(*index)
                : number(found ? std::get<double>(found->value) : 0.0));
  }
  return result;
}

// `model.<field> = [a; b];`
std::string column(const std::string& field, const std::vector<std::string>& items) {
  if (items.empty()) return "  model." + field + " = zeros(0, 1);\n";
  std::vector<std::vector<std::string>> rows;
  for (const std::string& item : items) rows.push_back({item});
  return matrix("model." + field, rows);
}

// `model.<field> = {'a'; 'b'};`
std::string names(const std::string& field, const std::vector<std::string>& items) {
  if (items.empty()) return "  model." + field + " = cell(0, 1);\n";
  return wrapped("  model." + field + " = {", items, "};", ";");
}

// `model.<field> = […];`: these members below one another, one column per item.
std::string columns(
    const std::string& field,
    const Items& items,
    std::size_t rows,
    const std::vector<std::string>& members) {
  if (items.empty()) return "  model." + field + " = zeros(" + std::to_string(rows) + ", 0);\n";
  std::vector<std::vector<std::string>> cells(rows);
  for (const Item& item : items) {
    std::vector<double> numbers;
    for (const std::string& member : members)
      if (const Constant* const found = find(item, member))
        for (const double value : std::get<std::vector<double>>(found->value)) numbers.push_back(value);
    numbers.resize(rows);
    for (std::size_t r = 0; r < rows; ++r) cells[r].push_back(number(numbers[r]));
  }
  return matrix("model." + field, cells);
}

// Whether each joint is of this type.
std::string type_field(const std::string& field, const Items& joints, const std::string& type) {
  std::vector<std::string> flags = texts(joints, "type");
  for (std::string& flag : flags) flag = flag == quoted(type) ? "true" : "false";
  return column(field, flags);
}

// A field of a list: its name, and that of the member of its items.
using FieldNames = std::pair<const char*, const char*>;

std::string joint_fields(const Library& library, const Items& joints, const std::string& prefix = "") {
  std::string text = names(prefix + "joints", texts(joints, "name"));
  text += type_field(prefix + "is_revolute", joints, "revolute");
  for (const auto& [field, member] :
       {FieldNames("parent_link", "parent"), FieldNames("child_link", "child"), FieldNames("lower_limit", "lower"),
        FieldNames("upper_limit", "upper"), FieldNames("velocity_limit", "velocity"),
        FieldNames("effort_limit", "effort")})
    text += column(prefix + field, texts(joints, member));
  text += columns(prefix + "joint_translation", joints, 3, {"translation"});
  text += columns(prefix + "joint_rotation", joints, 3, {"rotation"});
  if (library.tree.has_drives()) {
    for (const std::string field : model::kDriveNumbers) text += column(prefix + field, texts(joints, field));
    text += columns(prefix + "rotor_axis", joints, 3, {"rotor_axis"});
    text += column(prefix + "rotor_carrier", texts(joints, "rotor_carrier"));
  }
  if (!library.tree.has_pitches()) return text;
  return text + type_field(prefix + "is_helical", joints, "helical") + column(prefix + "pitch", texts(joints, "pitch"));
}

std::string coupling_fields(const Library& library, const Items& coupled) {
  if (coupled.empty()) return "";
  std::vector<std::vector<std::string>> factors;
  for (const Item& joint : coupled) {
    factors.emplace_back();
    for (const double factor : std::get<std::vector<double>>(find(joint, "factors")->value))
      factors.back().push_back(number(factor));
  }
  return "\n" + joint_fields(library, coupled, "coupled_") +
         (library.tree.dof() == 0 ? "  model.coupling_factors = zeros(" + std::to_string(coupled.size()) + ", 0);\n"
                                  : matrix("model.coupling_factors", factors)) +
         column("coupling_offsets", texts(coupled, "offset"));
}

std::string tendon_fields(const Items& tendons) {
  std::vector<std::vector<std::string>> factors;
  for (const Item& tendon : tendons) {
    factors.emplace_back();
    for (const double factor : std::get<std::vector<double>>(find(tendon, "factors")->value))
      factors.back().push_back(number(factor));
  }
  std::string text = names("tendons", texts(tendons, "name")) + matrix("model.tendon_factors", factors);
  for (const std::string member : {"stiffness", "damping", "rest"})
    text += column("tendon_" + member, texts(tendons, member));
  return text;
}

std::string link_fields(const Items& links) {
  return names("links", texts(links, "name")) + column("parent_joint", texts(links, "parent_joint")) +
         column("mass", texts(links, "mass")) + columns("com", links, 3, {"com"}) +
         columns("inertia", links, 6, {"moments", "products"});
}

std::string frame_fields(const Items& frames) {
  return names("frames", texts(frames, "name")) + column("frame_link", texts(frames, "link")) +
         columns("frame_translation", frames, 3, {"translation"}) + columns("frame_rotation", frames, 3, {"rotation"});
}

std::string limb_fields(const Items& limbs) {
  std::string text;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const std::string field = "limbs(" + std::to_string(i + 1) + ").", limb = "  model." + field;
    for (const std::string member : {"name", "part", "first_link"})
      text += limb + member + " = " + texts({limbs[i]}, member).front() + ";\n";
    for (const std::string what : {"link", "joint", "frame"}) {
      std::vector<std::string> own, indices;
      for (const Item& row : std::get<Record>(find(limbs[i], what + "s")->value))
        for (const Constant& element : row) {
          own.push_back(quoted(element.name));
          indices.push_back(one_based(std::get<int>(element.value)));
        }
      text += column(field + what + "s", indices) + names(field + what + "_names", own);
    }
  }
  return text;
}

// `hyl.transforms.homogeneous.`
std::string dotted(const Library& library, const std::string& scope, const std::string& end = ".") {
  return joined(packages(library, scope), ".") + end;
}

}  // namespace

std::string print_model(const Library& library) {
  const model::KinematicTree& tree = library.tree;
  const bool has_spherical_joints = !tree.spherical_joints().empty();
  std::string text = "function model = model()\n";
  text += comment("MODEL  Constants of robot " + library.title() + ".");
  text += comment("  Units are SI; indices count from 1, parent_joint of the base is 0. The base is the first link.");
  text += comment("  One row for each item, or one column where an item has several numbers:");
  text += comment(
      "  joints: is_revolute, parent_link, child_link, limits of position, velocity and effort, and the placement of "
      "the joint frame in the frame of the parent link: translation, then rotation about the axes x, y', z''.");
  if (tree.has_drives())
    text += comment(
        "  joints also have drives: damping; friction, and the velocity below which it falls to zero; armature; "
        "stiffness and rest position of a spring; inertia, ratio and axis of a rotor, and rotor_carrier, a link (0 "
        "without rotor).");
  if (has_spherical_joints)
    text += comment(
        "  positions: the elements of q. A spherical joint has a unit quaternion, scalar part first; in joints it has "
        "three components, with is_spherical set, for its angular velocities about the axes of the child. Factors of "
        "couplings multiply q without the scalar parts.");
  if (!tree.followers_in_q().empty())
    text += comment(
        "  positions: the elements of q. The positions of joints come first, then those of coupled joints that follow "
        "through loops, which close_loops computes.");
  if (tree.has_pitches())
    text += comment("  joints also have is_helical and pitch, in m/rad; 0 for joints that are not helical.");
  text += comment(
      "  links: parent_joint, mass, com, and inertia about the origin of the link frame: moments xx, yy, zz, then "
      "products xy, xz, yz of positive sign.");
  text += comment("  frames: frame_link, the link that it moves with, and its placement in the frame of this link.");
  if (!tree.limbs.empty())
    text += comment(
        "  limbs: a struct for each instance of a part in the document: its name, its part and first_link, and the "
        "indices of its links, joints (rows of q) and frames, with their names in the part in fields such as "
        "link_names.");
  if (!tree.couplings.empty())
    text += comment(
        "  coupled_joints: the same for joints that follow the others, with indices after those of joints; their "
        "positions are coupling_factors * q + coupling_offsets.");
  if (!tree.tendons.empty())
    text += comment(
        "  tendons: springs and dampers with tendon_stiffness, tendon_damping and tendon_rest; their lengths are "
        "tendon_factors times the positions of all joints, coupled joints last.");
  if (tree.has_closures())
    text += comment("  Joints that follow through a loop have NaN there; joint_positions computes their positions.");
  if (!library.parameters().empty())
    text += comment(
        "  Numbers that depend on parameters are computed from the declared values; they are NaN if a value is "
        "missing.");
  text += "\n" + origin(library) + "\n";
  text += "  model.name = " + quoted(library.title()) + ";\n";
  text += "  model.dof = " + std::to_string(tree.dof()) + ";\n";
  if (model::has_own_positions(tree)) {
    std::vector<std::string> positions = model::position_names(tree);
    for (std::string& name : positions) name = matlab::quoted(name);
    text += names("positions", positions);
  }
  text += std::string("  model.floating_base = ") + (tree.floating_base ? "true" : "false") + ";\n";
  const std::vector<ConstantList> lists = constants(library);
  const Items &joints = lists[0].items, &coupled = lists[1].items, &limbs = lists[4].items;
  text += "\n" + joint_fields(library, joints);
  if (has_spherical_joints) text += type_field("is_spherical", joints, "spherical");
  text += coupling_fields(library, coupled) + "\n" + link_fields(lists[2].items) + "\n" + frame_fields(lists[3].items);
  if (!limbs.empty()) text += "\n" + limb_fields(limbs);
  if (!tree.tendons.empty()) text += "\n" + tendon_fields(lists.back().items);
  return text + "end\n";
}

std::string print_parameters(const Library& library) {
  std::string text = "function parameters = parameters()\n";
  text += comment("PARAMETERS  Values of the parameters as the document declares them.");
  text += comment("  A parameter without a value is NaN: set it before you pass the struct to a function.");
  text += "\n" + origin(library) + "\n";
  const std::vector<std::string> members = fields(model::names_of(library.parameters()));
  for (std::size_t i = 0; i < members.size(); ++i)
    text += "  parameters." + members[i] + " = " + number(model::default_of(library.parameters()[i])) + ";\n";
  return text + "end\n";
}

std::string print_contents(const Library& library, const std::vector<OverloadedFunction>& functions) {
  const std::string what = library.has_robot() ? "robot " : "model ";
  std::string text = comment("Functions of " + what + library.title() + ".") + "%\n";
  const auto entry = [&](const std::string& name, const std::string& line) {
    text += comment("  " + name + " - " + line, 0, 6);
  };
  const std::string top = dotted(library, "");
  if (library.has_robot()) entry(top + "model", "Constants of the robot.");
  if (!library.parameters().empty())
    entry(top + "parameters", "Values of the parameters as the document declares them.");
  std::vector<std::string> scopes;
  for (const OverloadedFunction& overloaded : functions) {
    if (overloaded.scope.empty()) entry(top + overloaded.name, first_line(overloaded));
    if (std::find(scopes.begin(), scopes.end(), overloaded.scope) == scopes.end()) scopes.push_back(overloaded.scope);
  }
  for (const std::string& scope : scopes) {
    if (scope.empty()) continue;
    text += "%\n" + comment("In package " + dotted(library, scope, ":"));
    for (const OverloadedFunction& overloaded : functions)
      if (overloaded.scope == scope) text += comment("  " + overloaded.name);
  }
  return text + "\n" + origin(library);
}

}  // namespace robcogen::backend::matlab
