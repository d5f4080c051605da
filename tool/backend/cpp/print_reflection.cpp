// <name>/reflection.h: the tables that the self-check and the benchmark of a robot read.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "backend/cpp/flat_tables.h"
#include "backend/cpp/inverse_table.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "support/index.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::Role;

template <std::size_t n>
Field numbers(const std::array<double, n>& values) {
  return model_numbers({values.begin(), values.end()});
}

// `{3, 7}`, the places of two frames.
std::string pair_of_frames(const model::KinematicTree& tree, const std::string& first, const std::string& second) {
  const auto place = [&](const std::string& name) { return std::to_string(model::place_of_frame(tree, name)); };
  return braced({place(first), place(second)});
}

// The tables of the elements of a model.
class ModelTables {
 public:
  explicit ModelTables(const Library& library)
      : library_(library), tree_(library.tree), value_(library.tree.parameters) {}

  Table links() const {
    std::vector<std::vector<Field>> rows;
    for (const int carrier : model::carrying_joints(tree_)) {
      const model::Link& link = tree_.links[rows.size()];
      const auto [mass, com, inertia] = model::mass_properties(link, value_);
      rows.push_back({quoted(link.name), carrier, model_number(mass), numbers(com), numbers(inertia)});
    }
    return table("Link", "kLinks", rows);
  }

  Table joints() const {
    std::vector<std::vector<Field>> rows;
    for (const int j : model::independent_joints_first(tree_)) {
      const model::Joint& joint = tree_.joints[at(j)];
      const model::Placement& placement = model::placement_of_joint(tree_, j);
      const double assembled = model::assembled_coordinate(tree_, j);
      const bool has_pitch = joint.type == model::JointType::helical || assembled != 0;
      rows.push_back(
          {quoted(joint.name), joint_type(joint.type), model::parent_link(tree_, j), model::child_link(tree_, j),
           numbers(value_(placement.translation)), numbers(value_(placement.rotation))});
      if (!joint.drive.is_absent() || has_pitch) rows.back().push_back(drive_numbers(tree_, joint));
      if (has_pitch) rows.back().push_back(model_number(value_(joint.pitch)));
      if (assembled != 0) rows.back().push_back(model_number(assembled));
    }
    return table("Joint", "kJoints", rows);
  }

  // The coupled joints, which come last, each with a list of factors.
  Table couplings() const {
    std::vector<std::vector<Field>> rows;
    std::string lists;
    for (const model::Coupling& coupling : tree_.couplings) {
      const std::string name = "coupling_" + std::to_string(rows.size()) + "_factors";
      const model::CouplingNumbers sum = model::coupling_numbers(tree_, coupling, value_);
      const bool has_factors = !sum.factors.empty();
      if (has_factors) lists += numbered_list("inline constexpr double " + name + "[]", model_numbers(sum.factors));
      rows.push_back({has_factors ? name : "nullptr", model_number(sum.offset)});
      if (sum.assembled != 0) rows.back().push_back(model_number(sum.assembled));
    }
    Table result = table("Coupling", "kCouplings", rows);
    result.definition = paragraphs({lists, result.definition});
    return result;
  }

  // Each with a list of factors.
  Table tendons() const {
    std::vector<std::vector<Field>> rows;
    std::string lists;
    for (const model::Tendon& tendon : tree_.tendons) {
      const std::string name = "tendon_" + std::to_string(rows.size()) + "_factors";
      const model::TendonNumbers n = model::tendon_numbers(tree_, tendon, value_);
      lists += numbered_list("inline constexpr double " + name + "[]", model_numbers(n.factors));
      rows.push_back(
          {quoted(tendon.name), name, model_number(n.stiffness), model_number(n.damping), model_number(n.rest)});
    }
    Table result = table("Tendon", "kTendons", rows);
    result.definition = paragraphs({lists, result.definition});
    return result;
  }

  Table frames() const {
    std::vector<std::vector<Field>> rows;
    for (const model::Frame& f : tree_.frames()) {
      const model::Placement placement = tree_.placement_of(f);
      rows.push_back(
          {quoted(f.name), tree_.link_of(f), numbers(value_(placement.translation)),
           numbers(value_(placement.rotation))});
    }
    return table("Frame", "kFrames", rows);
  }

