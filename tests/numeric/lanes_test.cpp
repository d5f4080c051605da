// Congruent limbs in lanes: programs have the same results as without lanes.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "../unit/model/descriptions.h"
#include "algorithm/catalogue/catalogue.h"
#include "interpreted_robot.h"
#include "packed_programs.h"
#include "pass/lanes/pack_lanes.h"
#include "pass/passes.h"
#include "pass/split_angles.h"
#include "symbolic/blocks.h"
#include "symbolic/cost.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"
#include "volume.h"

namespace robcogen::numeric::lanes_test {
namespace {

using model::KinematicTree;
using model::Quantity;
using symbolic::Program;

// A robot with k limbs of one topology on a trunk, which may be one joint away from the base. Numbers are arbitrary,
// zero, or multiples of a right angle. Limbs have numbers of their own (with zeros in other places, too), those of the
// first limb with other signs, or these with zeros and ones in other places.
class RobotsWithLimbs {
 public:
  explicit RobotsWithLimbs(std::uint64_t seed, bool has_roundings = false)
      : random_(static_cast<std::mt19937::result_type>(seed)), has_roundings_(has_roundings) {}

  KinematicTree make() {
    const std::array<int, 5> counts = {2, 2, 4, 4, 3};
    const int limbs = counts[static_cast<std::size_t>(pick(5))], length = 1 + pick(3);
    model::Description d;
    d.name = "limbs";
    d.floating_base = pick(2) == 0;
    d.base = model::test::link("base");
    if (d.floating_base) d.base.inertia = body();
    std::string trunk = "base";
    if (pick(3) == 0) {
      d.base.children.push_back({"trunk", "waist", {}, {}});
      d.links.push_back(model::test::link(trunk = "trunk"));
      d.joints.push_back(joint("waist", pick(2) == 0 ? model::JointType::revolute : model::JointType::prismatic));
    }
    const bool mirrored = pick(3) != 0, has_other_zeros = mirrored && pick(2) == 0;
    std::vector<model::JointType> types;
    std::vector<int> parent;
    for (int k = 0; k < length; ++k) {
      const int type = pick(8);
      types.push_back(
          type > 2   ? model::JointType::revolute
          : type > 0 ? model::JointType::prismatic
                     : model::JointType::helical);
      parent.push_back(pick(3) == 0 ? pick(k + 1) - 1 : k - 1);
    }
    std::vector<model::DescribedLink> first_links;
    std::vector<model::DescribedJoint> first_joints;
    for (int i = 0; i < limbs; ++i) {
      for (int k = 0; k < length; ++k) {
        const auto name = [&](int joint_number) {
          return "limb" + std::to_string(i) + "_" + std::to_string(joint_number);
        };
        const auto at = static_cast<std::size_t>(k);
        model::DescribedLink link = model::test::link("link_" + name(k));
        model::DescribedJoint j = joint("joint_" + name(k), types[at]);
        link.inertia = body();
        if (i == 0) {
          first_links.push_back(link);
          first_joints.push_back(j);
        } else if (mirrored) {
          link.inertia = first_links[at].inertia;
          j.placement = first_joints[at].placement;
          j.pitch = pick(2) == 0 ? first_joints[at].pitch : -first_joints[at].pitch;
          flip_some(link.inertia->com);
          flip_some(j.placement.translation);
          flip_some(j.placement.rotation);
          if (has_other_zeros) {
            replace_some(link.inertia->com, 0.0);
            replace_some(j.placement.translation, pick(4) == 0 ? 1.0 : 0.0);
            if (has_roundings_) turn_a_little(j.placement.rotation);
          }
        }
        const std::string on = parent[at] < 0 ? trunk : "link_" + name(parent[at]);
        for (model::DescribedLink& l : d.links)
          if (l.name == on) l.children.push_back({link.name, j.name, {}, {}});
        if (on == "base") d.base.children.push_back({link.name, j.name, {}, {}});
        d.links.push_back(link);
        d.joints.push_back(j);
      }
    }
    Diagnostics diagnostics;
    const auto tree = model::build(d, diagnostics);
    EXPECT_TRUE(tree.has_value()) << diagnostics.render();
    limbs_ = limbs;
    length_ = length;
    return *tree;
  }

