// The parts of a module other than its numbers: names, defaults, messages, constants, layout.
#include <fmt/format.h>

#include <sstream>

#include "node.h"

namespace robcogen::test::module_test {
namespace {

const std::filesystem::path kRobots = ROBCOGEN_ROBOTS_DIR;

class JavaScriptModule : public WithNode {};

// Runs a script that imports the robot's module as `hyl`, and returns the lines that it prints.
std::vector<std::string> run_beside(const backend::Library& library, const std::string& script) {
  return run_node({module_of(library), {"script.mjs", "import * as hyl from './hyl.mjs';\n" + script}});
}

backend::Library robot(const std::string& name) {
  return library_of(kRobots / name / (name + ".kindsl"), "hyl", std::nullopt, {}, algorithm::default_groups());
}

TEST_F(JavaScriptModule, LeavesOutGravityAndWrenches) {
  const std::vector<std::string> lines = run_beside(robot("hyl"), R"(
const q = [0.1, 0.2, 0.3], z = [0, 0, 0];
const none = Array(4).fill([0, 0, 0, 0, 0, 0]);
console.log(String(hyl.inverse_dynamics(q, z, z)) === String(hyl.inverse_dynamics(q, z, z, [0, 0, -9.81], none)));
console.log(String(hyl.gravity_forces(q)) === String(hyl.gravity_forces(q, [0, 0, -9.81])));
console.log(String(hyl.gravity_forces(q)) === String(hyl.gravity_forces(q, [0, 0, -1.62])));
console.log(String(hyl.inverse_dynamics(new Float64Array(q), z, z)) === String(hyl.inverse_dynamics(q, z, z)));
)");
  EXPECT_EQ(lines, (std::vector<std::string>{"true", "true", "false", "true"}));
}

// The elements of a limb are the robot's elements whose names begin with the limb's name.
TEST_F(JavaScriptModule, KnowsTheLimbs) {
  const std::string script = R"(
const { joints, links, frames, limbs } = hyl.model;
console.log(limbs.map((limb) => limb.name + ' ' + limb.part + ' ' + limb.first_link).join(', '));
let wrong = 0, count = 0;
for (const limb of limbs)
  for (const [own, all] of [[limb.links, links], [limb.joints, joints], [limb.frames, frames]])
    for (const [name, index] of Object.entries(own)) {
      const expected = (limb.name + '_' + name).replace(/^(.*)_fr_/, 'fr_$1_');
      if (all[index].name !== expected) ++wrong;
      ++count;
    }
console.log(wrong, count);
)";
  EXPECT_EQ(
      run_beside(robot("quadruped"), script),
      (std::vector<std::string>{"LF Leg 1, RF Leg 4, LH Leg 7, RH Leg 10", "0 40"}));
  EXPECT_EQ(run_beside(robot("hyl"), script), (std::vector<std::string>{"", "0 0"}));
}

TEST_F(JavaScriptModule, SaysWhatIsWrongWithArguments) {
  const std::string script = R"(
const said = (call) => {
  try {
    console.log("nothing: " + call());
  } catch (fault) {
    console.log(fault instanceof TypeError ? fault.message : String(fault.stack));
  }
};
)";
  const std::vector<std::string> fixed = run_beside(robot("hyl"), script + R"(
const q = [0.1, 0.2, 0.3];
said(() => hyl.gravity_forces());
said(() => hyl.gravity_forces([1, 2]));
said(() => hyl.gravity_forces([1, 2, "3"]));
said(() => hyl.gravity_forces(q, 9.81));
said(() => hyl.inverse_dynamics(q, q, q, [0, 0, 0], [1]));
said(() => hyl.inertia_factor.inverse_L([[1, 0], [0, 1]], q));
)");
  EXPECT_EQ(
      fixed, (std::vector<std::string>{
                 "gravity_forces: q must be an array of 3 numbers, is undefined",
                 "gravity_forces: q must be an array of 3 numbers, is an array of 2",
                 "gravity_forces: q[2] must be a number, is string",
                 "gravity_forces: gravity (m/s^2, in base coordinates) must be an array of 3 numbers, is number",
                 "inverse_dynamics: external must be an array of 4 arrays of 6 numbers, is an array of 1",
                 "inertia_factor.inverse_L: L must be an array of 3 arrays of 3 numbers, is an array of 2"}));
  const std::vector<std::string> parametric = run_beside(robot("hyl_parametric"), script + R"(
said(() => hyl.gravity_forces([1, 2, 3]));
said(() => hyl.gravity_forces(undefined, [1, 2, 3]));
said(() => hyl.gravity_forces({ ...hyl.parameters(), upperleg_length: NaN }, [1, 2, 3]));
)");
  EXPECT_EQ(
      parametric, (std::vector<std::string>{
                      "gravity_forces: parameters.slider_mass must be a number, is undefined",
                      "gravity_forces: parameters must be an object, as parameters() returns it, is undefined",
                      "gravity_forces: parameters.upperleg_length must be a number, is NaN"}));
  const std::vector<std::string> floating = run_beside(robot("quadruped"), script + R"(
said(() => hyl.gravity_forces(Array(12).fill(0)));
)");
  EXPECT_EQ(
      floating, std::vector<std::string>{"gravity_forces: gravity (m/s^2, in base coordinates) must be an array of 3 "
                                         "numbers, is undefined"});
}

