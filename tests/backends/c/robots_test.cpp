// The C text of robots and of transforms compiles without a warning, and every function gives the interpreter's results
// in double and in single precision.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <random>

#include "../../unit/command/run_tool.h"
#include "algorithm/catalogue/catalogue.h"
#include "backend/c/printers.h"
#include "backend/casadi/casadi.h"
#include "driver/derivatives.h"
#include "driver/driver.h"
#include "symbolic/interpret.h"

namespace robcogen::backend {
namespace {

const std::filesystem::path kRobots = ROBCOGEN_ROBOTS_DIR;
constexpr const char* kStrict = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror ";

struct Asked {
  std::vector<std::string> groups = algorithm::groups();
  std::vector<std::string> derivatives = {};
  std::vector<std::string> contacts = {};
};

Library library(
    const std::filesystem::path& document,
    const std::string& name,
    const Asked& asked = {},
    const Features& features = {.caches_parameters = true}) {
  const std::filesystem::path desired = std::filesystem::path(document).replace_extension("dtdsl");
  driver::LoadOptions options;
  if (exists(desired)) options.desired = desired;
  for (const std::string& text : asked.derivatives) options.derivatives.push_back(driver::parse_derivative(text));
  options.contacts = asked.contacts;
  Diagnostics diagnostics;
  const auto model = driver::load(document, options, diagnostics);
  EXPECT_TRUE(model.has_value()) << document;
  return model ? driver::library(*model, {.names = {name}, .groups = asked.groups}, features) : Library();
}

// Writes the files into the folder, and a unit that includes all of them.
void write(const std::filesystem::path& folder, const Library& library) {
  std::string all;
  std::vector<OutputFile> files = c::print(library);
  files.push_back(casadi::print(library));
  for (const OutputFile& file : files) {
    create_directories((folder / file.path).parent_path());
    test::write_text(folder / file.path, file.text);
    if (file.path.extension() == ".c") all += "#include \"" + file.path.string() + "\"\n";
  }
  test::write_text(folder / "all.c", all);
}

// Returns what the command prints; empty if it succeeds and prints nothing.
std::string run(const std::filesystem::path& folder, const std::string& command) {
  const std::filesystem::path log = folder / "log";
  const int status = std::system(("cd " + folder.string() + " && " + command + " > log 2>&1").c_str());
  const std::string text = test::read_text(log);
  return status == 0 || !text.empty() ? text : "failed: " + command;
}

// Calls a compiled function. All arguments are pointers; the function does not read those beyond its last parameter.
void call(void* function, std::vector<void*> a) {
  using P = void*;
  using F = void (*)(P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P);
  ASSERT_LE(a.size(), 24U);
  a.resize(24, nullptr);
  reinterpret_cast<F>(function)(
      a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8], a[9], a[10], a[11], a[12], a[13], a[14], a[15], a[16],
      a[17], a[18], a[19], a[20], a[21], a[22], a[23]);
}

// Both sides use the same sines and the same order of operations. They differ only if the compiler fuses or reorders
// operations, which gcc does not do in this mode.
template <class Real>
constexpr Real kTolerance = 8 * std::numeric_limits<Real>::epsilon();

template <class Real>
std::vector<Real> random_values(const Library& library, const symbolic::InputArray& input, std::mt19937& dice) {
  std::vector<Real> values;
  for (const std::string& element : input.elements) {
    const std::vector<model::Parameter>& parameters = library.parameters();
    const auto p = std::find_if(parameters.begin(), parameters.end(), [&](const model::Parameter& parameter) {
      return input.role == symbolic::Role::parameters && parameter.name == element;
    });
    const double around = p == parameters.end() ? 0 : p->default_value.value_or(0);
    const double u = std::uniform_real_distribution<double>(-1, 1)(dice);
    // Loops close only near the position in which they are assembled.
    const bool is_near = !library.tree.loops.empty() && input.role == symbolic::Role::joint_position;
    values.push_back(static_cast<Real>(around == 0 ? (is_near ? 0.1 : 3) * u : around * (1 + u / 5)));
  }
  for (const int first : input.quaternions) {
    const auto begin = values.begin() + first;
    const Real norm = std::sqrt(std::inner_product(begin, begin + 4, begin, Real(0)));
    for (auto e = begin; e < begin + 4; ++e) *e /= norm;
  }
  return values;
}

// The cache that the updates compute from random parameters.
template <class Real>
std::vector<Real> random_cache(const Library& library, std::mt19937& dice) {
  std::map<std::string, Real> values;
  std::vector<Real> cache;
  for (const Function& update : library.updates) {
    symbolic::Arrays<Real> inputs;
    for (const symbolic::InputArray& input : update.program.inputs) {
      const std::vector<Real> drawn = random_values<Real>(library, input, dice);
      for (std::size_t k = 0; k < drawn.size(); ++k)
        inputs[input.name].push_back(values.insert({input.elements[k], drawn[k]}).first->second);
    }
    const symbolic::Arrays<Real> outputs = symbolic::interpret<Real>(update.program, inputs);
    const std::vector<Real>& part = outputs.at(update.program.outputs.front().name);
    cache.insert(cache.end(), part.begin(), part.end());
  }
  return cache;
}

// Returns a line for each difference between the function and the interpreter.
template <class Real>
std::string differences(const Library& library, const c::NamedFunction& c, void* function, std::mt19937& dice) {
  const symbolic::Program& program = c.function->program;
  const std::string& name = sizeof(Real) == 4 ? c.name_in_float : c.name;
  if (!function) return name + " is missing\n";
  symbolic::Arrays<Real> inputs;
  std::vector<std::vector<Real>> arrays;
  for (const symbolic::InputArray& input : program.inputs) {
    const bool reads_cache = !library.updates.empty() && c.function->group != c::kParametersGroup;
    const bool is_cache = reads_cache && input.role == symbolic::Role::parameters;
    const std::vector<Real>& values = inputs[input.name] =
        is_cache ? random_cache<Real>(library, dice) : random_values<Real>(library, input, dice);
    arrays.push_back(values);
    if (input.role != symbolic::Role::parameters || is_cache) continue;
    // The structure holds all parameters, including those that the function does not read.
    std::vector<Real> all;
    for (const model::Parameter& p : library.parameters()) {
      const auto place = std::find(input.elements.begin(), input.elements.end(), p.name);
      all.push_back(place == input.elements.end() ? Real(-7) : values[std::size_t(place - input.elements.begin())]);
    }
    arrays.back() = all;
  }
  const std::size_t first = arrays.size();
  for (const symbolic::OutputArray& output : program.outputs)
    arrays.emplace_back(output.values.size(), std::numeric_limits<Real>::quiet_NaN());
  std::vector<void*> arguments;
  for (std::vector<Real>& array : arrays) arguments.push_back(array.data());
  call(function, arguments);
  const symbolic::Arrays<Real> expected = symbolic::interpret<Real>(program, inputs);
  std::string report;
  for (std::size_t o = 0; o < program.outputs.size(); ++o) {
    const std::vector<Real>& wanted = expected.at(program.outputs[o].name);
    Real largest = 0;
    for (const Real value : wanted) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const Real got = arrays[first + o][k];
      if (std::abs(got - wanted[k]) <= kTolerance<Real> * largest) continue;
      report += name + ": element " + std::to_string(k) + " of " + program.outputs[o].name + " is " +
                std::to_string(got) + ", not " + std::to_string(wanted[k]) + "\n";
      break;
    }
  }
  return report;
}

