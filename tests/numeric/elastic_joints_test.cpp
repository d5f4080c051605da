// Series-elastic joints: the programs against the equations of Spong's model, which are assembled here from the
// reference of the rigid robot; energy; what remains when one of the two coordinates is locked.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "algorithm/dynamics/dynamics.h"
#include "document_tree.h"
#include "export/elastic_joints.h"
#include "export/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "model/changes.h"
#include "runge_kutta.h"

namespace robcogen::numeric::elastic_joints_test {
namespace {

using model::KinematicTree;
using reference::Matrix;
using reference::Motion;
using reference::Vector;

constexpr double kSame = 1e-12;  // relative: sums of few products in double precision

// An arm that turns, turns and slides. `drives`: those of the three joints.
std::string arm(const std::vector<std::string>& drives, const std::string& more = "") {
  return R"(Robot Arm {
    RobotBase base { children { a via one } }
    link a { id = 1 inertia_params { mass = 2.0 CoM = (0.2, 0.01, -0.03) Ix = 0.02 Iy = 0.11 Iz = 0.12 Ixy = 0.003 Ixz = 0.0 Iyz = 0.001 } children { b via two } }
    link b { id = 2 inertia_params { mass = 1.5 CoM = (0.1, -0.02, 0.04) Ix = 0.03 Iy = 0.05 Iz = 0.06 Ixy = 0.0 Ixz = 0.002 Iyz = 0.0 } children { c via three } }
    link c { id = 3 inertia_params { mass = 0.7 CoM = (0.05, 0.0, 0.1) Ix = 0.01 Iy = 0.02 Iz = 0.015 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }
    r_joint one { ref_frame { translation = (0.0, 0.0, 0.5) rotation = (-PI/2.0, 0.3, 0.0) } )" +
         drives[0] + R"( }
    r_joint two { ref_frame { translation = (0.4, 0.0, 0.1) rotation = (0.4, 0.0, 0.2) } )" +
         drives[1] + R"( }
    p_joint three { ref_frame { translation = (0.3, 0.0, 0.0) rotation = (0.0, 1.0, 0.0) } )" +
         drives[2] + " }\n" + more + "}\n";
}

// Of joint, in SI units: stiffness, damping, inertia of the motor; damping of the link.
struct Elastic {
  double K, D, B, d;
};
const std::vector<Elastic> kElastic = {{150, 0.7, 0.3, 0.1}, {90, 0.0, 0.12, 0.0}, {2000, 3.0, 1.1, 4.0}};

std::string text_of(const Elastic& e, bool is_elastic) {
  const std::string damping = " damping = " + std::to_string(e.d);
  return is_elastic ? "armature = " + std::to_string(e.B) + " elastic { stiffness = " + std::to_string(e.K) +
                          " damping = " + std::to_string(e.D) + " }" + damping
                    : damping;
}

std::vector<std::string> texts(bool are_elastic) {
  std::vector<std::string> result;
  for (const Elastic& e : kElastic) result.push_back(text_of(e, are_elastic));
  return result;
}

Vector<double> numbers(std::uint64_t seed, int count) {
  std::mt19937_64 engine(seed);
  return reference::uniform_vector(engine, count, 1.5);
}

Motion<double> motion_of(const Vector<double>& q, const Vector<double>& qd) {
  Motion<double> m = reference::at_rest(q);
  m.qd = qd;
  return m;
}

double relative(const Vector<double>& found, const Vector<double>& expected) {
  return reference::largest(found - expected) / std::max(reference::largest(expected), 1e-300);
}

TEST(ElasticJoints, HaveACoordinateForTheirMotorAfterAllJoints) {
  const KinematicTree robot = tree_of_text(arm(texts(true)));
  std::vector<std::string> names;
  for (const model::Joint& joint : robot.joints) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"one", "two", "three", "one_motor", "two_motor", "three_motor"}));
  EXPECT_FALSE(robot.inertia_defects.is_singular());
  // Nothing of the motors is among the frames that functions have by default.
  for (const model::Frame& frame : model::link_and_user_frames(robot))
    EXPECT_EQ(frame.name.find("motor"), std::string::npos) << frame.name;
}