TEST_F(JavaScriptModule, RefusesQuaternionsOfAnotherLength) {
  const std::vector<std::string> lines = run_beside(robot("ball_leg"), R"(
const rest = [0, 0, 0, 0];
for (const q of [[1, 0, 0, 0], [0.7071, 0.7071, 0, 0], [NaN, 0, 0, 0], [1, 0.2, 0, 0], rest])
  try {
    console.log(hyl.gravity_forces([1, 0, 0, 0, 0, ...q]).length);
  } catch (fault) {
    console.log(fault instanceof RangeError ? fault.message : String(fault.stack));
  }
)");
  const std::string refused = "gravity_forces: q: elements 5 to 8 must be a unit quaternion w, x, y, z, have norm ";
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0] + lines[1] + lines[2], "777");
  EXPECT_EQ(lines[3].rfind(refused + "1.0198", 0), 0U) << lines[3];
  EXPECT_EQ(lines[4], refused + "0");
}

TEST_F(JavaScriptModule, HasConstantsOfTheRobot) {
  const std::vector<std::string> lines = run_beside(robot("scara"), R"(
const { name, dof, joints, coupled_joints, links, frames } = hyl.model;
console.log(name, dof, joints.length, coupled_joints.length, links.length, frames.length > 0);
console.log(joints.map((j) => j.type).join(" "));
console.log(links.every((l, k) => (k === 0) === (l.parent_joint === -1)));
console.log(joints.every((j, k) => links[j.child].parent_joint === k && j.parent < links.length));
console.log(coupled_joints.every((j) => j.factors.length === dof && typeof j.offset === "number"));
)");
  const backend::Library scara = robot("scara");
  std::string types;
  for (const int j : scara.tree.coordinates()) {
    const model::JointType type = scara.tree.joints[static_cast<std::size_t>(j)].type;
    types += (types.empty() ? "" : " ") + std::string(
                                              type == model::JointType::revolute    ? "revolute"
                                              : type == model::JointType::prismatic ? "prismatic"
                                                                                    : "helical");
  }
  EXPECT_EQ(
      lines, (std::vector<std::string>{
                 fmt::format(
                     "{} {} {} {} {} true", scara.title(), scara.tree.dof(), scara.tree.dof(),
                     scara.tree.couplings.size(), scara.tree.link_count()),
                 types, "true", "true", "true"}));
}

// The user supplies the matrices of rotations and translations; they are multiplied in the order of the homogeneous
// transform.
TEST_F(JavaScriptModule, MultipliesPrimitivesOfTheUser) {
  for (const char* name : {"hyl_parametric", "quadruped_fixed"}) {
    const backend::Library library = library_of(
        kRobots / name / (std::string(name) + ".kindsl"), "hyl", model::MovedFramePosition::right, {}, {"transforms"});
    const std::vector<std::string> lines = run_beside(library, R"(
const { cos, sin, abs } = Math;
const primitives = {
  Rx: (a) => [[1, 0, 0, 0], [0, cos(a), -sin(a), 0], [0, sin(a), cos(a), 0], [0, 0, 0, 1]],
  Ry: (a) => [[cos(a), 0, sin(a), 0], [0, 1, 0, 0], [-sin(a), 0, cos(a), 0], [0, 0, 0, 1]],
  Rz: (a) => [[cos(a), -sin(a), 0, 0], [sin(a), cos(a), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  Tx: (d) => [[1, 0, 0, d], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  Ty: (d) => [[1, 0, 0, 0], [0, 1, 0, d], [0, 0, 1, 0], [0, 0, 0, 1]],
  Tz: (d) => [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]],
  multiply: (A, B) => A.map((row) => B[0].map((_, c) => row.reduce((sum, a, k) => sum + a * B[k][c], 0))),
};
const q = Array.from({ length: hyl.model.dof }, (_, k) => 0.3 + 0.2 * k);
const first = hyl.parameters ? [hyl.parameters(), q] : [q];
let worst = 0, count = 0;
for (const [name, product] of Object.entries(hyl.transforms.product)) {
  const X = product(...first, primitives).flat(), Y = hyl.transforms.homogeneous[name](...first).flat();
  for (let k = 0; k < 16; ++k) worst = Math.max(worst, abs(X[k] - Y[k]));
  count += 1;
}
console.log(count > 5, worst < 1e-14);
)");
    EXPECT_EQ(lines, std::vector<std::string>{"true true"}) << name;
  }
}

TEST_F(JavaScriptModule, TakesAnyName) {
  const std::filesystem::path tests = std::filesystem::path(TEST_SOURCE_DIR);
  for (const auto& document : {tests / "words.kindsl", tests / "../../codegen/names.kindsl"}) {
    const backend::Library library = library_of(document, "await", model::MovedFramePosition::left);
    EXPECT_EQ(differences(library, module_of(library)), "");
  }
}

TEST_F(JavaScriptModule, KeepsTheUsersTextInItsComments) {
  backend::Library library = robot("hyl");
  library.model_file = "a*/b\n*/\xE2\x80\xA8(/*.kindsl";
  library.tree.name = "a\"\\b\n";
  library.functions.front().summary = {"a */ b"};
  library.functions.front().program.sections.front().title = "one\ntwo\xE2\x80\xA9three";
  EXPECT_EQ(differences(library, module_of(library)), "");
}

TEST(JavaScriptText, TellsEnclosingNamespaces) {
  backend::Library library = robot("hyl");
  library.enclosing = "a::b";
  EXPECT_EQ(module_of(library).path, "a_b_hyl.mjs");
}

TEST(JavaScriptText, IsTidy) {
  constexpr std::size_t kMaxColumns = 119;
  for (const char* name : {"hyl_parametric", "scara", "quadruped"}) {
    std::istringstream text(module_of(robot(name)).text);
    for (std::string line; std::getline(text, line);) {
      EXPECT_LE(line.size(), kMaxColumns) << line;
      EXPECT_FALSE(line.ends_with(' ') || line.find('\t') != std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace robcogen::test::module_test
