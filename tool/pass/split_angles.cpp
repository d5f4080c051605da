#include "pass/split_angles.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "pass/statements.h"
#include "support/index.h"
#include "support/parallel.h"
#include "support/unique_names.h"
#include "symbolic/apply.h"
#include "symbolic/expression.h"
#include "symbolic/lane_names.h"

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
  Angles(const std::vector<WithLanes>& programs, const std::vector<Position>& positions)
      : q_{"q", Role::joint_position, {}}, positions_(positions) {
    for (const Position& p : positions) q_.elements.push_back(p.joint);
    labels_ = q_.elements;
    taken_.reserve_all(labels_);
    for (const WithLanes& p : programs)
      if (const Place place = place_of(p.program, Role::parameters); place.array) parameters_ = *place.array;
    for (int k = 0; k < joint_count(); ++k) {
      numbers_[position(k).node()] = k;
      all_.push_back(position(k));
    }
  }

  int joint_count() const { return static_cast<int>(q_.elements.size()); }
  int count() const { return static_cast<int>(all_.size()); }

  // Of a sine or cosine of an angle: the angle, and the sign that it has there.
  struct Reading {
    int angle = 0;
    bool negative = false;
  };
  // Of each statement that is a sine or cosine of angles: a reading for each lane; else none.
  using Readings = std::vector<std::vector<Reading>>;

  Readings add(const Program& program) {
    Readings readings(program.statements.size());
    Values values(program);
    for (std::size_t i = 0; i < program.statements.size(); ++i) {
      const Statement& s = program.statements[i];
      for (int lane = 0; lane < s.width; ++lane) {
        const std::optional<Expression> a = read(values, s.op == Op::gather ? s.lanes[at(lane)] : s.a, lane);
        if (s.op != Op::sine && s.op != Op::cosine)
          values.of(i, lane) = compute(values, s, a, lane);
        else if (const auto k = a ? number(*a) : std::nullopt)
          readings[i].push_back({*k, a->negative()});
      }
      if (readings[i].size() < at(s.width)) readings[i].clear();
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

  // Of a program, as far as they follow from parameters and joint positions.
  class Values {
   public:
    explicit Values(const Program& p)
        : program(p), q(place_of(p, Role::joint_position)), parameters(place_of(p, Role::parameters)) {
      std::size_t count = 0;
      for (const Statement& s : p.statements) {
        first_.push_back(count);
        count += at(s.width);
      }
      values_.resize(count);
    }
    std::optional<Expression>& of(std::size_t statement, int lane) { return values_[first_[statement] + at(lane)]; }

    const Program& program;
    const Place q, parameters;

   private:
    std::vector<std::size_t> first_;  // by statement
    std::vector<std::optional<Expression>> values_;
  };

  // This lane of a statement whose first operand is `a` there.
  std::optional<Expression> compute(Values& values, const Statement& s, std::optional<Expression> a, int lane) {
    if (s.op == Op::gather || !a) return a;
    const auto b = symbolic::is_binary(s.op) ? read(values, s.b, lane) : Expression();
    if (!b || s.op == Op::sum_lanes) return std::nullopt;
    return symbolic::apply(s.op, *a, *b);
  }

  // An operand of a value with lanes, in one of these.
  std::optional<Expression> read(Values& values, const Operand& o, int lane) {
    std::optional<Expression> value;
    if (is_constant(o)) value = graph_.constant(values.program.constants[at(o.index)]);
    if (is_statement(o)) {
      const bool is_scalar = values.program.statements[at(o.index)].width == 1;
      value = values.of(at(o.index), is_scalar ? 0 : o.lane >= 0 ? o.lane : lane);
    }
    if (o.kind == Operand::Kind::input) {
      if (values.q.contains(o.index)) value = position(o.index - values.q.begin);
      if (values.parameters.contains(o.index)) value = graph_.input(o.index - values.parameters.begin);
    }
    if (value && o.negative) value = -*value;
    return value;
  }

  // The number of an angle, that it gets when it is new; nullopt where the addition theorems do not reach it.
  std::optional<int> number(const Expression& angle) {
    const auto known = numbers_.find(angle.node());
    if (reads_slide(angle)) return std::nullopt;
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

  // Whether the angle depends on the position of a joint that slides.
  bool reads_slide(const Expression& e) const {
    const Node& n = node(e);
    if (n.kind == Node::Kind::input)
      return n.a >= parameter_count() && !positions_[at(n.a - parameter_count())].is_angle;
    return n.kind == Node::Kind::operation && (reads_slide(operand(n.a)) || (n.b >= 0 && reads_slide(operand(n.b))));
  }

  Expression operand(int node) const { return const_cast<Graph&>(graph_).expression(node, false); }

  // What follows from parameters alone, built anew in another graph with the same parameters.
  Expression copy(Graph& graph, const Expression& e) const {
    const Node& n = node(e);
    Expression result;
    if (n.kind == Node::Kind::input) result = graph.input(n.a);
    if (n.kind == Node::Kind::constant) result = graph.constant(graph_.constant_of(n));
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
    std::string joints;
    bool turned = false;
    describe(angle, joints, turned);
    return taken_.add(turned ? joints + "_turned" : joints);
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
  std::vector<Position> positions_;
  Graph graph_;
  std::vector<Expression> all_;
  std::vector<std::string> labels_;
  UniqueNames taken_;
  std::map<int, int> numbers_;  // by node
};

// The program with sines and cosines as inputs behind the joint positions. Statement by statement, so that it rounds
// as the program does.
class Core {
 public:
  Core(const Program& program, const Angles::Readings& readings, const InputArray& sines, const InputArray& cosines)
      : program_(program), readings_(readings), sines_(sines), cosines_(cosines) {
    const Place q = place_of(program, Role::joint_position);
    behind_ = static_cast<std::size_t>(q.array - program.inputs.data()) + 1;
    end_ = q.begin + q.size();
    if (program.has_lanes())
      for (const Statement& s : program.statements) names_.reserve(s.name);
  }

  Program run() {
    Program core = program_;
    for (std::size_t i = 0; i < core.statements.size(); ++i) {
      Statement& s = core.statements[i];
      if (!readings_[i].empty() && s.width > 1)
        s = gathered(i);
      else
        for_each_operand(s, [&](Operand& o) { move(o); });
    }
    for (OutputArray& array : core.outputs)
      for (Operand& o : array.values) move(o);
    core.inputs.insert(core.inputs.begin() + static_cast<std::ptrdiff_t>(behind_), {sines_, cosines_});
    return eliminate_dead_code(std::move(core));
  }

 private:
  int count() const { return static_cast<int>(sines_.elements.size()); }

  void move(Operand& o) const {
    if (o.kind == Operand::Kind::input && o.index >= end_) o.index += 2 * count();
    if (!is_statement(o) || readings_[at(o.index)].empty()) return;
    const bool is_whole = program_.statements[at(o.index)].width > 1 && o.lane < 0;
    if (!is_whole) o = input(at(o.index), at(std::max(o.lane, 0)), o.negative);
  }

  // What a sine or cosine is in this lane.
  Operand input(std::size_t statement, std::size_t lane, bool negative) const {
    const Angles::Reading& reading = readings_[statement][lane];
    const bool is_cosine = program_.statements[statement].op == Op::cosine;
    const int element = end_ + reading.angle + (is_cosine ? count() : 0);
    return {Operand::Kind::input, element, negative != (reading.negative && !is_cosine)};
  }

  Statement gathered(std::size_t i) {
    const Statement& old = program_.statements[i];
    Statement s;
    s.op = Op::gather;
    s.section = old.section;
    s.width = old.width;
    std::vector<std::string> labels;
    for (std::size_t lane = 0; lane < readings_[i].size(); ++lane) {
      s.lanes.push_back(input(i, lane, false));
      labels.push_back((old.op == Op::cosine ? cosines_ : sines_).elements[at(readings_[i][lane].angle)]);
    }
    names_.release(old.name);
    s.name = names_.add(symbolic::common_name(labels));
    return s;
  }

  const Program& program_;
  const Angles::Readings& readings_;
  const InputArray &sines_, &cosines_;
  std::size_t behind_ = 0;  // the array behind the joint positions
  int end_ = 0;             // the element behind them
  UniqueNames names_;       // of a program with lanes
};

std::set<int> angles_read(const Angles::Readings& readings) {
  std::set<int> read;
  for (const auto& lanes : readings)
    for (const Angles::Reading& reading : lanes) read.insert(reading.angle);
  return read;
}

}  // namespace

SplitAngles split_angles(const std::vector<WithLanes>& programs, const std::vector<Position>& positions) {
  Angles angles(programs, positions);
  std::vector<Angles::Readings> readings, readings_in_lanes;
  for (const WithLanes& p : programs) readings.push_back(angles.add(p.program));
  for (const WithLanes& p : programs)
    readings_in_lanes.push_back(p.in_lanes ? angles.add(*p.in_lanes) : Angles::Readings());

  SplitAngles result;
  result.angle_count = angles.count();
  const InputArray sines = angles.sines(), cosines = angles.cosines();
  result.parts.resize(programs.size());
  for_each_index(programs.size(), [&](std::size_t i) {
    std::optional<symbolic::AngleParts>& parts = result.parts[i];
    std::set<int> read = angles_read(readings[i]);
    read.merge(angles_read(readings_in_lanes[i]));
    if (read.empty()) return;
    const auto& [program, in_lanes] = programs[i];
    parts.emplace();
    parts->core = Core(program, readings[i], sines, cosines).run();
    if (in_lanes) parts->core_in_lanes = Core(*in_lanes, readings_in_lanes[i], sines, cosines).run();
    parts->read = {read.begin(), read.end()};
    parts->angles = angles.program("angles_" + program.name, parts->read);
  });
  std::vector<int> all;
  for (int k = 0; k < angles.count(); ++k) all.push_back(k);
  result.angles = angles.program("joint_trigonometry", all);
  result.addition = angles.addition("joint_trigonometry_given");
  return result;
}

}  // namespace robcogen::pass