// M(q) qdd + h(q, qd) = tau + K (theta - q) + D (thetad - qd), and B thetadd = tau_m - K (theta - q) - D (thetad - qd)
// (Spong 1987), with M and h of the rigid robot without motors.
TEST(ElasticJoints, FollowTheEquationsOfSpong) {
  const KinematicTree elastic = tree_of_text(arm(texts(true))), rigid = tree_of_text(arm(texts(false)));
  const reference::Tables tables = reference_tables(rigid);
  for (const std::vector<std::string>& steps : {std::vector<std::string>(), all_steps()}) {
    const InterpretedRobot subject(elastic, {}, steps);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Vector<double> q = numbers(seed, 6), qd = numbers(seed + 100, 6), tau = numbers(seed + 200, 6);
      const Motion<double> of_links = motion_of(q.head(3), qd.head(3));
      const Matrix<double> M = reference::joint_space_inertia(tables.robot(), of_links.q);
      const Vector<double> h =
          reference::bias_forces(tables.robot(), of_links, reference::loads<double>(Vector<double>{0, 0, -9.81})).tau;
      Vector<double> force(3), of_motors(3);
      for (int k = 0; k < 3; ++k) {
        const Elastic& e = kElastic[static_cast<std::size_t>(k)];
        const double spring = e.K * (q(3 + k) - q(k)) + e.D * (qd(3 + k) - qd(k));
        force(k) = tau(k) + spring - h(k);
        of_motors(k) = (tau(3 + k) - spring) / e.B;
      }
      const Vector<double> expected = stacked(reference::solve(M, force), of_motors);
      const Vector<double> found = subject.forward_dynamics(motion_of(q, qd), tau, {});
      EXPECT_LT(relative(found, expected), 100 * kSame) << "seed " << seed;
      Motion<double> m = motion_of(q, qd);
      m.qdd = expected;
      EXPECT_LT(relative(subject.inverse_dynamics(m, {}), tau), 1000 * kSame) << "seed " << seed;
      // H has the inertia of the motors on its diagonal, and no other element of theirs.
      const Matrix<double> H = subject.joint_space_inertia(q);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          const double wanted = i < 3 && j < 3 ? M(i, j) : i == j ? kElastic[static_cast<std::size_t>(i) - 3].B : 0.0;
          EXPECT_NEAR(H(i, j), wanted, 1e-13) << i << j;
        }
    }
  }
}

// At the deflection at which the spring accelerates both together, they move as the rigid joint with its armature.
TEST(ElasticJoints, AccelerateWithTheirMotorsAsRigidJointsDo) {
  const auto armature = [](double B) { return "armature = " + std::to_string(B); };
  const auto stiff = [&](double B) { return armature(B) + " elastic { stiffness = 1.0e6 }"; };
  const InterpretedRobot rigid(tree_of_text(arm({armature(0.3), armature(0.1), armature(1.0)})), {}),
      elastic(tree_of_text(arm({stiff(0.3), stiff(0.1), stiff(1.0)})), {});
  const Vector<double> q = numbers(1, 3), qd = numbers(2, 3), tau = numbers(3, 3), B{0.3, 0.1, 1.0};
  const Vector<double> qdd = rigid.forward_dynamics(motion_of(q, qd), tau, {});
  Vector<double> theta = q;
  for (int k = 0; k < 3; ++k) theta(k) += (tau(k) - B(k) * qdd(k)) / 1e6;
  const Vector<double> found =
      elastic.forward_dynamics(motion_of(stacked(q, theta), stacked(qd, qd)), stacked(Vector<double>(3), tau), {});
  EXPECT_LT(relative(found, stacked(qdd, qdd)), 1e-8);  // the deflection is a difference of positions near 1
}

// A swing without damping: the energy of the robot and that of the springs, which the potential energy leaves out.
TEST(ElasticJoints, KeepTheirEnergy) {
  std::vector<Elastic> springs = kElastic;
  std::vector<std::string> drives;
  for (Elastic& e : springs) {
    e.D = e.d = 0;
    drives.push_back(text_of(e, true));
  }
  const InterpretedRobot robot(tree_of_text(arm(drives)), {});
  Vector<double> q{0.3, -0.4, 0.05, 0.5, -0.4, 0.06}, qd(6);
  const auto energy = [&] {
    double sum = robot.kinetic_energy(motion_of(q, qd)) + robot.potential_energy(q, {});
    for (int k = 0; k < 3; ++k) sum += springs[static_cast<std::size_t>(k)].K * std::pow(q(3 + k) - q(k), 2) / 2;
    return sum;
  };
  const double before = energy();
  double most_kinetic = 0;
  for (int step = 0; step < 500; ++step) {
    runge_kutta_step(
        1e-3,
        [&](const auto& at, const auto& rate) {
          return robot.forward_dynamics(motion_of(at, rate), Vector<double>(6), {});
        },
        q, qd);
    most_kinetic = std::max(most_kinetic, robot.kinetic_energy(motion_of(q, qd)));
  }
  EXPECT_GT(most_kinetic, 0.1);
  EXPECT_LT(std::abs(energy() - before), 1e-7 * most_kinetic);
}