  // In each limb one joint follows another, and one joint has a rotor that its parent carries.
  KinematicTree make_coupled() {
    KinematicTree tree;
    do tree = make();
    while (length_ < 2);
    const int follower = pick(length_), leader = (follower + 1 + pick(length_ - 1)) % length_, geared = pick(length_);
    const std::array<double, 3> factors = {1.0, 2.0, 0.7};
    const double factor = factors[static_cast<std::size_t>(pick(3))];
    const bool has_offset = pick(2) == 0, same_rotors = pick(2) == 0;
    const auto joint_of = [&](int limb, int k) {
      return *tree.find_joint("joint_limb" + std::to_string(limb) + "_" + std::to_string(k));
    };
    for (int limb = 0; limb < limbs_; ++limb) {
      // Integer factors fold, and are the same up to their signs; otherwise each limb has a factor of its own.
      const double sign = pick(2) == 0 ? 1 : -1, own = factor == 0.7 ? uniform(0.6, 0.8) : factor;
      model::Coupling coupling;
      coupling.joint = joint_of(limb, follower);
      coupling.terms = {{joint_of(limb, leader), model::test::number(sign * own)}};
      if (has_offset) coupling.offset = model::test::number(uniform(0.1, 0.3));
      tree.couplings.push_back(std::move(coupling));
      model::Joint& driven = tree.joints[static_cast<std::size_t>(joint_of(limb, geared))];
      if (driven.type != model::JointType::prismatic)
        driven.drive.rotor = {
            model::test::number(same_rotors ? 1e-3 : uniform(1e-3, 2e-3)), model::test::number(6), {}, driven.parent};
    }
    return tree;
  }

 private:
  std::mt19937 random_;
  std::mt19937 roundings_{1};  // a separate engine, so that other numbers do not depend on it
  bool has_roundings_;         // of angles, in limbs with zeros in other places
  int limbs_ = 0, length_ = 0;

  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  model::Quantity length() { return pick(3) == 0 ? model::Quantity() : model::test::number(uniform(-0.5, 0.5)); }
  model::Quantity angle() {
    return pick(3) == 0 ? model::test::number(uniform(-3, 3)) : model::test::pi(pick(4) - 1, 2);
  }
  void flip_some(std::array<model::Quantity, 3>& values) {
    for (model::Quantity& q : values)
      if (pick(2) == 0) q = -q;
  }

  void replace_some(std::array<model::Quantity, 3>& values, double value) {
    for (model::Quantity& q : values)
      if (pick(3) == 0) q = model::test::number(value);
  }

  // Rounds an angle as a document does that writes PI with a dozen digits.
  void turn_a_little(std::array<model::Quantity, 3>& rotation) {
    model::Quantity& q = rotation[roundings_() % 3];
    if (roundings_() % 3 == 0) q = model::test::number(q.number().value() + 1e-11);
  }

  model::DescribedJoint joint(const std::string& name, model::JointType type) {
    model::Placement placement;
    for (std::size_t i = 0; i < 3; ++i) {
      placement.translation[i] = length();
      placement.rotation[i] = angle();
    }
    model::DescribedJoint made = model::test::joint(name, type, placement);
    if (type == model::JointType::helical) made.pitch = model::test::number(uniform(0.01, 0.5));
    return made;
  }

