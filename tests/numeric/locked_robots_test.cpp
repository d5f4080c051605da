// Robots with locked joints, against the same robots with all joints, the locked ones of which do not move.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coupled_robot.h"
#include "dice.h"
#include "export/kinematics.h"
#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "looped_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/kinematics.h"
#include "spherical_robot.h"
#include "volume.h"

namespace robcogen::numeric::locked_robots_test {
namespace {

using model::KinematicTree;
using reference::Matrix;
using reference::Motion;
using reference::Vector;

// For trees of up to 25 links within some metres. Lumped masses and placements are computed in another order.
constexpr double kSame = 1e-10;
constexpr int kShards = 10;

// With ROBCOGEN_TEST_EVERYTHING, 300.
int locked_count() {
  return std::max(50, robot_count() / 5);
}

KinematicTree tree_of(const language::kinematics::Document& document, const model::Changes& changes) {
  Diagnostics diagnostics;
  auto tree = import::kinematic_tree(document, changes, diagnostics);
  if (!tree) throw std::runtime_error(diagnostics.render());
  return *std::move(tree);
}

using Positions = std::map<std::string, std::vector<double>>;  // of the locked joints; four numbers for a quaternion

model::Changes changes_of(const Positions& positions) {
  model::Changes changes;
  for (const auto& [name, values] : positions) {
    model::Lock lock = {{name, {}}, model::Quantity(values.front())};
    if (values.size() == 4) {
      lock.quaternion.emplace();
      for (std::size_t k = 0; k < 4; ++k) (*lock.quaternion)[k] = model::Quantity(values[k]);
    }
    changes.locks.push_back(lock);
  }
  return changes;
}

// Positions of about a third of the coordinates. At least one remains.
Positions random_positions(const KinematicTree& tree, Dice& dice, double largest = 3.0) {
  Positions positions;
  int left = tree.dof();
  for (const int joint : tree.coordinates()) {
    const model::Joint& own = tree.joints[static_cast<std::size_t>(joint)];
    const int components = own.spherical.empty() ? 1 : 3;
    if (!own.is_first() || left <= components || !dice.chance(0.4)) continue;
    left -= components;
    const double limit = model::turns(own.type) ? largest : 0.3 * largest;
    auto& values = positions[own.declared_name()];
    for (int k = components; k >= (components == 1 ? 1 : 0); --k)
      values.push_back(own.assembled_position() + dice.between(-limit, limit));
    if (components == 1 && dice.chance(0.3) && largest > 1.0) values.front() = 0.0;
  }
  return positions;
}

// A motion of the reduced robot as one of the whole robot. All other coordinates are locked.
class Whole {
 public:
  Whole(const KinematicTree& whole, const KinematicTree& reduced, const Positions& positions)
      : whole_(whole), reduced_(reduced), positions_(positions) {}

  // By coordinate of the reduced robot: that of the whole robot.
  std::vector<int> coordinates() const {
    std::vector<int> result;
    for (const int joint : reduced_.coordinates())
      for (std::size_t j = 0; j < whole_.joints.size(); ++j)
        if (whole_.joints[j].name == reduced_.joints[static_cast<std::size_t>(joint)].name)
          result.push_back(whole_.coordinate_of(static_cast<int>(j)));
    return result;
  }

  Motion<double> motion(const Motion<double>& m) const {
    Motion<double> result = m;
    result.q = Vector<double>(whole_.position_count());
    result.qd = result.qdd = Vector<double>(whole_.dof());
    const std::vector<std::string> names = position_names(whole_), kept = position_names(reduced_);
    for (int k = 0; k < result.q.rows(); ++k) {
      const auto found = std::find(kept.begin(), kept.end(), names[static_cast<std::size_t>(k)]);
      if (found != kept.end()) result.q(k) = m.q(static_cast<int>(found - kept.begin()));
    }
    const std::vector<int> elements = whole_.position_elements();
    for (const auto& [name, values] : positions_) {
      const int first = elements[static_cast<std::size_t>(*whole_.find_joint(name))];
      const double length = std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
      for (int k = 0; k < static_cast<int>(values.size()); ++k)
        result.q(values.size() == 1 ? first : first - 1 + k) =
            values.size() == 1 ? values[0] : values[static_cast<std::size_t>(k)] / length;
    }
    const std::vector<int> columns = coordinates();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      result.qd(columns[c]) = m.qd(static_cast<int>(c));
      result.qdd(columns[c]) = m.qdd(static_cast<int>(c));
    }
    return result;
  }

