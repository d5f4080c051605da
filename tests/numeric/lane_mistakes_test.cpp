// Programs in lanes with a deliberate mistake: the comparison with the programs without lanes finds it.
#include <gtest/gtest.h>

#include "../unit/model/descriptions.h"
#include "algorithm/catalogue/catalogue.h"
#include "packed_programs.h"
#include "pass/lanes/pack_lanes.h"
#include "pass/passes.h"
#include "symbolic/text.h"

namespace robcogen::numeric::lane_mistakes_test {
namespace {

using model::KinematicTree;
using symbolic::Program;

// Two legs of two joints on a fixed base that share only their topology.
KinematicTree two_legs() {
  model::Description d;
  d.name = "two_legs";
  d.base = model::test::link("base");
  double x = 0.3;
  const auto next = [&] { return model::test::number(x += 0.17); };
  const auto joint = [&](const std::string& name) {
    return model::test::joint(name, model::JointType::revolute, {{next(), next(), next()}, {next(), next(), next()}});
  };
  for (const std::string leg : {"left", "right"}) {
    for (const std::string part : {"upper", "lower"}) {
      model::DescribedLink link = model::test::link(leg + "_" + part);
      link.inertia = model::test::ball(1 + x, 0.5 + x);
      for (model::Quantity& q : link.inertia->com) q = next();
      d.links.push_back(link);
    }
    d.base.children.push_back({leg + "_upper", leg + "_hip", {}, {}});
    d.links[d.links.size() - 2].children.push_back({leg + "_lower", leg + "_knee", {}, {}});
    d.joints.push_back(joint(leg + "_hip"));
    d.joints.push_back(joint(leg + "_knee"));
  }
  Diagnostics diagnostics;
  const auto tree = model::build(d, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  return *tree;
}

// The comparison finds each single swap of two lanes: of numbers, of inputs, or of a lane that a statement reads. In
// these functions all numbers count, unlike in bias forces, where a mass on the axis of a knee has no effect.
TEST(LaneMistakes, SwappedLanesAreFound) {
  const KinematicTree tree = two_legs();
  int swapped = 0;
  for (const std::string group : {"inverse_dynamics", "joint_space_inertia"}) {
    for (const symbolic::Function& f : algorithm::functions(tree, {}, group)) {
      const Program program = pass::run(f.program, pass::names());
      const Program packed = pass::packed(program, classes_of(tree, program));
      ASSERT_TRUE(packed.has_lanes()) << program.name;
      ASSERT_EQ(difference(program, packed, 1), "") << program.name;
      const auto expect_found = [&](const Program& mutant, const std::string& what) {
        ++swapped;
        EXPECT_NE(difference(program, mutant, 1), "") << program.name << ": " << what << "\n"
                                                      << symbolic::print(packed);
      };
      for (std::size_t i = 0; i < packed.statements.size(); ++i) {
        Program mutant = packed;
        symbolic::Statement& s = mutant.statements[i];
        if (s.op == symbolic::Op::gather) {
          std::swap(s.lanes[0], s.lanes[1]);
          expect_found(mutant, "lanes of statement " + std::to_string(i));
          continue;
        }
        bool changed = false;
        symbolic::for_each_operand(s, [&](symbolic::Operand& o) {
          if (o.lane >= 0 && !changed) o.lane = 1 - o.lane;
          changed = changed || o.lane >= 0;
        });
        if (changed) expect_found(mutant, "a lane that statement " + std::to_string(i) + " reads");
      }
      for (std::size_t k = 0; k < packed.outputs[0].values.size(); ++k) {
        Program mutant = packed;
        symbolic::Operand& o = mutant.outputs[0].values[k];
        if (o.lane < 0) continue;
        o.lane = 1 - o.lane;
        expect_found(mutant, "output " + std::to_string(k));
      }
    }
  }
  EXPECT_GT(swapped, 100);
}

// The comparison finds each lost sign of a mirrored limb.
TEST(LaneMistakes, LostSignsAreFound) {
  const KinematicTree tree = document("quadruped_fixed");
  int lost = 0;
  for (const symbolic::Function& f : algorithm::functions(tree, {}, "inverse_dynamics")) {
    const Program program = pass::run(f.program, pass::names());
    const Program packed = pass::packed(program, classes_of(tree, program));
    for (std::size_t i = 0; i < packed.statements.size(); ++i) {
      for (std::size_t lane = 0; lane < packed.statements[i].lanes.size(); ++lane) {
        if (!packed.statements[i].lanes[lane].negative) continue;
        Program mutant = packed;
        mutant.statements[i].lanes[lane].negative = false;
        ++lost;
        EXPECT_NE(difference(program, mutant, 1), "") << program.name << ": statement " << i;
      }
    }
  }
  EXPECT_GT(lost, 0);
}

}  // namespace
}  // namespace robcogen::numeric::lane_mistakes_test
