// The structs of constants and of parameters, and the overview of a package.
#include <algorithm>
#include <utility>

#include "backend/common/constants.h"
#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"
#include "support/index.h"

namespace robcogen::backend::matlab {
namespace {

template <class Items, class Text>
std::vector<std::string> texts(const Items& items, Text text) {
  std::vector<std::string> result;
  for (const auto& item : items) result.push_back(text(item));
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
  return wrapped("  model." + field + " = {", texts(items, quoted), "};", ";");
}

// `model.<field> = […];`, one column per item.
template <class Items, class Column>
std::string columns(const std::string& field, const Items& items, std::size_t rows, Column column) {
  if (items.empty()) return "  model." + field + " = zeros(" + std::to_string(rows) + ", 0);\n";
  std::vector<std::vector<std::string>> cells(rows);
  for (const auto& item : items) {
    const auto numbers = column(item);
    for (std::size_t r = 0; r < rows; ++r) cells[r].push_back(number(numbers[r]));
  }
  return matrix("model." + field, cells);
}

std::string one_based(int index) {
  return std::to_string(index + 1);
}

std::string frame_fields(const model::KinematicTree& tree, const model::DefaultValues& value) {
  const std::vector<model::Frame> frames = tree.frames();
  std::string text = names("frames", model::frame_names(tree));
  text += column("frame_link", texts(frames, [&](const auto& f) { return one_based(tree.link_of(f)); }));
  text +=
      columns("frame_translation", frames, 3, [&](const auto& f) { return value(tree.placement_of(f).translation); });
  return text +
         columns("frame_rotation", frames, 3, [&](const auto& f) { return value(tree.placement_of(f).rotation); });
}

std::string link_fields(const model::KinematicTree& tree, const model::DefaultValues& value) {
  std::vector<model::MassProperties> links;
  for (std::size_t l = 0; l < at(tree.link_count()); ++l) links.push_back(model::mass_properties(tree.links[l], value));
  std::string text = names("links", model::link_names(tree));
  text += column("parent_joint", texts(model::carrying_joints(tree), one_based));
  text += column("mass", texts(links, [](const auto& l) { return number(l.mass); }));
  text += columns("com", links, 3, [](const auto& l) { return l.com; });
  return text + columns("inertia", links, 6, [](const auto& l) { return l.inertia; });
}

// The fields of some joints of a robot. Their names start with `prefix`.
class JointFields {
 public:
  JointFields(const Library& library, std::vector<int> joints, std::string prefix)
      : tree_(library.tree), value_(library.tree.parameters), joints_(std::move(joints)), prefix_(std::move(prefix)) {}

  std::string all() const {
    return of_joints() + (tree_.has_drives() ? of_drives() : "") + (tree_.has_pitches() ? of_pitches() : "");
  }

  // Whether each joint is of this type.
  std::string type_field(const std::string& name, model::JointType type) const {
    return field(name, [&](const model::Joint& j) { return std::string(j.type == type ? "true" : "false"); });
  }

 private:
  template <class Text>
  std::string field(const std::string& name, Text text) const {
    return column(prefix_ + name, texts(joints_, [&](int j) { return text(tree_.joints[at(j)]); }));
  }
  template <class Numbers>
  std::string numbers(const std::string& name, Numbers numbers) const {
    return columns(prefix_ + name, joints_, 3, numbers);
  }

  std::string of_joints() const {
    std::string text = names(prefix_ + "joints", model::names_of(tree_, joints_));
    text += type_field("is_revolute", model::JointType::revolute);
    text +=
        column(prefix_ + "parent_link", texts(joints_, [&](int j) { return one_based(model::parent_link(tree_, j)); }));
    text +=
        column(prefix_ + "child_link", texts(joints_, [&](int j) { return one_based(model::child_link(tree_, j)); }));
    text += field("lower_limit", [](const model::Joint& j) { return number(j.limits.lower); });
    text += field("upper_limit", [](const model::Joint& j) { return number(j.limits.upper); });
    text += field("velocity_limit", [](const model::Joint& j) { return number(j.limits.velocity); });
    text += field("effort_limit", [](const model::Joint& j) { return number(j.limits.effort); });
    const auto placement = [&](int j) -> const model::Placement& { return model::placement_of_joint(tree_, j); };
    text += numbers("joint_translation", [&](int j) { return value_(placement(j).translation); });
    return text + numbers("joint_rotation", [&](int j) { return value_(placement(j).rotation); });
  }

