// Angles as functions of run-time parameters and joint positions, which are the inputs of one graph, in this order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symbolic/expression.h"

namespace robcogen::pass {

struct SinCos {
  symbolic::Expression sin, cos;
};

// The position of a joint that turns or slides. If it slides, its sine and cosine are not known, but a coupled joint
// may turn by it.
struct Position {
  std::string joint;
  bool is_angle = true;
};

class AngleSums {
 public:
  AngleSums(const std::vector<Position>& positions, int parameter_count)
      : positions_(positions), parameter_count_(parameter_count) {}

  symbolic::Graph& graph() { return graph_; }
  const symbolic::Graph& graph() const { return graph_; }
  int joint_count() const { return static_cast<int>(positions_.size()); }
  symbolic::Expression parameter(int k) { return graph_.input(k); }
  symbolic::Expression position(int k) { return graph_.input(parameter_count_ + k); }

  // Whether the angle depends on the position of a joint that slides.
  bool reads_slide(const symbolic::Expression& e) const;
  bool follows_from_parameters(const symbolic::Expression& e) const;

  // Sine and cosine from those of the joints by the addition theorems, in a graph whose inputs are the parameters, the
  // sines of all joints, and their cosines. nullopt for an angle that is not a sum of joint positions and of terms that
  // depend on parameters alone.
  std::optional<SinCos> by_addition(symbolic::Graph& graph, const symbolic::Expression& e) const;

  // `HFE_KFE` for a sum of joint positions, `HFE_turned` for one with a constant or a parameter.
  std::string label(const symbolic::Expression& e) const;

 private:
  const symbolic::Node& node(const symbolic::Expression& e) const;
  symbolic::Expression operand(int node) const;
  symbolic::Expression copy(symbolic::Graph& graph, const symbolic::Expression& e) const;
  void describe(const symbolic::Expression& e, std::string& joints, bool& turned) const;

  std::vector<Position> positions_;
  int parameter_count_;
  symbolic::Graph graph_;
};

}  // namespace robcogen::pass
