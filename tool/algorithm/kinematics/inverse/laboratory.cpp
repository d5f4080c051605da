#include "algorithm/kinematics/inverse/laboratory.h"

namespace robcogen::algorithm::inversion {

using symbolic::Node;
using symbolic::Op;

int weight(const Graph& graph, std::size_t mark) {
  int sum = 0;
  for (std::size_t i = mark; i < graph.nodes().size(); ++i) {
    const Node& n = graph.nodes()[i];
    if (n.kind != Node::Kind::operation) continue;
    switch (n.op) {
      case Op::divide:
      case Op::square_root:
        sum += 5;
        break;
      case Op::sine:
      case Op::cosine:
        sum += 10;
        break;
      default:
        ++sum;
    }
  }
  return sum;
}

Laboratory::Laboratory(const SerialChain& chain) : chain_(chain) {
  graph.forget_names();
  int element = 0;
  if (chain.task.kind == model::InverseTask::Kind::point)
    for (std::size_t k = 0; k < 3; ++k) target.rotation[k][k] = graph.one();
  else
    for (Vector3& row : target.rotation.row)
      for (std::size_t k = 0; k < 3; ++k) row[k] = graph.input(element++);
  for (std::size_t k = 0; k < 3; ++k) target.position[k] = graph.input(element++);
  for (int k = 0; k < chain.joints; ++k) references.push_back(graph.input(element++));
  for (int k = 0; k < chain.joints; ++k) {
    const Expression sine = graph.input(element++), cosine = graph.input(element++);
    joints.push_back({sine, chain.axis(k).turns ? cosine : graph.one()});
  }
}

void Laboratory::set(std::size_t state, const NumberPose& pose, const std::vector<double>& q) {
  const std::vector<SineCosine> values = sines_cosines(chain_, q);
  std::size_t element = 0;
  const auto next = [&](double value) {
    if (inputs.size() <= element) inputs.emplace_back();
    inputs[element++][state] = value;
  };
  if (chain_.task.kind != model::InverseTask::Kind::point)
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) next(pose.rotation[c][r]);
  for (const double x : pose.position) next(x);
  for (const double position : q) next(position);
  for (const SineCosine& value : values) next(value.sine), next(value.cosine);
}

JointValues Laboratory::known() const {
  JointValues values(chain_.axes.size());
  for (int k = 0; k < chain_.joints; ++k)
    if (chain_.is_known(k)) values[at(k)] = joints[at(k)];
  return values;
}

}  // namespace robcogen::algorithm::inversion