  // The rows of the kept coordinates, after those of a floating base.
  Vector<double> rows(const Vector<double>& all) const {
    const int base = whole_.floating_base ? 6 : 0;
    const std::vector<int> columns = coordinates();
    Vector<double> result(base + static_cast<int>(columns.size()));
    for (int k = 0; k < base; ++k) result(k) = all(k);
    for (std::size_t c = 0; c < columns.size(); ++c) result(base + static_cast<int>(c)) = all(base + columns[c]);
    return result;
  }
  Matrix<double> block(const Matrix<double>& all) const {
    const Matrix<double> some = columns(all);
    return transpose(columns(transpose(some)));
  }

 private:
  Matrix<double> columns(const Matrix<double>& all) const {
    Matrix<double> result(whole_.floating_base ? 6 + reduced_.dof() : reduced_.dof(), all.cols());
    for (int c = 0; c < all.cols(); ++c) {
      const Vector<double> column = rows(Vector<double>(all.col(c)));
      for (int r = 0; r < column.rows(); ++r) result(r, c) = column(r);
    }
    return result;
  }

  const KinematicTree& whole_;
  const KinematicTree& reduced_;
  const Positions& positions_;
};

double relative(const Matrix<double>& found, const Matrix<double>& wanted) {
  return reference::largest(found - wanted) / (1 + reference::largest(wanted));
}

// Every frame of the whole robot is a frame of the reduced one, and in the same place.
void expect_same_frames(
    const KinematicTree& whole,
    const KinematicTree& reduced,
    const reference::Tables& tables,
    const reference::Tables& fewer,
    const Vector<double>& q_of_whole,
    const Vector<double>& q) {
  const model::Frame base = *whole.find_frame(model::implicit_frame_name(whole.links[0].name));
  for (const model::Frame& frame : whole.frames()) {
    const auto same = reduced.find_frame(frame.name);
    ASSERT_TRUE(same) << frame.name;
    const Matrix<double> wanted = reference::transform(
                             tables.robot(), q_of_whole, frame_index(whole, base), frame_index(whole, frame)),
                         found = reference::transform(
                             fewer.robot(), q, frame_index(reduced, base), frame_index(reduced, *same));
    EXPECT_LT(relative(found, wanted), 1e-12) << frame.name;
  }
}

// Values of the parameters: each mass property is larger in the same ratio, so that it remains that of a body.
std::vector<double> larger_than_defaults(const KinematicTree& tree) {
  std::vector<double> values;
  for (const model::Parameter& p : tree.parameters)
    values.push_back(*p.default_value * (p.name.find("_com_") == std::string::npos ? 1.25 : 1.0));
  return values;
}

class LockedRobots : public testing::TestWithParam<int> {};

TEST_P(LockedRobots, MoveLikeTheWholeRobot) {
  for (int i = GetParam(); i < locked_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    Dice dice(seed + 1000);
    KinematicTree made = random_robot(seed, {.min_joints = 2, .max_joints = 20});
    if (i % 2 == 0) made = with_random_drives(std::move(made), seed);
    if (i % 3 == 0) made = with_spherical_joints(made, seed, false);
    if (i % 3 == 1) made = coupled(made, seed).robot;
    const language::kinematics::Document document = exporting::kinematics_document(made);
    // Some masses are parameters, too.
    model::Changes parametric;
    if (i % 5 == 0) parametric.parameters.push_back({"*.inertia", {}});
    const KinematicTree whole = tree_of(document, parametric);
    const Positions positions = random_positions(whole, dice);
    model::Changes changes = changes_of(positions);
    changes.parameters = parametric.parameters;
    if (positions.empty()) continue;
    if (i % 4 == 0)
      for (const int joint : whole.coordinates()) {
        const std::string& name = whole.joints[static_cast<std::size_t>(joint)].declared_name();
        if (!positions.contains(name)) changes.kept.push_back({name, {}});
      }
    const KinematicTree reduced = tree_of(document, changes);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + describe(made));
    ASSERT_LT(reduced.dof(), whole.dof());

    const std::vector<double> of_whole = larger_than_defaults(whole), of_reduced = larger_than_defaults(reduced);
    const InterpretedRobot robot(reduced, {}, {}, of_reduced);
    const reference::Tables tables = reference_tables(whole, of_whole);
    const Whole map(whole, reduced, positions);
    std::mt19937_64 engine(seed);
    const Motion<double> m = reference::random_sample(engine, robot.tables()).motion;
    const Motion<double> all = map.motion(m);

    expect_same_frames(whole, reduced, tables, reference_tables(reduced, of_reduced), all.q, m.q);
    const Matrix<double> H = map.block(reference::joint_space_inertia(tables.robot(), all.q));
    EXPECT_LT(relative(robot.joint_space_inertia(m.q), H), kSame);
    const reference::Loads<double> loads;
    const auto forces = reference::inverse_dynamics_fully_actuated(tables.robot(), all, loads);
    const Vector<double> wanted = map.rows(whole.floating_base ? stacked(forces.base_wrench, forces.tau) : forces.tau);
    reference::Arguments arguments;
    if (whole.floating_base) arguments.gravity = &loads.gravity;
    EXPECT_LT(relative(robot.inverse_dynamics_fully_actuated(m, arguments), wanted), kSame);
    if (HasFailure()) return;
  }
}

