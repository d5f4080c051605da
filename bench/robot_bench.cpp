// The benchmark of one generated library: each function over 1,024 random states in turn. Compiled once a robot, with
//     ROBCOGEN_ROBOT_HEADER, ROBCOGEN_REFLECTION_HEADER   the generated headers, as <…>
//     ROBCOGEN_ROBOT_NAMESPACE                            the namespace of the generated code
//     ROBCOGEN_HAS_<GROUP>                                1 where the library has the group, else 0
//
// Each benchmark's label is the name of the kernel that it times, its counters are that kernel's operation counts.
#include <benchmark/benchmark.h>

#include ROBCOGEN_ROBOT_HEADER
#include ROBCOGEN_REFLECTION_HEADER

#include <algorithm>
#include <string>
#include <vector>

#include "robcogen/reference/samples.h"

namespace {

using robcogen::reflection::Robot;

// Enough that branch and value predictors learn nothing, little enough to stay in the first-level caches.
constexpr int kStates = 1024;
constexpr std::uint64_t kSeed = 20;

// The arguments of one call, in the types that the functions take.
template <class R>
struct State {
  typename R::JointState q, qd, qdd, tau;
  robcogen::Twist base_velocity;
  robcogen::SpatialAcceleration base_acceleration;
};

// To the types of the library, which store their elements one after another.
template <class To>
To converted(const robcogen::reference::Vector<double>& from) {
  To to;
  std::copy(from.data(), from.data() + from.rows(), to.data());
  return to;
}

template <class R>
std::vector<State<R>> random_states(const Robot& robot) {
  using Joints = typename R::JointState;
  std::mt19937_64 engine(kSeed);
  std::vector<State<R>> states;
  for (int i = 0; i < kStates; ++i) {
    const auto [q, qd, qdd, velocity, acceleration] = robcogen::reference::random_sample(engine, robot).motion;
    const auto tau = robcogen::reference::uniform_vector(engine, R::kDof, 50);
    states.push_back(
        {converted<Joints>(q), converted<Joints>(qd), converted<Joints>(qdd), converted<Joints>(tau),
         converted<robcogen::Twist>(velocity), converted<robcogen::SpatialAcceleration>(acceleration)});
  }
  return states;
}

void add_counts(benchmark::State& state, const Robot& robot, const std::string& kernel) {
  state.SetLabel(kernel);
  for (const robcogen::reflection::Function& f : robot.functions) {
    if (kernel != f.name) continue;
    // Zeros are left out: the library reports their coefficient of variation, 0 / 0, which is no JSON.
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

// Times call(state) over all states in turn.
template <class R, class Call>
void add(const Robot& robot, const std::string& name, const std::string& kernel, Call call) {
  benchmark::RegisterBenchmark(name.c_str(), [&robot, kernel, call](benchmark::State& state) {
    const std::vector<State<R>> states = random_states<R>(robot);
    std::size_t next = 0;
    for (auto _ : state) {
      auto result = call(states[next]);
      benchmark::DoNotOptimize(result);
      next = (next + 1) % kStates;
    }
    add_counts(state, robot, kernel);
  });
}

template <class R>
void add_inverse_dynamics(const Robot& robot) {
  if constexpr (R::kFloatingBase) {
    add<R>(robot, "inverse_dynamics", "inverse_dynamics", [](const State<R>& s) {
      return R::inverse_dynamics(s.q, s.qd, s.qdd, s.base_velocity);
    });
    add<R>(robot, "inverse_dynamics_fully_actuated", "inverse_dynamics_fully_actuated", [](const State<R>& s) {
      return R::inverse_dynamics_fully_actuated(s.q, s.qd, s.qdd, s.base_velocity, s.base_acceleration);
    });
  } else {
    add<R>(robot, "inverse_dynamics", "inverse_dynamics", [](const State<R>& s) {
      return R::inverse_dynamics(s.q, s.qd, s.qdd);
    });
  }
}

template <class R>
void add_forward_dynamics(const Robot& robot) {
  add<R>(robot, "forward_dynamics", "forward_dynamics", [](const State<R>& s) {
    if constexpr (R::kFloatingBase) {
      return R::forward_dynamics(s.q, s.qd, s.tau, s.base_velocity);
    } else {
      return R::forward_dynamics(s.q, s.qd, s.tau);
    }
  });
}

template <class R>
void add_bias_forces(const Robot& robot) {
  add<R>(robot, "bias_forces", "bias_forces", [](const State<R>& s) {
    if constexpr (R::kFloatingBase) {
      return R::bias_forces(s.q, s.qd, s.base_velocity);
    } else {
      return R::bias_forces(s.q, s.qd);
    }
  });
}

template <class R>
void add_inertia_matrix(const Robot& robot) {
  add<R>(robot, "joint_space_inertia", "joint_space_inertia", [](const State<R>& s) {
    return R::joint_space_inertia(s.q);
  });
}

// Joints between two links: those that support one of them and not the other.
int chain_length(const Robot& robot, int a, int b) {
  std::vector<int> left = robcogen::reference::supporting_joints(robot, a);
  std::vector<int> right = robcogen::reference::supporting_joints(robot, b);
  while (!left.empty() && !right.empty() && left.back() == right.back()) {  // both lists end at the base
    left.pop_back();
    right.pop_back();
  }
  return static_cast<int>(left.size() + right.size());
}

// The transform with the longest chain, in two of its forms, and the Jacobian with most columns; the first of equals.
template <class R>
void add_kinematics(const Robot& robot) {
  const robcogen::reflection::Transform* longest = nullptr;
  int length = -1;
  for (const robcogen::reflection::Transform& t : robot.transforms) {
    const int joints = chain_length(robot, robot.frames[t.left].link, robot.frames[t.right].link);
    if (joints > length) {
      longest = &t;
      length = joints;
    }
  }
  if (longest != nullptr) {
    const std::string name = longest->name;
    add<R>(robot, "homogeneous/" + name, "homogeneous_" + name, [longest](const State<R>& s) {
      Eigen::Matrix4d X;
      longest->homogeneous(s.q.data(), X.data());
      return X;
    });
    add<R>(robot, "motion/" + name, "motion_" + name, [longest](const State<R>& s) {
      Eigen::Matrix<double, 6, 6> X;
      longest->motion(s.q.data(), X.data());
      return X;
    });
  }

  const robcogen::reflection::Jacobian* widest = nullptr;
  for (const robcogen::reflection::Jacobian& j : robot.jacobians) {
    if (widest == nullptr || j.column_count > widest->column_count) widest = &j;
  }
  if (widest != nullptr) {
    const std::string name = widest->name;
    add<R>(robot, "jacobian/" + name, name, [widest](const State<R>& s) {
      Eigen::Matrix<double, 6, R::kDof> J;
      widest->kernel(s.q.data(), J.data());
      return J;
    });
  }
}

template <class R>
void add_all(const Robot& robot) {
  if constexpr (ROBCOGEN_HAS_INVERSE_DYNAMICS) add_inverse_dynamics<R>(robot);
  if constexpr (ROBCOGEN_HAS_FORWARD_DYNAMICS) add_forward_dynamics<R>(robot);
  if constexpr (ROBCOGEN_HAS_JOINT_SPACE_INERTIA) add_inertia_matrix<R>(robot);
  if constexpr (ROBCOGEN_HAS_BIAS_FORCES) add_bias_forces<R>(robot);
  add_kinematics<R>(robot);  // the tables are empty where a group is missing
}

}  // namespace

int main(int argc, char** argv) {
  namespace generated = ROBCOGEN_ROBOT_NAMESPACE;
  benchmark::AddCustomContext("robot", generated::reflection::robot.name);
  add_all<generated::Robot>(generated::reflection::robot);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