  Table contacts() const {
    std::vector<std::vector<Field>> rows;
    for (const model::ContactFrame& c : library_.contacts)
      rows.push_back({model::place_of_frame(tree_, c.frame.name), c.is_surface ? "true" : "false"});
    return table("Contact", "kContacts", rows);
  }

  Table loops() const {
    std::vector<std::vector<Field>> rows;
    for (const model::LoopJoint& l : tree_.loops)
      rows.push_back(
          {quoted(l.name),
           "robcogen::reflection::LoopType::" + std::string(model::kLoopTypes[at(static_cast<int>(l.type))]),
           pair_of_frames(tree_, l.ends[0].frame, l.ends[1].frame), model_number(value_(l.length))});
    return table("Loop", "kLoops", rows);
  }

  Table actuators() const {
    std::vector<std::vector<Field>> rows;
    for (const model::Actuator& a : tree_.actuators)
      rows.push_back({quoted(a.name), pair_of_frames(tree_, a.frames[0], a.frames[1])});
    return table("Actuator", "kActuators", rows);
  }

  // The joints whose positions are the last elements of q.
  Table followers() const {
    const std::vector<int> joints = model::independent_joints_first(tree_);
    std::vector<std::vector<Field>> rows;
    for (const int j : tree_.followers_in_q())
      rows.push_back(
          {static_cast<int>(std::find(joints.begin(), joints.end(), j) - joints.begin()),
           model_number(model::evaluate(tree_.coupling_of(j)->offset))});
    return table("Follower", "kFollowers", rows);
  }

  Table parameters() const {
    std::vector<std::vector<Field>> rows;
    for (const model::Parameter& p : tree_.parameters) {
      const bool is_dynamics = model::is_dynamics(p);
      rows.push_back({quoted(p.name), is_dynamics ? "true" : "false", model_number(model::default_of(p))});
      if (is_dynamics && model::is_kinematics(p)) rows.back().emplace_back("true");
    }
    return table("Parameter", "kParameters", rows);
  }

 private:
  const Library& library_;
  const model::KinematicTree& tree_;
  model::DefaultValues value_;
};

Table actuator_kernels(const Api& api) {
  const std::vector<std::string> names = {"actuator_lengths", "actuator_velocities", "actuator_jacobian"};
  std::vector<std::string> kernels;
  for (const std::string& name : names) {
    const auto found = std::find_if(api.callables.begin(), api.callables.end(), [&](const Callable& c) {
      return c.function->scope.empty() && c.function->name == name && c.function->derivatives.empty();
    });
    kernels.push_back(found == api.callables.end() ? "nullptr" : address(*found));
  }
  const std::string type = "inline constexpr robcogen::reflection::ActuatorKernels ";
  return {remarked_list(type + "kActuatorKernels", kernels, {"lengths", "rates", "lever arms"}), "kActuatorKernels"};
}

bool is_form(const Callable& c, Role role) {
  return c.function->left_frame >= 0 && c.function->derivatives.empty() && !c.function->program.outputs.empty() &&
         c.function->program.outputs.front().role == role;
}

// One row for each pair of frames that has all three forms.
Table transforms(const Api& api) {
  using Pair = std::pair<int, int>;
  std::map<Pair, std::string> motion, force;
  for (const Callable& c : api.callables) {
    if (is_form(c, Role::spatial_motion)) motion[{c.function->left_frame, c.function->right_frame}] = address(c);
    if (is_form(c, Role::spatial_force)) force[{c.function->left_frame, c.function->right_frame}] = address(c);
  }
  std::vector<std::vector<Field>> rows;
  for (const Callable& c : api.callables) {
    const Pair pair(c.function->left_frame, c.function->right_frame);
    if (!is_form(c, Role::homogeneous) || !motion.contains(pair) || !force.contains(pair)) continue;
    rows.push_back({quoted(c.function->name), pair.first, pair.second, address(c), motion[pair], force[pair]});
  }
  return table("Transform", "kTransforms", rows);
}

