#include "pass/angle_table.h"

#include <utility>

#include "support/index.h"

namespace robcogen::pass {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::InputArray;
using symbolic::Program;
using symbolic::Role;

AngleTable::AngleTable(InputArray parameters, const std::vector<Position>& positions)
    : q_{"q", Role::joint_position, {}},
      parameters_(std::move(parameters)),
      sums_(positions, static_cast<int>(parameters_.elements.size())) {
  for (const Position& p : positions) q_.elements.push_back(p.joint);
  labels_ = q_.elements;
  taken_.reserve_all(labels_);
  for (int k = 0; k < sums_.joint_count(); ++k) {
    numbers_[sums_.position(k).node()] = k;
    all_.push_back(sums_.position(k));
  }
}

std::optional<int> AngleTable::number(const Expression& angle) {
  const auto known = numbers_.find(angle.node());
  if (sums_.reads_slide(angle)) return std::nullopt;
  if (known != numbers_.end()) return known->second;
  Graph graph;
  if (sums_.follows_from_parameters(angle) || !sums_.by_addition(graph, angle)) return std::nullopt;
  const int number = count();
  numbers_[angle.node()] = number;
  all_.push_back(angle.negative() ? -angle : angle);
  labels_.push_back(taken_.add(sums_.label(angle)));
  return number;
}

Program AngleTable::program(const std::string& name, const std::vector<int>& which) const {
  std::vector<Expression> values;
  for (const int k : which) values.push_back(all_[at(k)]);
  return sums_.graph().program(
      name, inputs({q_}), {{"angles", Role::value, static_cast<int>(which.size()), 1, {}}}, {values});
}

Program AngleTable::addition(const std::string& name) const {
  Graph graph;
  std::vector<Expression> sines, cosines;
  for (const Expression& angle : all_) {
    const SinCos both = *sums_.by_addition(graph, angle);
    sines.push_back(both.sin);
    cosines.push_back(both.cos);
  }
  const InputArray sin_joint = {"sin_joint", Role::value, q_.elements};
  const InputArray cos_joint = {"cos_joint", Role::value, q_.elements};
  const int rows = count();
  return graph.program(
      name, inputs({sin_joint, cos_joint}), {{"sin_q", Role::value, rows, 1, {}}, {"cos_q", Role::value, rows, 1, {}}},
      {sines, cosines});
}

std::vector<InputArray> AngleTable::inputs(std::vector<InputArray> arrays) const {
  if (!parameters_.elements.empty()) arrays.insert(arrays.begin(), parameters_);
  return arrays;
}

InputArray AngleTable::array(const std::string& name, Role role, const std::string& prefix) const {
  InputArray result = {name, role, {}};
  for (const std::string& label : labels_) result.elements.push_back(prefix + label);
  return result;
}

}  // namespace robcogen::pass
