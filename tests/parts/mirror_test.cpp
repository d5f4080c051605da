// A mirrored part moves as the mirror image of the part: with the same joint-space inertia matrix, the same forces
// under reflected gravity, and reflected Jacobians and positions of its links. Both parts are in mirrored postures:
// their joint positions are equal, or opposite for joints that keep their sense.
#include "physics.h"

namespace robcogen::mirror_test {
namespace {

using namespace test;
using numeric::Dice;

constexpr int kParts = 500;

struct Case {
  kinematics::Document part;  // a robot, used without its base
  bool floating = false;
  int axis = 0;
  bool same_sense = false;
  std::vector<std::string> kept;  // joints; empty for all
  std::array<double, 3> position{}, angles{};
};

// Turns two in five of the revolute joints into joints with several coordinates, or spherical ones; some coordinates
// follow one another.
void add_coordinates(kinematics::Document& part, Dice& dice) {
  using enum kinematics::Joint::Type;
  for (kinematics::Joint& joint : part.joints) {
    const std::string text = kinematics::print(part);
    // Couplings and tendons name joints with one coordinate.
    const std::string readers = text.substr(std::min({text.size(), text.find("couplings {"), text.find("tendons {")}));
    if (joint.type != revolute || readers.find(joint.name.text) != std::string::npos || dice.chance(0.6)) continue;
    constexpr std::array kTypes = {cylindrical, universal, planar, spherical, spherical};
    joint.type = kTypes[static_cast<std::size_t>(dice.below(5))];
    if (joint.type == spherical) {
      joint.drive = {joint.drive.damping, {}, {}, joint.drive.armature, {}, {}};  // the properties that need no axis
      joint.rotor.reset();
      joint.limits.position.reset();
      continue;
    }
    const auto words = kinematics::coordinate_words(joint.type);
    const auto word = words[static_cast<std::size_t>(dice.below(static_cast<int>(words.size())))];
    joint.coordinates = {
        kinematics::Coordinate{static_cast<const kinematics::DriveAndLimits&>(joint), {std::string(word), {}}}};
    joint.drive = {};
    joint.rotor.reset();
    joint.limits = {};
    if (joint.type == universal || dice.chance(0.5)) continue;
    const std::string first = joint.type == planar ? "_slide_x" : "_slide";
    const kinematics::Document coupling = parsed(
        "Robot R { RobotBase b { children {} } couplings { " + joint.name.text + first + " = 0.3 m/rad * " +
        joint.name.text + "_turn + 0.1 } }");
    part.couplings.push_back(coupling.couplings.front());
  }
}

// Returns the sense of a coordinate of a joint with several coordinates.
int sense_of_coordinate(const std::string& coordinate, bool is_kept) {
  const auto ends = [&](const char* word) { return coordinate.ends_with(word); };
  if (ends("_slide_x")) return 1;
  if (ends("_slide_y")) return is_kept ? -1 : 1;
  if (ends("_slide")) return is_kept ? 1 : -1;
  return is_kept ? -1 : 1;
}

Case random_case(std::uint64_t seed) {
  Dice dice(seed);
  Case c;
  c.part = random_document(seed);
  if (seed % 4 != 3) add_coordinates(c.part, dice);
  c.floating = dice.chance(0.4);
  c.axis = dice.below(3);
  const int sense = dice.below(3);
  c.same_sense = sense > 0;
  for (const kinematics::Joint& joint : c.part.joints)
    if (sense == 2 && joint.type != kinematics::Joint::Type::prismatic && dice.chance(0.5))
      c.kept.push_back(joint.name.text);
  if (sense == 2 && c.kept.empty()) c.same_sense = false;
  if (c.floating) return c;  // the base is symmetric to the plane through its origin
  for (double& x : c.position) x = dice.between(-1.0, 1.0);
  for (double& a : c.angles) a = dice.chance(0.3) ? 0.0 : dice.between(-2.0, 2.0);
  return c;
}

std::string text(const std::array<double, 3>& v) {
  return "(" + print_double(v[0]) + ", " + print_double(v[1]) + ", " + print_double(v[2]) + ")";
}

// A base that carries the part, or the part's mirror image.
model::KinematicTree robot(const Case& c, bool mirrored) {
  const auto on_plane = [&](int axis, double value) { return axis == c.axis ? 0.0 : value; };
  const auto product = [&](int i, int k) { return print_double(on_plane(i, on_plane(k, 0.05))); };
  std::string document =
      std::string("Robot R { RobotBase base ") + (c.floating ? "floating" : "") +
      " { inertia_params { mass = 5.0 CoM = " + text({on_plane(0, 0.1), on_plane(1, 0.2), on_plane(2, -0.1)}) +
      " Ix = 1.0 Iy = 1.2 Iz = 1.3 Ixy = " + product(0, 1) + " Ixz = " + product(0, 2) + " Iyz = " + product(1, 2) +
      " } children { P limb at { translation = " + text(c.position) + " rotation = " + text(c.angles) + " }";
  if (mirrored) {
    document += std::string(" mirrored ") + "xyz"[c.axis] + (c.same_sense ? " same sense" : "");
    if (!c.kept.empty()) document += " {";
    for (const std::string& joint : c.kept) document += " " + joint;
    if (!c.kept.empty()) document += " }";
  }
  kinematics::Document result = parsed(document + " } } }");
  kinematics::Part part;
  static_cast<kinematics::Body&>(part) = c.part;
  part.name.text = "P";
  part.roots = part.links.front().children;
  const std::string base = part.links.front().name.text;
  part.links.erase(part.links.begin());
  const auto is_on_base = [&](const std::optional<kinematics::Rotor>& rotor) {
    return rotor && rotor->carrier && rotor->carrier->text == base;
  };
  for (kinematics::Joint& joint : part.joints) {  // a rotor on the base of the part would have no carrier
    if (is_on_base(joint.rotor)) joint.rotor->carrier.reset();
    for (kinematics::Coordinate& coordinate : joint.coordinates)
      if (is_on_base(coordinate.rotor)) coordinate.rotor->carrier.reset();
  }
  result.parts.push_back(std::move(part));
  return tree_of(expanded(std::move(result)));
}

// The reflection in base axes.
Matrix reflection(const Case& c) {
  Matrix R = Matrix::identity(3);
  for (int axis = 0; axis < 3; ++axis) {
    Matrix turn = Matrix::identity(3);
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    const double angle = c.angles[static_cast<std::size_t>(axis)];
    turn(y, y) = turn(z, z) = std::cos(angle);
    turn(z, y) = std::sin(angle);
    turn(y, z) = -std::sin(angle);
    R = R * turn;
  }
  Matrix M = Matrix::identity(3);
  M(c.axis, c.axis) = -1;
  return R * M * transpose(R);
}

// The reflection of velocities, angular first: an angular velocity is an axial vector.
Matrix of_velocities(const Matrix& S) {
  Matrix D(6, 6);
  Matrix negative = S;
  negative *= -1.0;
  D.set_block(0, 0, negative);
  D.set_block(3, 3, S);
  return D;
}

// The sign of each coordinate in the mirrored posture.
Vector senses(const Case& c, const model::KinematicTree& tree) {
  Vector s(tree.dof());
  int i = 0;
  for (const int j : tree.coordinates()) {
    const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    const std::string name = joint.name.substr(5);
    std::string declared = name;
    for (const kinematics::Joint& written : c.part.joints)
      if (!written.coordinates.empty() && name.starts_with(written.name.text + "_")) declared = written.name.text;
    if (joint.type == model::JointType::spherical) declared = joint.declared_name().substr(5);
    const bool is_kept = c.same_sense && (c.kept.empty() || std::count(c.kept.begin(), c.kept.end(), declared) > 0);
    if (joint.type == model::JointType::spherical) {
      s(i++) = is_kept && joint.axis != 1 ? -1.0 : 1.0;
      continue;
    }
    if (declared != name) {
      s(i++) = sense_of_coordinate(name, is_kept);
      continue;
    }
    s(i++) = joint.type != model::JointType::prismatic && is_kept ? -1.0 : 1.0;
  }
  return s;
}

// The signs of positions: vector parts of quaternions have the signs of velocities, scalar parts do not change.
Vector senses_of_positions(const model::KinematicTree& tree, const Vector& senses) {
  Vector s(tree.position_count());
  for (int k = 0; k < s.rows(); ++k) s(k) = 1.0;
  const std::vector<int> elements = tree.position_elements(), joints = tree.coordinates();
  for (std::size_t i = 0; i < joints.size(); ++i)
    s(elements[static_cast<std::size_t>(joints[i])]) = senses(static_cast<int>(i));
  return s;
}

Vector random_positions(numeric::Dice& dice, const model::KinematicTree& tree) {
  Vector q = random_vector(dice, tree.position_count());
  for (const int joint : tree.spherical_joints()) {
    const int first = tree.position_elements()[static_cast<std::size_t>(joint)] - 1;
    const Vector quaternion = q.block(first, 0, 4, 1);
    q.set_block(first, 0, (1 / std::sqrt(dot(quaternion, quaternion))) * quaternion);
  }
  return q;
}

Vector scaled(const Vector& s, const Vector& v) {
  Vector result = v;
  for (int i = 0; i < v.rows(); ++i) result(i) *= s(i);
  return result;
}

class MirrorImage {
 public:
  MirrorImage(const Case& c, std::uint64_t seed)
      : case_(c), tree_(robot(c, false)), image_(robot(c, true)), S_(reflection(c)), s_(senses(c, tree_)) {
    Dice dice(seed);
    state_ = {
        random_positions(dice, tree_), random_vector(dice, tree_.dof()), random_vector(dice, 6),
        random_vector(dice, 3)};
    image_state_ = {
        scaled(senses_of_positions(tree_, s_), state_.q), scaled(s_, state_.qd),
        of_velocities(S_) * state_.base_velocity, S_ * state_.gravity};
  }

