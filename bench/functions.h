// The benchmarks of one generated library. Each calls a function through its public wrapper, for each state in turn;
// its label is the name of the kernel beneath, its counters are that kernel's operation counts.
//
// The context entry `compared/<quantity>` names the benchmark that is compared with those of other libraries.
#pragma once

#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <string>
#include <vector>

#include "robcogen/reference/available.h"
#include "robcogen/reference/kinematics.h"
#include "states.h"

namespace robcogen::bench {

inline void add_counts(benchmark::State& state, const Robot& robot, const std::string& kernel) {
  state.SetLabel(kernel);
  for (const reflection::Function& f : robot.functions) {
    if (kernel != f.name) continue;
    // Zeros are left out, because the library would report their coefficient of variation, 0 / 0, as invalid JSON.
    const auto add = [&](const char* name, int count) {
      if (count != 0) state.counters[name] = count;
    };
    add("mul", f.count.mul);
    add("add", f.count.add);
    add("div", f.count.div);
    add("sqrt", f.count.sqrt);
    add("sincos", f.count.sincos);
    add("instructions", f.count.instructions);
    add("critical_path", f.count.critical_path);
  }
}

// Times call(state) over all states in turn. Robot and states must outlive the benchmarks.
template <class R, class Call>
void add(
    const Robot& robot,
    const std::vector<State<R>>& states,
    const std::string& name,
    const std::string& kernel,
    Call call) {
  benchmark::RegisterBenchmark(name.c_str(), [&robot, &states, kernel, call](benchmark::State& state) {
    std::size_t next = 0;
    for (auto _ : state) {
      auto result = call(states[next]);
      benchmark::DoNotOptimize(result);
      next = (next + 1) % kStates;
    }
    add_counts(state, robot, kernel);
  });
}

// Sines and cosines of the joints in each state.
template <class R>
auto trigonometry_of(const std::vector<State<R>>& states) {
  std::vector<typename R::JointTrigonometry> all;
  for (const State<R>& s : states) {
    if constexpr (reference::kIsParametric<R>) {
      all.emplace_back(s.robot->parameters, s.q);
    } else {
      all.emplace_back(s.q);
    }
  }
  return all;
}

// Times call(state, q), and, as `<name>/given_trig`, the same call with known sines and cosines in place of q.
template <class R, class Call>
void add_with_trigonometry(
    const Robot& robot,
    const std::vector<State<R>>& states,
    const std::string& name,
    const std::string& kernel,
    Call call) {
  add<R>(robot, states, name, kernel, [call](const State<R>& s) { return call(s, s.q); });
  const State<R>* first = states.data();
  add<R>(
      robot, states, name + "/given_trig", kernel, [call, first, all = trigonometry_of<R>(states)](const State<R>& s) {
        return call(s, all[static_cast<std::size_t>(&s - first)]);
      });
}

// Inverse dynamics as compared with other libraries: for a floating base, the acceleration of the base is given. `q`
// may be joint positions with sines and cosines.
template <class R, class Positions>
auto inverse_dynamics(const State<R>& s, const Positions& q) {
  if constexpr (R::kFloatingBase) {
    return s.robot->inverse_dynamics_fully_actuated(
        q, s.qd, s.qdd, s.base_velocity, s.base_acceleration, kStandardGravity);
  } else {
    return s.robot->inverse_dynamics(q, s.qd, s.qdd);
  }
}

template <class R, class Positions>
auto forward_dynamics(const State<R>& s, const Positions& q) {
  if constexpr (R::kFloatingBase) {
    return s.robot->forward_dynamics(q, s.qd, s.tau, s.base_velocity, kStandardGravity);
  } else {
    return s.robot->forward_dynamics(q, s.qd, s.tau);
  }
}

template <class R>
constexpr const char* kInverseDynamics = R::kFloatingBase ? "inverse_dynamics_fully_actuated" : "inverse_dynamics";

template <class R>
void add_inverse_dynamics(const Robot& robot, const std::vector<State<R>>& states) {
  const char* compared = kInverseDynamics<R>;
  benchmark::AddCustomContext("compared/inverse_dynamics", compared);
  if constexpr (R::kFloatingBase) {
    add_with_trigonometry<R>(
        robot, states, "inverse_dynamics", "inverse_dynamics", [](const State<R>& s, const auto& q) {
          return s.robot->inverse_dynamics(q, s.qd, s.qdd, s.base_velocity, kStandardGravity);
        });
  }
  add_with_trigonometry<R>(
      robot, states, compared, compared, [](const State<R>& s, const auto& q) { return inverse_dynamics<R>(s, q); });
}

template <class R>
void add_forward_dynamics(const Robot& robot, const std::vector<State<R>>& states) {
  benchmark::AddCustomContext("compared/forward_dynamics", "forward_dynamics");
  add_with_trigonometry<R>(robot, states, "forward_dynamics", "forward_dynamics", [](const State<R>& s, const auto& q) {
    return forward_dynamics<R>(s, q);
  });
}

template <class R>
void add_inertia_matrix(const Robot& robot, const std::vector<State<R>>& states) {
  benchmark::AddCustomContext("compared/inertia_matrix", "joint_space_inertia");
  add_with_trigonometry<R>(
      robot, states, "joint_space_inertia", "joint_space_inertia",
      [](const State<R>& s, const auto& q) { return s.robot->joint_space_inertia(q); });
}

// The factor and a solution, and the cost of a dense factor of the same matrix.
template <class R>
void add_inertia_factor(const Robot& robot, const std::vector<State<R>>& states) {
  using InertiaMatrix = typename R::InertiaMatrix;
  using Vector = Eigen::Matrix<typename R::Scalar, InertiaMatrix::RowsAtCompileTime, 1>;
  add_with_trigonometry<R>(
      robot, states, "joint_space_inertia_factor", "joint_space_inertia_factor",
      [](const State<R>& s, const auto& q) { return s.robot->joint_space_inertia_factor(q); });
  add<R>(
      robot, states, "inertia_factor::solve", "inertia_factor_solve",
      [factor = states[0].robot->joint_space_inertia_factor(states[0].q)](const State<R>& s) {
        Vector x = Vector::Ones();
        x.template tail<R::kDof>() = s.tau;
        return factor.solve(x);
      });
  if constexpr (reference::kHasInertia && R::kDof > 0) {
    add<R>(robot, states, "joint_space_inertia, Eigen's LLT", "", [](const State<R>& s) {
      return Eigen::LLT<InertiaMatrix>(s.robot->joint_space_inertia(s.q));
    });
    add<R>(
        robot, states, "Eigen's LLT::solve", "",
        [dense = Eigen::LLT<InertiaMatrix>(states[0].robot->joint_space_inertia(states[0].q))](const State<R>& s) {
          Vector x = Vector::Ones();
          x.template tail<R::kDof>() = s.tau;
          return Vector(dense.solve(x));
        });
  }
}

template <class R>
void add_bias_forces(const Robot& robot, const std::vector<State<R>>& states) {
  add_with_trigonometry<R>(robot, states, "bias_forces", "bias_forces", [](const State<R>& s, const auto& q) {
    if constexpr (R::kFloatingBase) {
      return s.robot->bias_forces(q, s.qd, s.base_velocity, kStandardGravity);
    } else {
      return s.robot->bias_forces(q, s.qd);
    }
  });
}

// Number of joints between two links: joints that support one of them and not the other.
inline int chain_length(const Robot& robot, int a, int b) {
  std::vector<int> left = reference::supporting_joints(robot, a);
  std::vector<int> right = reference::supporting_joints(robot, b);
  while (!left.empty() && !right.empty() && left.back() == right.back()) {  // both lists end at the base
    left.pop_back();
    right.pop_back();
  }
  return static_cast<int>(left.size() + right.size());
}

// The first of the transforms with the longest chain; null if there is none.
inline const reflection::Transform* longest_transform(const Robot& robot) {
  const reflection::Transform* longest = nullptr;
  int length = -1;
  for (const reflection::Transform& t : robot.transforms) {
    const int joints = chain_length(robot, robot.frames[t.left].link, robot.frames[t.right].link);
    if (joints > length) {
      longest = &t;
      length = joints;
    }
  }
  return longest;
}

// The first of the Jacobians with the most columns; null if there is none.
inline const reflection::Jacobian* widest_jacobian(const Robot& robot) {
  const reflection::Jacobian* widest = nullptr;
  for (const reflection::Jacobian& j : robot.jacobians) {
    if (widest == nullptr || j.column_count > widest->column_count) widest = &j;
  }
  return widest;
}

// The link of the robot's URDF with the same origin as the frame; empty if there may be none.
inline std::string urdf_link(const Robot& robot, int frame) {
  const std::string name = robot.frames[frame].name;
  const auto is = [&](const std::string& other) { return name == other; };
  for (const reflection::Joint& joint : robot.joints) {
    if (is(std::string("fr_") + joint.name)) return "";
  }
  for (const reflection::Link& link : robot.links) {
    if (!is(std::string("fr_") + link.name)) continue;
    // A user frame with the link's own name replaces the link in the URDF.
    for (const reflection::Frame& other : robot.frames) {
      if (std::string(other.name) == link.name) return "";
    }
    return link.name;
  }
  return name;  // a user frame
}

inline bool is_base(const reflection::Frame& frame) {
  const auto zero = [](double x) { return x == 0; };
  return frame.link == 0 && std::all_of(frame.translation, frame.translation + 3, zero) &&
         std::all_of(frame.rotation, frame.rotation + 3, zero);
}

// The widest Jacobian that other libraries compute too: from the base to a link of the URDF. Null if there is none.
inline const reflection::Jacobian* compared_jacobian(const Robot& robot) {
  const reflection::Jacobian* widest = nullptr;
  for (const reflection::Jacobian& j : robot.jacobians) {
    if (!is_base(robot.frames[j.left]) || urdf_link(robot, j.right).empty()) continue;
    if (widest == nullptr || j.column_count > widest->column_count) widest = &j;
  }
  return widest;
}

// The transform between the same frames; null if there is none.
inline const reflection::Transform* compared_transform(const Robot& robot) {
  const reflection::Jacobian* jacobian = compared_jacobian(robot);
  for (const reflection::Transform& t : robot.transforms) {
    if (jacobian != nullptr && t.left == jacobian->left && t.right == jacobian->right) return &t;
  }
  return nullptr;
}

inline std::string benchmark_name(const reflection::Jacobian& jacobian) {
  return std::string("jacobian/") + jacobian.name;
}

inline std::string benchmark_name(const reflection::Transform& transform) {
  return std::string("homogeneous/") + transform.name;
}

inline std::string kernel_name(const reflection::Jacobian& jacobian) {
  return jacobian.name;
}

inline std::string kernel_name(const reflection::Transform& transform) {
  return std::string("homogeneous_") + transform.name;
}

// Adds `<name>/given_trig` for a function of positions only, from the library's table.
template <class R, class Matrix>
void add_core(
    const Robot& robot,
    const std::vector<State<R>>& states,
    const std::string& name,
    const std::string& kernel) {
  for (const reflection::Function& f : robot.functions) {
    if (kernel != f.name || f.call_core == nullptr || reference::kIsParametric<R>) continue;
    const State<R>* first = states.data();
    add<R>(
        robot, states, name + "/given_trig", kernel,
        [first, core = f.call_core, all = trigonometry_of<R>(states)](const State<R>& s) {
          const auto& at = all[static_cast<std::size_t>(&s - first)];
          Matrix result;
          core(s.q.data(), at.sin_data(), at.cos_data(), result.data());
          return result;
        });
  }
}

template <class R>
void add_jacobian(const Robot& robot, const std::vector<State<R>>& states, const reflection::Jacobian& jacobian) {
  add<R>(robot, states, benchmark_name(jacobian), jacobian.name, [kernel = jacobian.kernel](const State<R>& s) {
    Eigen::Matrix<double, 6, R::kDof> J;
    kernel(reference::cache_of(*s.robot), s.q.data(), J.data());
    return J;
  });
  add_core<R, Eigen::Matrix<double, 6, R::kDof>>(robot, states, benchmark_name(jacobian), jacobian.name);
}

template <class R>
void add_homogeneous(const Robot& robot, const std::vector<State<R>>& states, const reflection::Transform& transform) {
  const std::string kernel = kernel_name(transform);
  add<R>(robot, states, benchmark_name(transform), kernel, [call = transform.homogeneous](const State<R>& s) {
    Eigen::Matrix4d X;
    call(reference::cache_of(*s.robot), s.q.data(), X.data());
    return X;
  });
  add_core<R, Eigen::Matrix4d>(robot, states, benchmark_name(transform), kernel);
}

// The arguments that are not null, each once.
template <class T>
std::vector<const T*> distinct(const T* first, const T* second) {
  std::vector<const T*> all;
  if (first != nullptr) all.push_back(first);
  if (second != nullptr && second != first) all.push_back(second);
  return all;
}

// The measured elements of the tables, which are empty if a group is missing.
inline std::vector<const reflection::Transform*> measured_transforms(const Robot& robot) {
  return distinct(longest_transform(robot), compared_transform(robot));
}
inline std::vector<const reflection::Jacobian*> measured_jacobians(const Robot& robot) {
  return distinct(widest_jacobian(robot), compared_jacobian(robot));
}

template <class R>
void add_kinematics(const Robot& robot, const std::vector<State<R>>& states) {
  for (const reflection::Transform* transform : measured_transforms(robot))
    add_homogeneous<R>(robot, states, *transform);
  if (const reflection::Transform* longest = longest_transform(robot)) {
    const std::string name = longest->name;
    add<R>(robot, states, "motion/" + name, "motion_" + name, [longest](const State<R>& s) {
      Eigen::Matrix<double, 6, 6> X;
      longest->motion(reference::cache_of(*s.robot), s.q.data(), X.data());
      return X;
    });
    add_core<R, Eigen::Matrix<double, 6, 6>>(robot, states, "motion/" + name, "motion_" + name);
  }
  for (const reflection::Jacobian* jacobian : measured_jacobians(robot)) add_jacobian<R>(robot, states, *jacobian);
  if (const reflection::Transform* compared = compared_transform(robot))
    benchmark::AddCustomContext("compared/transform", benchmark_name(*compared));
  if (const reflection::Jacobian* compared = compared_jacobian(robot))
    benchmark::AddCustomContext("compared/jacobian", benchmark_name(*compared));
}

}  // namespace robcogen::bench
