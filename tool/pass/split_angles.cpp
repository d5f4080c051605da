#include "pass/split_angles.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "pass/passes.h"
#include "symbolic/apply.h"
#include "symbolic/expression.h"

namespace robcogen::pass {
namespace {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::InputArray;
using symbolic::Node;
using symbolic::Op;
using symbolic::Operand;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;
using symbolic::Statement;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// The first array of a role, and where its elements stand among all.
struct Place {
  const InputArray* array = nullptr;
  int begin = 0;
  int size() const { return array ? static_cast<int>(array->elements.size()) : 0; }
  bool contains(int element) const { return element >= begin && element < begin + size(); }
};

Place place_of(const Program& program, Role role) {
  int begin = 0;
  for (const InputArray& array : program.inputs) {
    if (array.role == role) return {&array, begin};
    begin += static_cast<int>(array.elements.size());
  }
  return {};
}

struct SinCos {
  Expression sin, cos;
};

// The angles of all programs, in one graph whose inputs are parameters and joint positions.
class Angles {
 public:
  Angles(const std::vector<Program>& programs, const std::vector<std::string>& joints)
      : q_{"q", Role::joint_position, joints}, labels_(joints), taken_(joints.begin(), joints.end()) {
    for (const Program& program : programs)
      if (const Place p = place_of(program, Role::parameters); p.array) parameters_ = *p.array;
    for (int k = 0; k < joint_count(); ++k) {
      numbers_[position(k).node()] = k;
      all_.push_back(position(k));
    }
  }

  int joint_count() const { return static_cast<int>(q_.elements.size()); }
  int count() const { return static_cast<int>(all_.size()); }

  // Of each statement that is a sine or cosine of an angle: the angle, and the sign that it has there.
  struct Reading {
    int angle = 0;
    bool negative = false;
  };
  std::vector<std::optional<Reading>> add(const Program& program) {
    std::vector<std::optional<Reading>> readings(program.statements.size());
    std::vector<std::optional<Expression>> values(program.statements.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Statement& s = program.statements[i];
      const std::optional<Expression> a = read(program, values, s.a);
      if (!a) continue;
      if (s.op == Op::sine || s.op == Op::cosine) {
        if (const std::optional<int> k = number(*a)) readings[i] = Reading{*k, a->negative()};
        continue;
      }
      const auto b = symbolic::is_binary(s.op) ? read(program, values, s.b) : Expression();
      if (b) values[i] = symbolic::apply(s.op, *a, *b);
    }
    return readings;
  }

  // The arrays that take their place: of each angle the sine, and the cosine.
  InputArray sines() const { return array("sin_q", Role::joint_sine, "s_"); }
  InputArray cosines() const { return array("cos_q", Role::joint_cosine, "c_"); }

  // These angles, from parameters and joint positions.
  Program program(const std::string& name, const std::vector<int>& which) const {
    std::vector<Expression> values;
    for (const int k : which) values.push_back(all_[at(k)]);
    return graph_.program(
        name, inputs({q_}), {{"angles", Role::value, static_cast<int>(which.size()), 1, {}}}, {values});
  }

  // Sines and cosines of all angles, from those of the joints.
  Program addition(const std::string& name) {
    Graph graph;
    std::vector<Expression> sines, cosines;
    for (const Expression& angle : all_) {
      const SinCos both = *sum(graph, angle);
      sines.push_back(both.sin);
      cosines.push_back(both.cos);
    }
    const InputArray sin_joint = {"sin_joint", Role::value, q_.elements};
    const InputArray cos_joint = {"cos_joint", Role::value, q_.elements};
    const int rows = count();
    return graph.program(
        name, inputs({sin_joint, cos_joint}),
        {{"sin_q", Role::value, rows, 1, {}}, {"cos_q", Role::value, rows, 1, {}}}, {sines, cosines});
  }

 private:
  int parameter_count() const { return static_cast<int>(parameters_.elements.size()); }
  Expression position(int k) { return graph_.input(parameter_count() + k); }
  const Node& node(const Expression& e) const { return graph_.nodes()[at(e.node())]; }

  std::vector<InputArray> inputs(std::vector<InputArray> arrays) const {
    if (parameter_count() > 0) arrays.insert(arrays.begin(), parameters_);
    return arrays;
  }

  std::optional<Expression> read(
      const Program& program,
      const std::vector<std::optional<Expression>>& values,
      const Operand& o) {
    std::optional<Expression> value;
    if (o.kind == Operand::Kind::constant) value = graph_.constant(program.constants[at(o.index)]);
    if (o.kind == Operand::Kind::statement) value = values[at(o.index)];
    if (o.kind == Operand::Kind::input) {
      const Place q = place_of(program, Role::joint_position), p = place_of(program, Role::parameters);
      if (q.contains(o.index)) value = position(o.index - q.begin);
      if (p.contains(o.index)) value = graph_.input(o.index - p.begin);
    }
    if (value && o.negative) value = -*value;
    return value;
  }

  // The number of an angle, that it gets when it is new; nullopt where the addition theorems do not reach it.
  std::optional<int> number(const Expression& angle) {
    const auto known = numbers_.find(angle.node());
    if (known != numbers_.end()) return known->second;
    Graph graph;
    if (follows_from_parameters(angle) || !sum(graph, angle)) return std::nullopt;
    const int number = count();
    numbers_[angle.node()] = number;
    all_.push_back(angle.negative() ? -angle : angle);
    labels_.push_back(label(angle));
    return number;
  }

  bool follows_from_parameters(const Expression& e) const {
    const Node& n = node(e);
    if (n.kind == Node::Kind::input) return n.a < parameter_count();
    if (n.kind == Node::Kind::constant) return true;
    return follows_from_parameters(operand(n.a)) && (n.b < 0 || follows_from_parameters(operand(n.b)));
  }