  void check() const {
    const Matrix D = of_base_and_joints();
    expect_equal(inertia_matrix(image_, image_state_), D * inertia_matrix(tree_, state_) * D, "H");
    expect_equal(bias_forces(image_, image_state_), D * bias_forces(tree_, state_), "bias forces");
    check_frames();
  }

 private:
  const Case& case_;
  model::KinematicTree tree_, image_;
  Matrix S_;
  Vector s_;
  State state_, image_state_;

  Matrix of_base_and_joints() const {
    const int base = case_.floating ? 6 : 0;
    Matrix D = Matrix::identity(base + s_.rows());
    if (case_.floating) D.set_block(0, 0, of_velocities(S_));
    for (int i = 0; i < s_.rows(); ++i) D(base + i, base + i) = s_(i);
    return D;
  }

  // Compares each link with respect to the base: its Jacobian, and the position of its origin.
  void check_frames() const {
    const auto functions = [](const model::KinematicTree& tree, const std::string& group) {
      model::DesiredTransforms desired;
      const std::vector<model::Frame> frames = tree.frames();
      for (std::size_t i = 1; i < static_cast<std::size_t>(tree.link_count()); ++i) {
        desired.jacobians.push_back({frames[0], frames[i]});
        desired.transforms.push_back({frames[0], frames[i]});
      }
      return algorithm::functions(tree, desired, group);
    };
    const auto own = functions(tree_, "jacobians"), of_image = functions(image_, "jacobians");
    ASSERT_EQ(own.size(), of_image.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      ASSERT_EQ(own[k].columns, of_image[k].columns) << own[k].name;
      if (own[k].columns.empty()) continue;
      Matrix reflected = of_velocities(S_) * matrix(result(own[k].program, state_), 6);
      for (int col = 0; col < reflected.cols(); ++col)
        for (int row = 0; row < 6; ++row) reflected(row, col) *= s_(own[k].columns[static_cast<std::size_t>(col)]);
      expect_equal(matrix(result(of_image[k].program, image_state_), 6), reflected, own[k].name);
    }
    const auto poses = functions(tree_, "transforms"), image_poses = functions(image_, "transforms");
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (poses[k].scope != "transforms::homogeneous") continue;
      const Vector position = matrix(result(poses[k].program, state_), 4).block(0, 3, 3, 1);
      const Vector image = matrix(result(image_poses[k].program, image_state_), 4).block(0, 3, 3, 1);
      const Vector at = {case_.position[0], case_.position[1], case_.position[2]};
      expect_equal(image, at + S_ * (position - at), poses[k].name);
    }
  }
};

TEST(MirroredParts, MoveAsMirrorImages) {
  int kept = 0, coupled = 0, several = 0, balls = 0;
  for (std::uint64_t seed = 0; seed < kParts; ++seed) {
    const Case c = random_case(seed);
    kept += c.same_sense ? 1 : 0;
    coupled += c.part.couplings.empty() ? 0 : 1;
    for (const kinematics::Joint& joint : c.part.joints) several += joint.coordinates.empty() ? 0 : 1;
    for (const kinematics::Joint& joint : c.part.joints)
      balls += joint.type == kinematics::Joint::Type::spherical ? 1 : 0;
    MirrorImage(c, seed).check();
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << "\n" << kinematics::print(c.part);
  }
  EXPECT_GT(kept, kParts / 4);
  EXPECT_GT(coupled, kParts / 10);
  EXPECT_GT(several, kParts / 10);
  EXPECT_GT(balls, kParts / 10);
}

// The mirror image of the mirror image is the part.
TEST(MirroredParts, AreThemselvesWhenTheyAreMirroredAgain) {
  const std::string part =
      "Part Leg { root hip via HAA link hip { children { shin via KFE } } link shin { children {} frames { foot { "
      "translation = (0.1, 0.2, 0.3) rotation = (0.4, 0.5, 0.6) } } } r_joint HAA { ref_frame { translation = (0.1, "
      "0.2, 0.3) rotation = (0.7, PI/2.0, 0.1) } limits { position = (-0.5, 1.0) } } p_joint KFE { ref_frame { "
      "translation = (0.3, 0.2, 0.1) rotation = (0.3, -0.2, 0.1) } } }";
  const std::string pair =
      "Part Pair { root hub via turn link hub { children { Leg a() mirrored y same sense } } r_joint turn { ref_frame "
      "{ "
      "translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }";
  const std::string plain =
      "Part Pair { root hub via turn link hub { children { Leg a() } } r_joint turn { ref_frame { translation = (0.0, "
      "0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }";
  const std::string robot = " Robot R { RobotBase base { children { Pair p() ";
  // The image of the hub has its y axis reversed, too, so the leg is unchanged.
  const kinematics::Document twice = expanded(parsed(part + pair + robot + "mirrored y same sense } } }"));
  const kinematics::Document never = expanded(parsed(part + plain + robot + "} } }"));
  ASSERT_EQ(twice.joints.size(), 3u);
  for (std::size_t j = 1; j < 3; ++j) {
    const model::Placement a = tree_of(twice).joints[j].placement, b = tree_of(never).joints[j].placement;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(a.translation[i].number().value(), b.translation[i].number().value(), 1e-15);
      EXPECT_NEAR(a.rotation[i].number().value(), b.rotation[i].number().value(), 1e-15);
    }
  }
  EXPECT_EQ(kinematics::print(twice).substr(0, 40), kinematics::print(never).substr(0, 40));
}

}  // namespace
}  // namespace robcogen::mirror_test