// The list of the joints that a Jacobian's columns belong to.
Table columns_of(const Callable& c) {
  if (c.function->columns.empty()) return {"", "nullptr"};
  std::vector<std::string> indices;
  for (int j : c.function->columns) indices.push_back(std::to_string(j));
  const std::string name = c.kernel + "_columns";
  return {numbered_list("inline constexpr int " + name + "[]", indices), name};
}

Table jacobians(const Api& api) {
  std::vector<std::vector<Field>> rows;
  std::string lists;
  for (const Callable& c : api.callables) {
    if (!is_form(c, Role::jacobian)) continue;
    const Table columns = columns_of(c);
    lists += columns.definition;
    rows.push_back(
        {quoted(c.function->name), c.function->left_frame, c.function->right_frame, columns.reference,
         c.function->program.outputs.front().columns, address(c)});
  }
  Table result = table("Jacobian", "kJacobians", rows);
  result.definition = paragraphs({lists, result.definition});
  return result;
}

// The offset of the joint positions among the inputs; -1 if the function reads none.
int positions_of(const symbolic::Program& program) {
  std::size_t input = 0;
  while (input < program.inputs.size() && program.inputs[input].role != Role::joint_position) ++input;
  return input < program.inputs.size() ? static_cast<int>(offset_of(program, input)) : -1;
}

// The flat form of the core, which takes sines and cosines after q.
Field flat_core(const Callable& c) {
  const symbolic::Program& program = c.function->program;
  std::vector<std::size_t> before, behind;
  bool is_behind = false;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    (is_behind ? behind : before).push_back(offset_of(program, i));
    is_behind = is_behind || program.inputs[i].role == Role::joint_position;
  }
  return {
      "kFlatCore",
      {"&kernel::core::" + c.kernel + "<double>", offset_list(before), offset_list(behind),
       offset_list(offsets_of_outputs(program))}};
}

// The flat form of the function over many states.
Field flat_batch(const Callable& c) {
  std::vector<std::size_t> read;
  std::size_t offset = 0;
  bool has_parameters = false;
  for (const symbolic::InputArray& input : c.function->program.inputs) {
    if (input.role == Role::parameters) {
      has_parameters = true;
      continue;
    }
    read.push_back(offset);
    offset += input.elements.size();
  }
  return {
      "kFlatBatch",
      {"&batch::kernel::" + c.kernel + "<double>", has_parameters ? "true" : "false", offset_list(read),
       offset_list(offsets_of_outputs(c.function->program))}};
}

// The quantity of a function that belongs in the table of FrameFunction.
std::optional<std::string> frame_quantity(const Callable& c) {
  constexpr std::array kQuantities = {
      std::pair{Role::jacobian_in_target, "jacobian_in_target"},
      std::pair{Role::spatial_jacobian, "spatial_jacobian"},
      std::pair{Role::jacobian_derivative, "jacobian_derivative"},
      std::pair{Role::frame_bias_acceleration, "frame_bias_acceleration"},
      std::pair{Role::frame_velocity, "frame_velocity"},
      std::pair{Role::frame_acceleration, "frame_acceleration"}};
  for (const auto& [role, name] : kQuantities)
    if (is_form(c, role)) return std::string("robcogen::reflection::FrameQuantity::") + name;
  return std::nullopt;
}

Table frame_functions(const Api& api) {
  std::vector<std::vector<Field>> rows;
  std::string lists;
  for (const Callable& c : api.callables) {
    const std::optional<std::string> quantity = frame_quantity(c);
    if (!quantity) continue;
    const Table columns = columns_of(c);
    lists += columns.definition;
    rows.push_back(
        {quoted(c.kernel), *quantity, c.function->left_frame, c.function->right_frame, columns.reference,
         c.function->program.outputs.front().columns, flat(c)});
  }
  Table result = table("FrameFunction", "kFrameFunctions", rows);
  result.definition = paragraphs({lists, result.definition});
  return result;
}

// All kernels of a robot, including those that fill the cache of its parameters.
std::vector<const Callable*> all_callables(const Api& api) {
  std::vector<const Callable*> result;
  for (const std::vector<Callable>* list : {&api.callables, &api.updates})
    for (const Callable& c : *list) result.push_back(&c);
  return result;
}