  model::Inertia body() {
    model::Inertia i = model::test::ball(uniform(0.5, 2), uniform(0.5, 1));
    for (model::Quantity& q : i.com) q = pick(2) == 0 ? model::Quantity() : model::test::number(uniform(-0.1, 0.1));
    return i;
  }
};

// Returns an empty string if blocks and fills are results of the program, each element at most once; otherwise the
// fault.
std::string fault_of_stores(const Program& p) {
  const symbolic::Stores stores = symbolic::stores(p);
  std::vector<std::vector<bool>> taken;
  for (const symbolic::OutputArray& array : p.outputs) taken.emplace_back(array.values.size(), false);
  for (const symbolic::Block& block : stores.blocks) {
    for (int lane = 0; lane < block.width; ++lane) {
      for (std::size_t k = 0; k < block.columns.size(); ++k) {
        const auto element = static_cast<std::size_t>(block.first + lane * block.stride) + k;
        const auto array = static_cast<std::size_t>(block.array);
        symbolic::Operand expected = block.columns[k];
        if (is_statement(expected)) expected.lane = lane;
        if (p.outputs[array].values.at(element) != expected) return "another element in a block";
        if (taken[array][element]) return "an element twice";
        taken[array][element] = true;
      }
    }
  }
  for (const symbolic::Fill& fill : stores.fills) {
    const std::vector<symbolic::Operand>& values = p.outputs[static_cast<std::size_t>(fill.array)].values;
    if (fill.first + fill.count > static_cast<int>(values.size())) return "a fill beyond the end";
    if (fill.value.kind != symbolic::Operand::Kind::constant) return "a fill that is no constant";
  }
  return "";
}

struct Tally {
  int programs = 0, with_lanes = 0;
  int congruent = 0;  // programs whose limbs are made to fold in the same way, where they differ from the others
};

// Checks the part of a program in lanes that takes given sines and cosines: its results are the same to the last bit,
// because it does the same operations.
void expect_same_of_given_sines(const KinematicTree& tree, const Program& program, const Program& packed) {
  std::vector<pass::Position> joints;
  for (const int j : tree.coordinates()) {
    const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    joints.push_back({joint.name, model::turns(joint.type)});
  }
  const pass::SplitAngles split = pass::split_angles({{program, &packed}}, joints);
  if (!split.cores[0]) return;
  const Program& core = *split.cores[0]->in_lanes;
  ASSERT_EQ(symbolic::verify(core), "") << program.name;
  // A joint that follows another one by a factor has a sine of its own.
  const bool has_others = symbolic::cost(split.cores[0]->program).sincos > 0;
  EXPECT_EQ(symbolic::cost(core).sincos > 0, has_others) << program.name;
  EXPECT_TRUE(!has_others || !tree.couplings.empty()) << program.name;
  symbolic::Arrays<double> inputs = random_inputs(program, 2);
  const auto expected = symbolic::interpret<double>(packed, inputs);
  const auto angles = symbolic::interpret<double>(split.angles, {{"q", inputs.at("q")}});
  for (const double angle : angles.at("angles")) {
    inputs["sin_q"].push_back(std::sin(angle));
    inputs["cos_q"].push_back(std::cos(angle));
  }
  ASSERT_EQ(symbolic::interpret<double>(core, inputs), expected) << program.name << "\n" << symbolic::print(core);
}

void expect_same_program(const Program& expected, const Program& program) {
  ASSERT_EQ(symbolic::verify(program), "") << program.name;
  ASSERT_EQ(fault_of_stores(program), "") << program.name << "\n" << symbolic::print(program);
  ASSERT_EQ(difference(expected, program, 1), "") << program.name << "\n" << symbolic::print(program);
  std::string error;
  const auto read = symbolic::parse(symbolic::print(program), error);
  ASSERT_TRUE(read) << error;
  ASSERT_EQ(symbolic::print(*read), symbolic::print(program));
}

// The programs of a group whose congruent limbs fold in the same way; nullopt for those that do not fold differently.
std::vector<std::optional<Program>> congruent_programs(
    const KinematicTree& tree,
    const std::string& group,
    algorithm::FormulationChoices& for_congruent_limbs) {
  std::vector<std::optional<Program>> programs;
  for (symbolic::Function& f : algorithm::functions(tree, {}, group, for_congruent_limbs)) {
    const bool is_other = algorithm::folds_like_others(f.program);
    programs.push_back(is_other ? std::optional(std::move(f.program)) : std::nullopt);
  }
  return programs;
}

void expect_same_results(
    const KinematicTree& tree,
    const std::vector<std::string>& steps,
    Tally& tally,
    int effort = 0,
    InterpretedRobot* checked = nullptr) {
  std::vector<std::string> passes = steps;
  algorithm::Formulation formulation = algorithm::take_formulation(passes);
  formulation.effort = effort;
  algorithm::FormulationChoices formulations(tree, formulation);
  auto for_congruent_limbs = algorithm::FormulationChoices::for_congruent_limbs(formulations);
  for (const std::string& group : algorithm::groups()) {
    const std::vector<symbolic::Function> functions = algorithm::functions(tree, {}, group, formulations);
    std::vector<std::optional<Program>> congruent;
    if (tree.parameters.empty()) congruent = congruent_programs(tree, group, for_congruent_limbs);
    congruent.resize(functions.size());
    for (std::size_t i = 0; i < functions.size(); ++i) {
      const Program program = pass::run(functions[i].program, passes);
      const std::vector<pass::InputTuples> classes = classes_of(tree, program);
      Program packed = pass::packed(program, classes);
      ++tally.programs;
      if (packed.has_lanes()) ++tally.with_lanes;
      expect_same_program(program, packed);
      expect_same_of_given_sines(tree, program, packed);
      if (congruent[i]) {
        ++tally.congruent;
        const Program plain = pass::with_plain_numbers(pass::run(std::move(*congruent[i]), passes));
        for (const symbolic::Constant& c : plain.constants) ASSERT_TRUE(c.folds_as_itself());
        expect_same_program(program, plain);
        packed = pass::packed(plain, classes);
        expect_same_program(program, packed);
        expect_same_of_given_sines(tree, program, packed);
      }
      if (testing::Test::HasFatalFailure()) return;
      // Regressors of robots with many joints are not checked.
      if (checked && checked->has(packed.name)) checked->replace(std::move(packed));
    }
  }
}

class Robots : public testing::TestWithParam<const char*> {};

TEST_P(Robots, HaveTheSameResultsWithLanes) {
  const KinematicTree tree = document(GetParam());
  Tally tally;
  for (const auto& steps : {all_steps(), std::vector<std::string>()}) expect_same_results(tree, steps, tally);
  EXPECT_GT(tally.with_lanes, tally.programs / 2);
}

constexpr const char* kRobotsWithLanes[] = {
    "quadruped_fixed",
#if ROBCOGEN_TEST_EVERYTHING
    "quadruped",
    "centaur",
    "humanoid",
#endif
};
INSTANTIATE_TEST_SUITE_P(Lanes, Robots, testing::ValuesIn(kRobotsWithLanes), [](const auto& robot) {
  return std::string(robot.param);
});

TEST(Lanes, OfRandomRobotsComputeTheSame) {
  Tally tally;
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 8); ++i) {
    SCOPED_TRACE("seed " + std::to_string(i));
    const KinematicTree tree = RobotsWithLimbs(static_cast<std::uint64_t>(i), true).make();
    const std::vector<std::string> passes = i % 3 == 0 ? std::vector<std::string>() : all_steps();
    expect_same_results(tree, passes, tally, i % 5 == 0 ? 1 : 0);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.with_lanes, tally.programs / 2);
  EXPECT_GT(tally.congruent, tally.programs / 10);
}