// Quantities that become parameters have the numbers of the document as defaults.
TEST_P(LockedRobots, WithParametersHaveTheNumbersOfTheDocument) {
  for (int i = GetParam(); i < locked_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const KinematicTree made = with_random_drives(random_robot(seed, {.min_joints = 2, .max_joints = 12}), seed);
    const language::kinematics::Document document = exporting::kinematics_document(made);
    const KinematicTree constant = tree_of(document, {});
    const bool moves = made.floating_base || made.links.size() > 1;
    model::Changes changes;
    for (const char* pattern : {"*.placement", "*.inertia", "*.rotor", "*.damping"})
      if (moves && (std::string(pattern) != "*.rotor" || constant.has_rotors()))
        changes.parameters.push_back({pattern, {}});
    const KinematicTree tree = tree_of(document, changes);
    EXPECT_GT(tree.parameters.size(), 6 * tree.joints.size());
    std::vector<double> defaults;
    for (const model::Parameter& p : tree.parameters) defaults.push_back(p.default_value.value());
    const InterpretedRobot robot(tree, {}, {}, defaults);
    const reference::Tables tables = reference_tables(constant);
    std::mt19937_64 engine(seed);
    const Motion<double> m = reference::random_sample(engine, robot.tables()).motion;
    EXPECT_LT(relative(robot.joint_space_inertia(m.q), reference::joint_space_inertia(tables.robot(), m.q)), kSame)
        << "seed " << seed << "\n"
        << describe(constant);
  }
}

// Loops some of whose joints are locked, directly or by another joint of the loop.
TEST_P(LockedRobots, MoveLikeTheWholeRobotWithLoops) {
  int compared = 0;
  for (int i = GetParam(); i < locked_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    Dice dice(seed + 2000);
    Diagnostics diagnostics;
    const auto document = language::kinematics::parse(
        std::make_shared<const Source>("looped.kindsl", looped_document(seed)), diagnostics);
    const auto made = import::kinematic_tree(document, diagnostics);
    if (!made) continue;
    const KinematicTree& whole = *made;
    const Positions positions = random_positions(whole, dice, 0.1);
    if (positions.empty()) continue;
    model::Changes changes = changes_of(positions);
    for (const model::Parameter& p : whole.parameters)
      changes.locks.push_back({{p.name, {}}, model::Quantity(p.default_value.value_or(1.0))});
    SCOPED_TRACE("seed " + std::to_string(seed));
    Diagnostics messages;
    const auto found = import::kinematic_tree(document, changes, messages);
    if (!found) {
      EXPECT_NE(messages.render().find("[lock-open-loop]"), std::string::npos) << messages.render();
      continue;
    }
    const KinematicTree& reduced = *found;
    std::vector<double> parameters;
    for (const model::Parameter& p : whole.parameters) parameters.push_back(p.default_value.value_or(1.0));
    const InterpretedRobot before(whole, {}, {}, parameters), after(reduced, {}, {});
    const Whole map(whole, reduced, positions);
    if (static_cast<int>(map.coordinates().size()) != reduced.dof()) continue;  // others are independent
    if (whole.position_count() != whole.dof() || reduced.position_count() != reduced.dof()) continue;
    std::mt19937_64 engine(seed);
    const Motion<double> m = reference::random_sample(engine, after.tables()).motion;
    const Motion<double> all = map.motion(m);
    const Matrix<double> H = map.block(before.joint_space_inertia(all.q));
    if (std::isnan(reference::largest(H))) continue;  // out of reach
    ++compared;
    EXPECT_LT(relative(after.joint_space_inertia(m.q), H), 1e-8);
    EXPECT_LT(relative(after.bias_forces(m, {}), map.rows(before.bias_forces(all, {}))), 1e-8);
    if (HasFailure()) return;
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Shard, LockedRobots, testing::Range(0, kShards));

}  // namespace
}  // namespace robcogen::numeric::locked_robots_test