// The kernels of sines and cosines, with signatures that have `parameters` even if the robot has none.
std::string flat_trigonometry(const Api& api) {
  if (!api.takes_sines()) return "";
  const std::string parameters = api.is_parametric() ? "const double* parameters" : "const double*";
  const auto function = [&](const std::string& name, std::vector<std::string> arrays) {
    std::vector<std::string> list = {parameters};
    for (const std::string& array : arrays) list.push_back("const double* " + array);
    list.insert(list.end(), {"double* sin_q", "double* cos_q"});
    if (api.is_parametric()) arrays.insert(arrays.begin(), "parameters");
    arrays.insert(arrays.end(), {"sin_q", "cos_q"});
    return declaration("inline void " + name, list, " noexcept {") + call("kernel::" + name + "<double>", arrays, 2) +
           "}\n";
  };
  return in_namespace(
      "flat", paragraphs(
                  {function("joint_trigonometry", {"q"}),
                   function(api.trigonometry.front().kernel, {"sin_joint", "cos_joint"})}));
}

std::string trigonometry(const Api& api) {
  if (!api.takes_sines()) return "{}";
  return "{" + std::to_string(api.library->trigonometry->angle_count) +
         ", &flat::joint_trigonometry, &flat::" + api.trigonometry.front().kernel + "}";
}

Table functions(const Api& api) {
  std::vector<std::vector<Field>> rows;
  for (const Callable* c : all_callables(api)) {
    rows.push_back(function_row(*c));
    const int positions = positions_of(c->function->program);
    if (positions < 0 || !(c->function->core || model::has_own_positions(api.library->tree))) continue;
    rows.back().push_back(positions);
    if (c->function->core) rows.back().emplace_back(flat_core(*c));
  }
  return table("Function", "kFunctions", rows);
}

// The functions over many states. Parameters do not count as inputs of a state.
Table batch_functions(const Api& api) {
  std::vector<std::vector<Field>> rows;
  for (const Callable& c : api.callables) {
    int inputs = 0;
    for (const symbolic::InputArray& input : c.function->program.inputs)
      if (input.role != Role::parameters) inputs += static_cast<int>(input.elements.size());
    rows.push_back({quoted(c.kernel), inputs, output_count(c.function->program), flat_batch(c)});
  }
  return table("BatchFunction", "kBatchFunctions", rows);
}

// The last fields of `robot`: the value, a remark that says what it is, and the default. Trailing fields that have
// their default are left out.
struct LastField {
  std::string value, remark, usual;
};

// Tables that most robots do not have.
struct RareTables {
  Table parameters, couplings, derivatives, contacts, loops, actuators, followers, actuator_kernels, parts,
      inverse_kinematics, tendons;

  std::vector<const Table*> all() const {
    return {&parameters, &couplings,        &derivatives, &contacts,           &loops,  &actuators,
            &followers,  &actuator_kernels, &parts,       &inverse_kinematics, &tendons};
  }
};

RareTables rare_tables(const Api& api, const ModelTables& of_model) {
  const Library& library = *api.library;
  const model::KinematicTree& tree = library.tree;
  const Table none = {"", kNoTable};
  return {
      api.is_parametric() ? of_model.parameters() : none,
      tree.couplings.empty() ? none : of_model.couplings(),
      derivatives(all_callables(api), api.is_parametric()),
      library.contacts.empty() ? none : of_model.contacts(),
      tree.loops.empty() ? none : of_model.loops(),
      tree.actuators.empty() ? none : of_model.actuators(),
      tree.followers_in_q().empty() ? none : of_model.followers(),
      tree.actuators.empty() ? Table{"", "{}"} : actuator_kernels(api),
      parts(all_callables(api)),
      inverse_kinematics(api),
      tree.tendons.empty() ? none : of_model.tendons()};
}