TEST(Lanes, OfCoupledLimbsComputeTheSame) {
  Tally tally;
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 8); ++i) {
    SCOPED_TRACE("seed " + std::to_string(i));
    const KinematicTree tree = RobotsWithLimbs(static_cast<std::uint64_t>(1000 + i)).make_coupled();
    expect_same_results(tree, i % 3 == 0 ? std::vector<std::string>() : all_steps(), tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.with_lanes, tally.programs / 3);  // about half of them
}

// The humanoid's right hand is rotated by a rounding error: its arms still share lanes at the cost of a few products.
TEST(Lanes, OfAHandThatIsTurnedByARoundingTakeLittleMore) {
  const KinematicTree exact = document("humanoid");
  KinematicTree rounded = exact;
  const auto hand = static_cast<std::size_t>(*exact.find_joint("right_gripper"));
  Quantity& angle = rounded.joints[hand].placement.rotation[1];
  angle = Quantity(angle.number().value() - 2e-11);
  const auto instructions = [](const KinematicTree& tree, const std::string& group) {
    algorithm::Formulation formulation;
    formulation.effort = 1;
    algorithm::FormulationChoices choices(tree, formulation);
    auto for_congruent_limbs = algorithm::FormulationChoices::for_congruent_limbs(choices);
    std::optional<Program> congruent = congruent_programs(tree, group, for_congruent_limbs).front();
    const Program program = pass::run(algorithm::functions(tree, {}, group, choices).front().program, pass::names());
    if (congruent) congruent = pass::run(std::move(*congruent), pass::names());
    const Program packed = pass::pack_lanes(program, classes_of(tree, program), congruent).program;
    EXPECT_EQ(difference(program, packed, 1), "");
    return symbolic::cost(packed).instructions;
  };
  for (const std::string group : {"inverse_dynamics", "forward_dynamics", "joint_space_inertia"}) {
    const int wanted = instructions(exact, group), found = instructions(rounded, group);
    std::printf("%s: %d instructions in lanes, %d with a rounding\n", group.c_str(), wanted, found);
    EXPECT_LT(found, 1.1 * wanted) << group;
  }
}