  // The fields of robots with drives.
  std::string of_drives() const {
    std::string text;
    for (std::size_t k = 0; k < model::kDriveNumbers.size(); ++k)
      text += field(
          model::kDriveNumbers[k], [&](const model::Joint& j) { return number(model::drive_numbers(j, value_)[k]); });
    text += numbers("rotor_axis", [&](int j) { return model::rotor_axis(tree_.joints[at(j)], value_); });
    return text + field("rotor_carrier", [](const model::Joint& j) { return one_based(model::rotor_carrier(j)); });
  }

  // The fields of robots with helical joints.
  std::string of_pitches() const {
    return type_field("is_helical", model::JointType::helical) +
           field("pitch", [&](const model::Joint& j) { return number(value_(j.pitch)); });
  }

  const model::KinematicTree& tree_;
  model::DefaultValues value_;
  std::vector<int> joints_;
  std::string prefix_;
};

std::string coupling_fields(const Library& library) {
  const model::KinematicTree& tree = library.tree;
  if (tree.couplings.empty()) return "";
  const model::DefaultValues value(tree.parameters);
  std::vector<std::vector<std::string>> factors;
  std::vector<std::string> offsets;
  for (const model::Coupling& coupling : tree.couplings) {
    const model::CouplingNumbers numbers = model::coupling_numbers(tree, coupling, value);
    factors.push_back(texts(numbers.factors, [](double factor) { return number(factor); }));
    offsets.push_back(number(numbers.offset));
  }
  return "\n" + JointFields(library, model::dependent_joints(tree), "coupled_").all() +
         (tree.dof() == 0 ? "  model.coupling_factors = zeros(" + std::to_string(factors.size()) + ", 0);\n"
                          : matrix("model.coupling_factors", factors)) +
         column("coupling_offsets", offsets);
}

std::string limb_fields(const std::vector<model::Limb>& limbs) {
  std::string text;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const std::string field = "limbs(" + std::to_string(i + 1) + ").", limb = "  model." + field;
    const model::Limb& l = limbs[i];
    text += limb + "name = " + quoted(l.name) + ";\n" + limb + "part = " + quoted(l.part) + ";\n";
    text += limb + "first_link = " + one_based(l.first_link) + ";\n";
    const auto elements = [&](const std::string& what, const std::vector<model::Limb::Element>& list) {
      text += column(field + what + "s", texts(list, [](const auto& e) { return one_based(e.index); }));
      text += names(field + what + "_names", texts(list, [](const auto& e) { return e.own; }));
    };
    elements("link", l.links);
    elements("joint", l.joints);
    elements("frame", l.frames);
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
  if (tree.has_closures())
    text += comment("  Joints that follow through a loop have NaN there; joint_positions computes their positions.");
  if (!library.parameters().empty())
    text += comment(
        "  Numbers that depend on parameters are computed from the declared values; they are NaN if a value is "
        "missing.");
  text += "\n" + origin(library) + "\n";
  text += "  model.name = " + quoted(library.title()) + ";\n";
  text += "  model.dof = " + std::to_string(tree.dof()) + ";\n";
  if (model::has_own_positions(tree)) text += names("positions", model::position_names(tree));
  text += std::string("  model.floating_base = ") + (tree.floating_base ? "true" : "false") + ";\n";
  const JointFields joints(library, tree.coordinates(), "");
  const model::DefaultValues value(tree.parameters);
  text += "\n" + joints.all();
  if (has_spherical_joints) text += joints.type_field("is_spherical", model::JointType::spherical);
  text += coupling_fields(library) + "\n" + link_fields(tree, value) + "\n" + frame_fields(tree, value);
  if (!tree.limbs.empty()) text += "\n" + limb_fields(model::listed_limbs(tree));
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

std::string print_contents(const Library& library, const std::vector<Callable>& callables) {
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
  for (const Callable& callable : callables) {
    if (callable.scope.empty()) entry(top + callable.name, first_line(callable));
    if (std::find(scopes.begin(), scopes.end(), callable.scope) == scopes.end()) scopes.push_back(callable.scope);
  }
  for (const std::string& scope : scopes) {
    if (scope.empty()) continue;
    text += "%\n" + comment("In package " + dotted(library, scope, ":"));
    for (const Callable& callable : callables)
      if (callable.scope == scope) text += comment("  " + callable.name);
  }
  return text + "\n" + origin(library);
}

}  // namespace robcogen::backend::matlab