std::vector<LastField> last_fields(const Api& api, const RareTables& rare) {
  const model::KinematicTree& tree = api.library->tree;
  const auto numbers = [&](const std::string& what) {
    const auto found = std::find_if(
        api.numbers.begin(), api.numbers.end(), [&](const Callable& c) { return c.function->name == what; });
    return found == api.numbers.end() ? std::string("nullptr") : address(*found);
  };
  const auto boolean = [](bool value) { return std::string(value ? "true" : "false"); };
  std::vector<LastField> fields = {
      {rare.parameters.reference, "parameters", kNoTable},
      {numbers("model_numbers"), "numbers of the model", "nullptr"},
      {boolean(api.is_parametric() && tree.has_drives()), "numbers of drives", "false"},
      {boolean(tree.uses_passive_forces || !tree.has_drives()), "passive forces", "true"},
      {numbers("coupling_numbers"), "numbers of couplings", "nullptr"},
      {rare.couplings.reference, "couplings", kNoTable},
      {rare.derivatives.reference, "derivatives", kNoTable},
      {rare.contacts.reference, "contacts", kNoTable},
      {boolean(api.is_parametric() && tree.has_pitches()), "numbers of pitches", "false"},
      {tree.limbs.empty() ? "{}" : braced({"limbs.data()", std::to_string(tree.limbs.size())}), "limbs", "{}"},
      {rare.loops.reference, "loops", kNoTable},
      {rare.actuators.reference, "actuators", kNoTable},
      {rare.followers.reference, "followers", kNoTable},
      {rare.actuator_kernels.reference, "kernels of actuators", "{}"},
      {rare.parts.reference, "parts of fused functions", kNoTable},
      {rare.inverse_kinematics.reference, "inverse kinematics", kNoTable},
      {numbers("tendon_numbers"), "numbers of tendons", "nullptr"},
      {rare.tendons.reference, "tendons", kNoTable}};
  while (!fields.empty() && fields.back().value == fields.back().usual) fields.pop_back();
  return fields;
}

}  // namespace

std::string print_reflection(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  const ModelTables of_model(library);
  std::vector<Table> tables = {of_model.links(), of_model.joints(),    of_model.frames(), transforms(api),
                               jacobians(api),   frame_functions(api), functions(api)};
  std::vector<std::string> remarks = {"name",      "floating base",    "links",     "joints",
                                      "frames",    "transforms",       "Jacobians", "frame functions",
                                      "functions", "sines and cosines"};
  std::vector<std::string> parts = {
      "using robcogen::reflection::At;\nusing robcogen::reflection::kFlat;\nusing robcogen::reflection::kFlatCore;\n",
      flat_trigonometry(api)};
  std::vector<std::string> fields = {quoted(library.title()), library.tree.floating_base ? "true" : "false"};
  for (const Table& t : tables) {
    parts.push_back(t.definition);
    fields.push_back(t.reference);
  }
  fields.push_back(trigonometry(api));
  const RareTables rare = rare_tables(api, of_model);
  for (const Table* t : rare.all())
    if (!t->definition.empty()) parts.push_back(t->definition);
  for (const LastField& field : last_fields(api, rare)) {
    fields.push_back(field.value);
    remarks.push_back(field.remark);
  }
  parts.push_back(remarked_list("inline constexpr robcogen::reflection::Robot robot", fields, remarks));
  std::string batch_kernels;
  if (library.has_batches) {
    batch_kernels = in_namespace(api.space, batch_kernel_declarations(api));
    const Table t = batch_functions(api);
    parts.insert(parts.end(), {"using robcogen::reflection::kFlatBatch;\n", t.definition});
    parts.push_back(
        comment("Separate from `robot`: a program that does not use this table links none of these functions.") +
        "inline constexpr robcogen::reflection::BatchFunctions batch_functions = " + t.reference + ";\n");
  }
  std::vector<std::string> headers = {"\"robcogen/reflection.h\"", "\"robcogen/version.h\""};
  std::string levels;
  if (!library.levels.empty()) {
    headers.emplace_back("\"robcogen/level.h\"");
    levels = in_namespace(api.space, use_level(api));
  }
  std::vector<std::string> own = {cpp::quoted(kernels_path(folder(library)))};
  if (!library.tree.limbs.empty()) own.push_back(cpp::quoted(folder(library) + "/model.h"));
  return paragraphs(
      {banner(library, path, "its constants and functions as tables, without Eigen"), "#pragma once\n",
       api.is_parametric() || !library.tree.loops.empty() ? includes({"<limits>"}) : "", includes(headers),
       includes(own), runtime_check(api), levels, batch_kernels,
       in_namespace(api.space + "::reflection", paragraphs(parts))});
}

}  // namespace robcogen::backend::cpp