// Legs whose knees follow their hips share lanes as legs do whose joints are all free.
TEST(Lanes, OfCoupledLegsTakeHalfTheInstructions) {
  KinematicTree tree = document("quadruped");
  for (const char* leg : {"LF", "RF", "LH", "RH"}) {
    const auto joint = [&](const char* name) { return *tree.find_joint(std::string(leg) + "_" + name); };
    tree.couplings.push_back({joint("KFE"), {{joint("HFE"), Quantity(-0.5)}}, Quantity(0.2)});
    model::Joint& hip = tree.joints[static_cast<std::size_t>(joint("HAA"))];
    hip.drive.rotor = {Quantity(1e-4), Quantity(9.0), {}, hip.parent};
  }
  for (const std::string group : {"inverse_dynamics", "joint_space_inertia", "bias_forces"}) {
    for (const symbolic::Function& f : algorithm::functions(tree, {}, group)) {
      const Program program = pass::run(f.program, pass::names());
      const Program packed = pass::packed(program, classes_of(tree, program));
      const int before = symbolic::cost(program).instructions, after = symbolic::cost(packed).instructions;
      std::printf("%s: %d instructions, %d in lanes\n", f.program.name.c_str(), before, after);
      EXPECT_LT(after, 0.5 * before) << f.program.name;
    }
  }
}