// ---- Locks and parameters.

KinematicTree changed(const std::string& text, const model::Changes& changes) {
  Diagnostics diagnostics;
  const auto read = import::robot_document(std::make_shared<const Source>("robot.kindsl", text), {}, diagnostics);
  auto tree = read ? import::kinematic_tree(read->document, changes, diagnostics) : std::nullopt;
  if (!tree) throw std::runtime_error(diagnostics.render());
  return *std::move(tree);
}

void expect_same_dynamics(const KinematicTree& a, const KinematicTree& b) {
  ASSERT_EQ(a.dof(), b.dof());
  const InterpretedRobot first(a, {}), second(b, {});
  const Vector<double> q = numbers(5, a.dof()), qd = numbers(6, a.dof()), tau = numbers(7, a.dof());
  EXPECT_LT(
      relative(first.forward_dynamics(motion_of(q, qd), tau, {}), second.forward_dynamics(motion_of(q, qd), tau, {})),
      kSame);
}

model::Changes lock(const std::string& joint, double position) {
  model::Changes changes;
  changes.locks.push_back({{joint, {}}, model::Quantity(position), {}});
  return changes;
}

TEST(ElasticJoints, WithALockedMotorHaveASpring) {
  const std::string elastic = arm({"", "armature = 0.2 elastic { stiffness = 80.0 damping = 0.5 }", ""});
  const std::string spring = arm({"", "damping = 0.5 spring { stiffness = 80.0 rest = 0.25 }", ""});
  expect_same_dynamics(changed(elastic, lock("two_motor", 0.25)), tree_of_text(spring));
}

TEST(ElasticJoints, ThatAreLockedLeaveAMotorOnASpring) {
  const std::string elastic = arm({"", "", "armature = 0.2 elastic { stiffness = 80.0 damping = 0.5 }"});
  const KinematicTree tree = changed(elastic, lock("three", 0.1));
  const InterpretedRobot robot(tree, {});
  const Vector<double> q{0.2, 0.3, 0.15}, qd{0.0, 0.0, 0.4};
  const Vector<double> qdd = robot.forward_dynamics(motion_of(q, qd), Vector<double>{0.0, 0.0, 7.0}, {});
  EXPECT_NEAR(qdd(2), (7.0 - 80 * (0.15 - 0.1) - 0.5 * 0.4) / 0.2, 1e-11);
}

TEST(ElasticJoints, AreKeptWithTheirMotors) {
  model::Changes changes;
  changes.kept.push_back({"two", {}});
  const KinematicTree tree = changed(arm({"", "armature = 0.2 elastic { stiffness = 80.0 }", ""}), changes);
  ASSERT_EQ(tree.dof(), 2);
  EXPECT_EQ(tree.joints[1].name, "two_motor");
  EXPECT_EQ(tree.tendons.size(), 1U);
}

TEST(ElasticJoints, HaveParameters) {
  model::Changes changes;
  changes.parameters = {{"two_elastic.stiffness", {}}, {"two.armature", {}}};
  const std::string text = arm({"", "armature = 0.2 elastic { stiffness = 80.0 }", ""});
  const KinematicTree tree = changed(text, changes);
  ASSERT_EQ(tree.parameters.size(), 2U);
  EXPECT_EQ(tree.parameters[0].name, "two_elastic_stiffness");
  EXPECT_EQ(tree.parameters[1].name, "two_motor_armature");
  const InterpretedRobot robot(tree, {}, {}, {60.0, 0.4});
  const InterpretedRobot other(tree_of_text(arm({"", "armature = 0.4 elastic { stiffness = 60.0 }", ""})), {});
  const Vector<double> q = numbers(1, 4), qd = numbers(2, 4), tau = numbers(3, 4);
  const Vector<double> expected = other.forward_dynamics(motion_of(q, qd), tau, {});
  EXPECT_LT(relative(robot.forward_dynamics(motion_of(q, qd), tau, {}), expected), kSame);
}

// ---- Loops.

// The text of the five-bar.
std::string five_bar() {
  std::ifstream file(std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / "five_bar" / "five_bar.kindsl");
  return {std::istreambuf_iterator<char>(file), {}};
}

void insert_behind(std::string& text, const std::string& place, const std::string& more) {
  const std::size_t found = text.find(place);
  ASSERT_NE(found, std::string::npos) << place;
  text.insert(found + place.size(), more);
}