  Expression operand(int node) const { return const_cast<Graph&>(graph_).expression(node, false); }

  // What follows from parameters alone, built anew in another graph with the same parameters.
  Expression copy(Graph& graph, const Expression& e) const {
    const Node& n = node(e);
    Expression result;
    if (n.kind == Node::Kind::input) result = graph.input(n.a);
    if (n.kind == Node::Kind::constant) result = graph.constant(graph_.number(n));
    if (n.kind == Node::Kind::operation) {
      const Expression a = copy(graph, operand(n.a)), b = n.b < 0 ? Expression() : copy(graph, operand(n.b));
      result = symbolic::apply(n.op, n.a_negative ? -a : a, b);
    }
    return e.negative() ? -result : result;
  }

  // Sine and cosine of an angle from those of the joints, which are the inputs behind the parameters.
  std::optional<SinCos> sum(Graph& graph, const Expression& e) const {
    if (follows_from_parameters(e)) {
      const Expression angle = copy(graph, e);
      return SinCos{sin(angle), cos(angle)};
    }
    const Node& n = node(e);
    std::optional<SinCos> result;
    if (n.kind == Node::Kind::input) result = SinCos{graph.input(n.a), graph.input(n.a + joint_count())};
    if (n.kind == Node::Kind::operation && (n.op == Op::add || n.op == Op::subtract)) {
      const std::optional<SinCos> a = sum(graph, operand(n.a));
      std::optional<SinCos> b = sum(graph, operand(n.b));
      if (!a || !b) return std::nullopt;
      if (n.op == Op::subtract) b->sin = -b->sin;
      const Expression sc = a->sin * b->cos, cc = a->cos * b->cos;
      result = SinCos{sc + a->cos * b->sin, cc - a->sin * b->sin};
    }
    if (result && e.negative()) result->sin = -result->sin;
    return result;
  }

  // `HFE_KFE` of a sum of joints, `HFE_turned` with a constant or a parameter; numbered where another has it.
  std::string label(const Expression& angle) {
    std::string joints, name;
    bool turned = false;
    describe(angle, joints, turned);
    name = turned ? joints + "_turned" : joints;
    const std::string wanted = name;
    for (int k = 2; !taken_.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
    return name;
  }

  void describe(const Expression& e, std::string& joints, bool& turned) const {
    const Node& n = node(e);
    if (follows_from_parameters(e)) {
      turned = true;
    } else if (n.kind == Node::Kind::input) {
      joints += (joints.empty() ? "" : "_") + q_.elements[at(n.a - parameter_count())];
    } else {
      describe(operand(n.a), joints, turned);
      describe(operand(n.b), joints, turned);
    }
  }

  InputArray array(const std::string& name, Role role, const std::string& prefix) const {
    InputArray result = {name, role, {}};
    for (const std::string& label : labels_) result.elements.push_back(prefix + label);
    return result;
  }

  InputArray q_, parameters_;
  Graph graph_;
  std::vector<Expression> all_;
  std::vector<std::string> labels_;
  std::set<std::string> taken_;
  std::map<int, int> numbers_;  // by node
};

// The program with sines and cosines as inputs behind the joint positions. Statement by statement, so that it rounds
// as the program does.
Program core_of(
    const Program& program,
    const std::vector<std::optional<Angles::Reading>>& readings,
    const InputArray& sines,
    const InputArray& cosines) {
  const Place q = place_of(program, Role::joint_position);
  const int end = q.begin + q.size(), count = static_cast<int>(sines.elements.size());
  Program core = program;
  const auto moved = [&](Operand& o) {
    if (o.kind == Operand::Kind::input && o.index >= end) o.index += 2 * count;
    if (o.kind != Operand::Kind::statement || !readings[at(o.index)]) return;
    const Angles::Reading& reading = *readings[at(o.index)];
    const bool is_cosine = program.statements[at(o.index)].op == Op::cosine;
    o = {
        Operand::Kind::input, end + reading.angle + (is_cosine ? count : 0),
        o.negative != (reading.negative && !is_cosine)};
  };
  for (Statement& s : core.statements) {
    moved(s.a);
    if (symbolic::is_binary(s.op)) moved(s.b);
  }
  for (OutputArray& array : core.outputs)
    for (Operand& o : array.values) moved(o);
  const auto behind = core.inputs.begin() + (q.array - program.inputs.data()) + 1;
  core.inputs.insert(behind, {sines, cosines});
  return eliminate_dead_code(core);
}

std::vector<int> angles_read(const std::vector<std::optional<Angles::Reading>>& readings) {
  std::set<int> read;
  for (const auto& reading : readings)
    if (reading) read.insert(reading->angle);
  return {read.begin(), read.end()};
}

}  // namespace

SplitAngles split_angles(const std::vector<Program>& programs, const std::vector<std::string>& joints) {
  Angles angles(programs, joints);
  std::vector<std::vector<std::optional<Angles::Reading>>> readings;
  for (const Program& program : programs) readings.push_back(angles.add(program));

  SplitAngles result;
  result.angle_count = angles.count();
  const InputArray sines = angles.sines(), cosines = angles.cosines();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    result.parts.emplace_back();
    const std::vector<int> read = angles_read(readings[i]);
    if (!read.empty())
      result.parts.back() = symbolic::AngleParts{
          core_of(programs[i], readings[i], sines, cosines), read, angles.program("angles_" + programs[i].name, read)};
  }
  std::vector<int> all;
  for (int k = 0; k < angles.count(); ++k) all.push_back(k);
  result.angles = angles.program("joint_trigonometry", all);
  result.addition = angles.addition("joint_trigonometry_given");
  return result;
}

}  // namespace robcogen::pass
