// Composite-rigid-body algorithm with mass, first moment and pseudo-inertia.
#include "algorithm/joint_space_inertia.h"

#include "algorithm/composite.h"
#include "algorithm/dynamics.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Square, symmetric, zero until set.
class SymmetricMatrix {
 public:
  explicit SymmetricMatrix(int size) : size_(size), values_(static_cast<std::size_t>(size * size)) {}

  void set(int row, int column, const Expression& value) {
    values_[static_cast<std::size_t>(row + column * size_)] = value;
    values_[static_cast<std::size_t>(column + row * size_)] = value;
  }
  const std::vector<Expression>& columns() const { return values_; }

 private:
  int size_;
  std::vector<Expression> values_;
};

}  // namespace

std::vector<Expression> joint_space_inertia(const Setup& setup) {
  const model::KinematicTree& tree = setup.tree();
  const std::vector<MassProperties> composite = composite_bodies(setup);
  const int base = tree.floating_base ? 6 : 0;
  SymmetricMatrix h(base + tree.dof());
  for (int j = 0; j < tree.dof(); ++j) {
    const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    const std::string& link = setup.link_name(joint.child);
    setup.trace.section(link, "link " + link + ": column of joint " + joint.name);
    Spatial wrench =
        unit_wrench(composite[static_cast<std::size_t>(joint.child)], joint.type == model::JointType::revolute);
    int i = j;
    while (true) {
      const model::Joint& here = tree.joints[static_cast<std::size_t>(i)];
      h.set(base + i, base + j, here.type == model::JointType::revolute ? wrench.angular[2] : wrench.linear[2]);
      if (!setup.parent_matters(here.child)) break;
      wrench = to_parent(setup.pose(i), wrench);
      i = tree.parent_joint_of(i);
      if (i < 0) break;
    }
    if (!tree.floating_base) continue;
    for (int k = 0; k < 3; ++k) {
      h.set(k, base + j, wrench.angular[static_cast<std::size_t>(k)]);
      h.set(3 + k, base + j, wrench.linear[static_cast<std::size_t>(k)]);
    }
  }
  if (tree.floating_base) {
    const Matrix3 inertia = inertia_tensor(composite[0]);
    const Matrix3 coupling = skew(composite[0].first_moment);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(r), k = static_cast<std::size_t>(c);
        if (c <= r) h.set(r, c, inertia[i][k]);
        h.set(3 + r, c, coupling[k][i]);
        if (c <= r) h.set(3 + r, 3 + c, r == c ? composite[0].mass : Expression());
      }
    }
  }
  return h.columns();
}

std::vector<int> elimination_order(const model::KinematicTree& tree) {
  std::vector<int> order;
  const int base = tree.floating_base ? 6 : 0;
  for (int k = 0; k < base; ++k) order.push_back(k);
  for (const int j : tree.topological()) order.push_back(base + j);
  return order;
}

Program joint_space_inertia(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const int size = tree.dof() + (tree.floating_base ? 6 : 0);
  trace.output("H", Role::inertia_matrix, size, size, joint_space_inertia(Setup(trace, q, formulation)));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