// Three coordinates.
void expect_derivatives_are_differences(const KinematicTree& robot) {
  ASSERT_EQ(robot.dof(), 3);
  constexpr auto kLoads = algorithm::Loads::standard_gravity;
  const symbolic::Program dynamics =
      algorithm::forward_dynamics(robot, "f", kLoads, {algorithm::ForwardDynamicsMethod::inertia_matrix, {}});
  const symbolic::Program derivatives = algorithm::forward_dynamics_derivatives(robot, "d", kLoads);
  symbolic::Arrays<double> at = {{"q", {0.1, -0.05, 0.2}}, {"qd", {0.3, -0.4, 0.5}}, {"tau", {0.0, 1.0, -2.0}}};
  const symbolic::Arrays<double> found = symbolic::interpret(derivatives, at);
  for (const auto& [input, block] : {std::pair("q", "d_q"), std::pair("qd", "d_qd")})
    for (std::size_t column = 0; column < 3; ++column) {
      constexpr double kStep = 1e-4;
      const auto moved = [&, name = input](double steps) {
        symbolic::Arrays<double> there = at;
        there[name][column] += steps * kStep;
        return symbolic::interpret(dynamics, there).at("qdd");
      };
      const std::vector<double> a = moved(2), b = moved(1), c = moved(-1), d = moved(-2);
      for (std::size_t row = 0; row < 3; ++row) {
        const double expected = (8 * (b[row] - c[row]) - (a[row] - d[row])) / (12 * kStep);
        EXPECT_NEAR(found.at(block)[row + 3 * column], expected, 1e-6 * (1 + std::abs(expected)))
            << block << row << column;
      }
    }
}

// The derivatives of forward dynamics hold the acceleration of the motor, which is a multiple of a sum with the force
// of its spring.
TEST(ElasticJoints, MayMoveLoops) {
  std::string text = five_bar();
  insert_behind(text, "r_joint LEFT        {", " armature = 0.05 elastic { stiffness = 60.0 damping = 0.2 } ");
  const KinematicTree robot = tree_of_text(text);
  EXPECT_EQ(robot.coupling_of(*robot.find_joint("LEFT")), nullptr) << "its motor drives it";
  expect_derivatives_are_differences(robot);
}

// The same holds for a wheel beside a loop.
TEST(Wheels, MayHaveDampingBesideLoops) {
  std::string text = five_bar();
  insert_behind(text, "right_crank via RIGHT\n", "        wheel via SPIN\n");
  insert_behind(
      text, "Robot FiveBar {\n",
      "link wheel { id = 5 inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix = 0.01 Iy = 0.01 Iz = 0.02 "
      "Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }\n"
      "r_joint SPIN { ref_frame { translation = (0.0, 0.0, 0.3) rotation = (0.0, 0.0, 0.0) } damping = 0.5 }\n");
  expect_derivatives_are_differences(tree_of_text(text));
}

// ---- Export.

std::string document_of(const KinematicTree& tree) {
  return language::kinematics::print(exporting::with_elastic_joints(tree, exporting::kinematics_document(tree)));
}

TEST(ElasticJoints, AreWrittenAsOneJoint) {
  std::vector<std::string> drives = texts(true);
  drives[1] += " limits { position = (-1.0, 1.0) velocity = 3.0 effort = 9.0 }";
  drives[2] = "rotor { inertia = 1e-4 ratio = 50.0 axis = (1.0, 0.0, 0.0) } elastic { stiffness = 900.0 }";
  const KinematicTree robot = tree_of_text(arm(drives));
  const std::string text = document_of(robot);
  EXPECT_EQ(text.find("motor"), std::string::npos) << text;
  const KinematicTree again = tree_of_text(text);
  EXPECT_EQ(document_of(again), text);
  EXPECT_EQ(again.joints[4].name, "two_motor");
  EXPECT_EQ(again.joints[4].limits.effort, 9.0);
  EXPECT_EQ(again.joints[1].limits.velocity, 3.0);
  expect_same_dynamics(robot, again);
}

// A motor that has become something else stays a joint.
TEST(ElasticJoints, WithOtherMotorsAreWrittenAsTwoJoints) {
  const std::string elastic = "armature = 0.2 elastic { stiffness = 80.0 }";
  for (const std::string more :
       {"couplings { three = 0.1 m/rad * two_motor }",
        "tendons { cable { length = two_motor - one stiffness = 3.0 } }"}) {
    const KinematicTree robot = tree_of_text(arm({"", elastic, ""}, more));
    const std::string text = document_of(robot);
    EXPECT_NE(text.find("r_joint two_motor"), std::string::npos) << text;
    expect_same_dynamics(robot, tree_of_text(text));
  }
}