std::string differences(const Library& library, const std::filesystem::path& folder) {
  const std::string errors = run(folder, "gcc " + (kStrict + std::string("-O0 -shared -fPIC -I. all.c -o all.so -lm")));
  if (!errors.empty()) return errors;
  void* const loaded = dlopen((folder / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) return dlerror();
  std::mt19937 dice(7);
  std::string report;
  for (const c::NamedFunction& c : c::names(library).functions) {
    for (int state = 0; state < 3; ++state) {
      report += differences<double>(library, c, dlsym(loaded, c.name.c_str()), dice);
      report += differences<float>(library, c, dlsym(loaded, c.name_in_float.c_str()), dice);
    }
  }
  dlclose(loaded);
  return report;
}

std::string differences(const Library& library) {
  const test::Scratch scratch("c-" + library.name);
  write(scratch.path, library);
  return differences(library, scratch.path);
}

class CRobots : public testing::TestWithParam<std::string> {};

TEST_P(CRobots, GiveWhatTheInterpreterGives) {
  const bool has_all =
      GetParam() == "hyl" || GetParam() == "hyl_parametric" || GetParam() == "gripper" || GetParam() == "ball_leg";
  const Library robot = library(
      kRobots / GetParam() / (GetParam() + ".kindsl"), GetParam(),
      {has_all ? algorithm::groups() : algorithm::default_groups()});
  ASSERT_GT(robot.functions.size(), 20U);
  EXPECT_EQ(differences(robot), "");
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    CRobots,
    testing::Values(
        "hyl_parametric",
#if ROBCOGEN_TEST_EVERYTHING
        "ball_leg",
        "hyl",
        "geared_leg",
        "achilles_leg",
        "gripper",
        "puma560",
        "quadruped",
        "scara",
#endif
        "five_bar"),
    [](const auto& robot) { return robot.param; });

// The parameters stand in couplings and pitches.
TEST(C, ParametersOfJointsGiveWhatTheInterpreterGives) {
  const Library robot = library(
      std::filesystem::path(TEST_SOURCE_DIR) / "../../drives/adjustable.kindsl", "adjustable",
      {algorithm::default_groups()});
  ASSERT_EQ(robot.tree.parameters.size(), 5U);
  EXPECT_EQ(differences(robot), "");
}

// With the same parameters, functions called after an update give the results of the program that computes everything
// at once.
TEST(C, UpdatedCachesStandForTheParameters) {
  const std::filesystem::path document = kRobots / "hyl_parametric" / "hyl_parametric.kindsl";
  const Library leg = library(document, "leg", {{"inverse_dynamics"}});
  ASSERT_FALSE(leg.updates.empty());
  const test::Scratch scratch("c-update");
  write(scratch.path, leg);
  ASSERT_EQ(run(scratch.path, "gcc " + (kStrict + std::string("-shared -fPIC -I. all.c -o all.so -lm"))), "");
  void* const loaded = dlopen((scratch.path / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << dlerror();
  Diagnostics diagnostics;
  const auto model = driver::load(document, {}, diagnostics);
  const Library plain = driver::library(*model, {.names = {"leg"}, .groups = {"inverse_dynamics"}});
  const symbolic::Program& program = plain.functions.front().program;

  const std::vector<model::Parameter>& parameters = leg.tree.parameters;
  std::vector<double> all, cache(1000, std::numeric_limits<double>::quiet_NaN());
  symbolic::Arrays<double> inputs;
  while (all.size() < parameters.size()) all.push_back(0.5 + 0.1 * static_cast<double>(all.size()));
  std::vector<std::vector<double>> arrays = {cache};
  for (const symbolic::InputArray& input : program.inputs) {
    std::vector<double>& values = inputs[input.name];
    for (const std::string& element : input.elements) {
      const auto p = std::find_if(parameters.begin(), parameters.end(), [&](const model::Parameter& parameter) {
        return parameter.name == element;
      });
      const bool is_parameter = input.role == symbolic::Role::parameters;
      values.push_back(is_parameter ? all[std::size_t(p - parameters.begin())] : 0.3 * double(values.size()) - 0.7);
    }
    if (input.role != symbolic::Role::parameters) arrays.push_back(values);
  }
  arrays.emplace_back(3, 0.0);
  call(dlsym(loaded, "leg_update"), {all.data(), arrays.front().data()});
  std::vector<void*> arguments;
  for (std::vector<double>& array : arrays) arguments.push_back(array.data());
  call(dlsym(loaded, "leg_inverse_dynamics"), arguments);
  const std::vector<double> wanted = symbolic::interpret<double>(program, inputs).at(program.outputs.front().name);
  // The two are different formulations of the same dynamics.
  for (std::size_t j = 0; j < wanted.size(); ++j) EXPECT_NEAR(arrays.back()[j], wanted[j], 1e-12 * 300);
  dlclose(loaded);
}

#if ROBCOGEN_TEST_EVERYTHING
// Columns solved for in a loop equal the written-out ones to rounding, also with a parameter from a cache.
class ColumnLoops : public testing::TestWithParam<std::string> {};

TEST_P(ColumnLoops, GiveWhatIsWrittenOut) {
  const test::Scratch scratch("c-columns-" + GetParam());
  const std::filesystem::path hexapod = kRobots / "hexapod", document = scratch.path / "hexapod.kindsl";
  std::string text = test::read_text(hexapod / "hexapod.kindsl");
  const std::string mass = "mass = 1.2";
  text.replace(text.find(mass), mass.size(), GetParam() == "parameter" ? "mass = body_mass[1.2]" : mass);
  test::write_text(document, text);
  copy(hexapod / "parts", scratch.path / "parts");
  const Asked asked = {{"inverse_dynamics_derivatives", "forward_dynamics_derivatives"}};
  const Library plain = library(document, "robot", asked, {});
  const Library looped =
      library(document, "robot", asked, {.caches_parameters = true, .column_loops = backend::ColumnLoops::if_faster});
  ASSERT_EQ(
      std::count_if(looped.functions.begin(), looped.functions.end(), [](const Function& f) { return f.solved; }), 4);
  write(scratch.path, looped);
  ASSERT_EQ(run(scratch.path, "gcc " + (kStrict + std::string("-shared -fPIC -I. all.c -o all.so -lm"))), "");
  void* const loaded = dlopen((scratch.path / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << dlerror();
  std::vector<double> parameters = {1.3}, cache(1000, std::numeric_limits<double>::quiet_NaN());
  if (!looped.updates.empty()) call(dlsym(loaded, "robot_update"), {parameters.data(), cache.data()});
  std::mt19937 dice(7);
  for (const c::NamedFunction& c : c::names(plain).functions) {
    const symbolic::Program& program = c.function->program;
    symbolic::Arrays<double> inputs;
    std::vector<std::vector<double>> arrays;
    for (const symbolic::InputArray& input : program.inputs) {
      const bool is_parameter = input.role == symbolic::Role::parameters;
      inputs[input.name] = is_parameter ? parameters : random_values<double>(plain, input, dice);
      arrays.push_back(is_parameter ? cache : inputs[input.name]);
    }
    const std::size_t first = arrays.size();
    for (const symbolic::OutputArray& output : program.outputs) arrays.emplace_back(output.values.size());
    std::vector<void*> arguments;
    for (std::vector<double>& array : arrays) arguments.push_back(array.data());
    call(dlsym(loaded, c.name.c_str()), arguments);
    const symbolic::Arrays<double> expected = symbolic::interpret<double>(program, inputs);
    for (std::size_t o = 0; o < program.outputs.size(); ++o) {
      const std::vector<double>& wanted = expected.at(program.outputs[o].name);
      double largest = 1;
      for (const double value : wanted) largest = std::max(largest, std::abs(value));
      for (std::size_t k = 0; k < wanted.size(); ++k)
        ASSERT_NEAR(arrays[first + o][k], wanted[k], 1e-11 * largest) << c.name << ", " << program.outputs[o].name;
    }
  }
  dlclose(loaded);
}

const std::string kColumnLoops[] = {
    "parameter",
    "constants",
};
INSTANTIATE_TEST_SUITE_P(Of, ColumnLoops, testing::ValuesIn(kColumnLoops), [](const auto& kind) { return kind.param; });
#endif

TEST(C, DerivativesAndContactsGiveWhatTheInterpreterGives) {
  const Library leg = library(
      kRobots / "hyl_parametric" / "hyl_parametric.kindsl", "leg",
      {{"inverse_dynamics"}, {"inverse_dynamics:q,parameters", "jacobians.fr_base_J_fr_foot:q"}});
  EXPECT_EQ(differences(leg), "");
  const Library walker = library(
      kRobots / "quadruped" / "quadruped.kindsl", "walker",
      {{"contacts", "operational_space"}, {}, {"fr_LF_foot", "fr_RH_foot"}});
  EXPECT_TRUE(std::any_of(walker.functions.begin(), walker.functions.end(), [](const Function& f) {
    return f.group == "contacts" || f.group == "operational_space";
  }));
  EXPECT_EQ(differences(walker), "");
}

TEST(C, TransformsWithNoRobotGiveWhatTheInterpreterGives) {
  const Library euler =
      library(kRobots / "euler" / "euler.motdsl", "euler", {{}, {"transforms.homogeneous.S_X_zyx:variables"}});
  ASSERT_GT(euler.functions.size(), 5U);
  EXPECT_EQ(differences(euler), "");
  EXPECT_EQ(differences(library(kRobots / ".." / "tests/backends/octave/products.ctdsl", "products")), "");
}

// Names that are keywords of C or names from its library and headers; text that would end or continue a comment or form
// a trigraph.
TEST(C, TakesAnyName) {
  Library names = library(
      std::filesystem::path(TEST_SOURCE_DIR) / "../../codegen/names.kindsl", "names", {algorithm::default_groups()});
  names.tree.name = "what?\?/";
  names.model_file = "a*/b\\\n?\?/";
  names.tree.joints.front().name = "a\"b?\?/";
  EXPECT_EQ(differences(names), "");
}

TEST(C, WithOneSignWrongIsFoundOut) {
  const Library hyl = library(kRobots / "hyl" / "hyl.kindsl", "hyl", {{"forward_dynamics"}});
  const test::Scratch scratch("c-wrong");
  write(scratch.path, hyl);
  const std::filesystem::path file = scratch.path / "hyl_c" / "forward_dynamics_f.c";
  std::string text = test::read_text(file);
  text[text.find(" - ", text.find("void hyl_forward_dynamics_externalf(")) + 1] = '+';
  test::write_text(file, text);
  const std::string report = differences(hyl, scratch.path);
  EXPECT_EQ(report.find("hyl_forward_dynamics_externalf: element"), 0U) << report;
  EXPECT_EQ(report.find("hyl_forward_dynamicsf"), std::string::npos) << report;
}

// Long functions are generated in parts.
TEST(C, LongFunctionsGiveWhatTheInterpreterGives) {
  const Library humanoid = library(kRobots / "humanoid" / "humanoid.kindsl", "humanoid", {{"centroidal"}});
  std::string text;
  for (const OutputFile& file : c::print(humanoid)) text += file.text;
  EXPECT_NE(text.find("static void humanoid__"), std::string::npos);
  EXPECT_EQ(differences(humanoid), "");
}

// Clang has other warnings than gcc, and the headers must compile as C++ too.
TEST(C, OtherCompilersTakeIt) {
  const test::Scratch scratch("c-compilers");
  write(scratch.path, library(kRobots / "hyl_parametric" / "hyl_parametric.kindsl", "leg"));
  test::write_text(scratch.path / "header.cpp", "#include \"leg_c/leg_c.h\"\n");
  EXPECT_EQ(run(scratch.path, "g++ -std=c++17 -Wall -Wextra -pedantic -Werror -fsyntax-only -I. header.cpp"), "");
  if (std::string(CLANG).empty()) GTEST_SKIP() << "clang was not found";
  EXPECT_EQ(run(scratch.path, CLANG " " + (kStrict + std::string("-fsyntax-only -I. all.c"))), "");
}

// The example of the guide compiles and runs.
TEST(C, TheExampleOfTheGuideRuns) {
  const std::string guide = test::read_text(kRobots / ".." / "runtime" / "LANGUAGES.md");
  const std::size_t begin = guide.find("\n```c\n"), end = guide.find("\n```\n", begin);
  ASSERT_NE(begin, std::string::npos);
  const test::Scratch scratch("c-guide");
  write(scratch.path, library(kRobots / "hyl" / "hyl.kindsl", "hyl", {algorithm::default_groups()}));
  test::write_text(scratch.path / "main.c", guide.substr(begin + 6, end - begin - 5));
  const std::string output =
      run(scratch.path, "gcc " + (kStrict + std::string("-I. main.c all.c -o main -lm && ./main")));
  // The program prints the forces that hold 7.501 kg on the moon, and the accelerations.
  EXPECT_EQ(output.find("SLIDE"), 0U) << output;
}

// Two names in double precision whose single-precision counterparts would coincide.
TEST(C, NamesOfBothPrecisionsDiffer) {
  Library library;
  library.name = "hyl";
  library.enclosing = "a::b";
  for (const char* kernel : {"x", "xf", "parameters", "xff"}) {
    library.functions.emplace_back();
    library.functions.back().kernel = kernel;
  }
  std::vector<std::string> names;
  for (const c::NamedFunction& c : c::names(library).functions) names.insert(names.end(), {c.name, c.name_in_float});
  EXPECT_EQ(
      names, (std::vector<std::string>{
                 "a_b_hyl_x", "a_b_hyl_xf_2", "a_b_hyl_xf", "a_b_hyl_xff_2", "a_b_hyl_parameters_2",
                 "a_b_hyl_parameters_2f", "a_b_hyl_xff", "a_b_hyl_xfff"}));
}

}  // namespace
}  // namespace robcogen::backend