// Compares the programs of two legs, one of which has zeros where the other has none, with those of two legs without
// zeros.
TEST(Lanes, OfLimbsThatFoldAlikeCountAsThoseWithoutZeros) {
  const auto robot = [](bool has_zeros) {
    model::Description d;
    d.name = "legs";
    d.floating_base = true;
    d.base = model::test::link("base");
    d.base.inertia = model::test::ball(5, 1);
    for (const std::string leg : {"left", "right"}) {
      const bool is_zero = has_zeros && leg == "left";
      const auto length = [&](double value) { return model::test::number(is_zero ? 0.0 : value); };
      for (const std::string part : {"thigh", "shank"}) {
        model::DescribedLink link = model::test::link(leg + "_" + part);
        link.inertia = model::test::ball(1.5, 0.5);
        link.inertia->com = {model::test::number(0.1), length(0.02), length(0.03)};
        model::Placement placement;
        placement.translation = {model::test::number(is_zero ? 1.0 : 0.9), length(0.04), model::test::number(0.2)};
        placement.rotation = {model::test::pi(1, 2), {}, {}};
        (part == "thigh" ? d.base : d.links.back()).children.push_back({link.name, "to_" + link.name, {}, {}});
        d.links.push_back(link);
        d.joints.push_back(model::test::joint("to_" + link.name, model::JointType::revolute, placement));
      }
    }
    Diagnostics diagnostics;
    return model::build(d, diagnostics).value();
  };
  const KinematicTree with_zeros = robot(true), without = robot(false);
  algorithm::FormulationChoices formulations(with_zeros, {}), of_others(without, {});
  auto for_congruent_limbs = algorithm::FormulationChoices::for_congruent_limbs(formulations);
  auto for_others = algorithm::FormulationChoices::for_congruent_limbs(of_others);
  for (const std::string group : {"inverse_dynamics", "forward_dynamics", "joint_space_inertia"}) {
    const auto congruent = congruent_programs(with_zeros, group, for_congruent_limbs);
    for (const auto& program : congruent_programs(without, group, for_others))
      EXPECT_FALSE(program) << "nothing differs";
    const auto others = algorithm::functions(without, {}, group, of_others);
    ASSERT_EQ(congruent.size(), others.size()) << group;
    for (std::size_t i = 0; i < others.size(); ++i) {
      ASSERT_TRUE(congruent[i]);
      const auto count = [](const KinematicTree& tree, const Program& program) {
        return symbolic::cost(pass::packed(program, classes_of(tree, program)));
      };
      const auto found = count(with_zeros, pass::with_plain_numbers(*congruent[i])),
                 wanted = count(without, others[i].program);
      EXPECT_EQ(found.mul, wanted.mul) << others[i].name;
      EXPECT_EQ(found.add, wanted.add) << others[i].name;
      EXPECT_EQ(found.moves, wanted.moves) << others[i].name;
    }
  }
}

// A published quadruped whose first leg has a centre of mass on an axis, while those of the other legs are off it: all
// its functions in lanes, compared with the reference.
TEST(Lanes, OfLegsWithOtherZerosAgreeWithTheReference) {
  const std::string file = std::string(ROBCOGEN_CORPUS_DIR) +
                           "/DrawZeroPoint_control-toolbox__ct_rbd_test_models_testhyq_description_test_hyq.kindsl";
  if (!std::filesystem::is_regular_file(file)) GTEST_SKIP() << "no document " << file;
  const KinematicTree tree = document_of(file);
  for (const int effort : {0, 1}) {
    InterpretedRobot checked(tree, {});
    Tally tally;
    expect_same_results(tree, all_steps(), tally, effort, &checked);
    if (HasFatalFailure()) return;
    EXPECT_GT(tally.congruent, 0);
    constexpr std::uint64_t kSeed = 5;
    EXPECT_EQ(check_all(checked, kSeed, 5).failure_report(), "");
  }
}

TEST(Lanes, WhatHasLanesIsNotPackedAgain) {
  for (const char* name : {"quadruped_fixed", "quadruped", "centaur"}) {
    const KinematicTree tree = document(name);
    for (const std::string group : {"inverse_dynamics", "forward_dynamics"}) {
      for (const symbolic::Function& f : algorithm::functions(tree, {}, group)) {
        const Program program = pass::run(f.program, pass::names());
        const pass::Packed once = pass::pack_lanes(program, classes_of(tree, program));
        const pass::Packed twice = pass::pack_lanes(once.program, classes_of(tree, once.program));
        EXPECT_EQ(symbolic::print(twice.program), symbolic::print(once.program)) << name << " " << program.name;
      }
    }
  }
}

}  // namespace
}  // namespace robcogen::numeric::lanes_test