TEST(ElasticJoints, BecomeRigidForDocumentsWithoutThem) {
  const KinematicTree elastic = tree_of_text(arm(texts(true), "tendons { stop { length = three  stiffness = 5.0 } }"));
  const KinematicTree rigid = exporting::with_rigid_joints(elastic);
  EXPECT_EQ(rigid.tendons.size(), 1U);
  expect_same_dynamics(rigid, tree_of_text(arm(texts(false), "tendons { stop { length = three  stiffness = 5.0 } }")));
}

// ---- Parts.

// A mirrored leg has the mirrored positions, so that equal tendons pull equally.
TEST(ElasticJoints, MayBePartOfMirroredLimbs) {
  const std::string text = R"(
Part Leg {
    root thigh via hip
    link thigh { inertia_params { mass = 2.0 CoM = (0.1, 0.02, 0.0) Ix = 0.02 Iy = 0.1 Iz = 0.1 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children { shank via knee } }
    link shank { inertia_params { mass = 1.0 CoM = (0.1, 0.0, 0.03) Ix = 0.01 Iy = 0.05 Iz = 0.05 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }
    r_joint hip  { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (0.3, 0.0, 0.0) } armature = 0.1 elastic { stiffness = 50.0 } }
    r_joint knee { ref_frame { translation = (0.3, 0.0, 0.0) rotation = (0.0, 0.2, 0.0) } }
    tendons { muscle { length = hip_motor + 0.5 * knee  stiffness = 20.0  damping = 0.3  rest = 0.1 } }
}
Robot Biped {
    RobotBase trunk { children { Leg left()  Leg right() mirrored y same sense } }
    tendons { belt { length = left.knee - right_knee  stiffness = 7.0 } }
})";
  const KinematicTree robot = tree_of_text(text);
  std::vector<std::string> names;
  for (const model::Tendon& tendon : robot.tendons) names.push_back(tendon.name);
  EXPECT_EQ(
      names,
      (std::vector<std::string>{"left_hip_elastic", "right_hip_elastic", "belt", "left_muscle", "right_muscle"}));
  ASSERT_EQ(robot.joints[1].name, "left_knee");
  // left_hip left_knee right_hip right_knee left_hip_motor right_hip_motor
  const Vector<double> q{0.2, -0.4, -0.2, 0.4, 0.3, -0.3};
  const reference::Tables tables = reference_tables(robot);
  const InterpretedRobot subject(robot, {});
  const Vector<double> gravity{0, 0, -9.81};
  const Vector<double> tau = subject.inverse_dynamics(reference::at_rest(q), {&gravity, nullptr});
  EXPECT_NEAR(tau(0), -tau(2), 1e-12);
  EXPECT_NEAR(tau(4), -tau(5), 1e-12);
  EXPECT_NEAR(tau(4), 50 * (0.3 - 0.2) + 20 * (0.3 - 0.5 * 0.4 - 0.1), 1e-12);
}

// ---- Tendons that the document writes.

// tau of each joint changes by its factor times k (l - rest) + d dl/dt.
TEST(Tendons, PullAllTheirJoints) {
  const KinematicTree with = tree_of_text(
                          arm({"", "", ""},
                              "tendons { cable { length = 0.05 m/rad * one - 0.02 m/rad * two + 2.0 three + 0.01 "
                              "stiffness = 500.0 damping = 3.0 "
                              "rest = 0.2 } }")),
                      without = tree_of_text(arm({"", "", ""}));
  const InterpretedRobot subject(with, {});
  const reference::Tables tables = reference_tables(without);
  const Vector<double> q = numbers(1, 3), qd = numbers(2, 3), factors{0.05, -0.02, 2.0};
  Motion<double> m = motion_of(q, qd);
  m.qdd = numbers(3, 3);
  const double tension = 500 * (dot(factors, q) + 0.01 - 0.2) + 3 * dot(factors, qd);
  const auto loads = reference::loads<double>(Vector<double>{0, 0, -9.81});
  const Vector<double> expected = reference::inverse_dynamics(tables.robot(), m, loads).tau + tension * factors;
  EXPECT_LT(relative(subject.inverse_dynamics(m, {}), expected), kSame);
}

}  // namespace
}  // namespace robcogen::numeric::elastic_joints_test
