// The text for GPUs, compiled as C++ for the host: every function over many states, with arrays of mixed layouts, gives
// the interpreter's results in double and in single precision.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <utility>

#include "algorithm/catalogue/catalogue.h"
#include "driver/derivatives.h"
#include "states.h"

namespace robcogen::test {
namespace {

using backend::Library;
using backend::gpu::StatesFunction;

const std::string kStrict = "-Wall -Wextra -Wconversion -Wshadow -Werror -I. -I" ROBCOGEN_RUNTIME_DIR " ";
constexpr int kStates = 35;

// Calls a compiled function. It does not read arrays beyond its last parameter, which are on the stack.
template <std::size_t... k>
int call(void* function, std::ptrdiff_t n, std::vector<robcogen_gpu_array> a, std::index_sequence<k...>) {
  a.resize(sizeof...(k), {});
  using F = int (*)(void*, std::ptrdiff_t, decltype((void)k, robcogen_gpu_array())...);
  return reinterpret_cast<F>(function)(nullptr, n, a[k]...);
}

int call(void* function, std::ptrdiff_t n, const std::vector<robcogen_gpu_array>& a) {
  EXPECT_LE(a.size(), 80U);
  return call(function, n, a, std::make_index_sequence<80>());
}

// Returns a line for the first difference between the function and the interpreter. `layouts`: of the arrays in turn.
template <class Real>
std::string differences(
    const Library& library,
    const StatesFunction& f,
    void* symbol,
    const std::vector<robcogen_gpu_layout>& layouts) {
  if (!symbol) return f.name + " is missing\n";
  const backend::Function& function = *f.function->function;
  std::mt19937_64 engine(7);
  const States<Real> states = random_states<Real>(library, function.program, kStates, engine);
  std::vector<Memory<Real>> memory = memory_of(f, states, kStates, layouts);
  std::vector<robcogen_gpu_array> arrays;
  for (const Memory<Real>& m : memory) arrays.push_back(m.array());
  if (const int status = call(symbol, kStates, arrays); status != 0)
    return f.name + ": " + robcogen_gpu_message(static_cast<robcogen_gpu_status>(status)) + "\n";
  for (std::size_t a = 0; a < f.arrays.size(); ++a) {
    const std::string wrong = difference(memory[a], states.arrays[a], kStates, tolerance<Real>(function));
    if (!wrong.empty())
      return f.name + (sizeof(Real) == 4 ? " in float: " : ": ") + f.arrays[a].array.name + wrong + "\n";
  }
  return "";
}

// The same for the function that computes the cache.
template <class Real>
std::string differences_of_update(const Library& library, const StatesFunction& f, void* symbol) {
  if (!symbol) return "update is missing\n";
  States<Real> states;
  std::vector<Real> parameters;
  for (const model::Parameter& p : library.parameters())
    parameters.push_back(static_cast<Real>(kOfDefault * p.default_value.value_or(1)));
  states.arrays = {
      std::vector<std::vector<Real>>(kStates, parameters),
      std::vector<std::vector<Real>>(kStates, cache_of<Real>(library))};
  std::vector<Memory<Real>> memory = memory_of(f, states, kStates, {robcogen_gpu_by_state});
  if (call(symbol, kStates, {memory[0].array(), memory[1].array()}) != 0) return "update failed\n";
  const std::string wrong = difference(memory[1], states.arrays[1], kStates, 16 * std::numeric_limits<Real>::epsilon());
  return wrong.empty() ? "" : "update" + wrong + "\n";
}

std::string differences(const Library& library, const std::filesystem::path& folder) {
  std::string all;
  for (const OutputFile& file : backend::gpu::print(library))
    if (file.path.extension() == ".cu") all += "#include \"" + file.path.string() + "\"\n";
  write_text(folder / "all.cpp", all);
  const std::string errors = run(folder, "g++ -std=c++17 " + kStrict + "-O0 -shared -fPIC all.cpp -o all.so");
  if (!errors.empty()) return errors;
  void* const loaded = dlopen((folder / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) return dlerror();
  const std::string prefix = library.name + "_gpu";
  const backend::gpu::Names names = backend::c::names(library, prefix, prefix);
  std::string report;
  for (const std::string& group : library.groups) {
    for (const StatesFunction& f : backend::gpu::states_functions(names, group)) {
      const std::string name = prefix + "_batch_" + f.name;
      const std::vector<robcogen_gpu_layout> mixed = {
          robcogen_gpu_by_element, robcogen_gpu_by_state, robcogen_gpu_by_tile};
      report += differences<double>(library, f, dlsym(loaded, name.c_str()), {robcogen_gpu_by_tile});
      report += differences<float>(library, f, dlsym(loaded, (name + "f").c_str()), {robcogen_gpu_by_tile});
      report += differences<float>(library, f, dlsym(loaded, (name + "f").c_str()), mixed);
    }
  }
  for (const StatesFunction& update : backend::gpu::states_functions(names, backend::c::kParametersGroup)) {
    const std::string name = prefix + "_batch_update";
    report += differences_of_update<double>(library, update, dlsym(loaded, name.c_str()));
    report += differences_of_update<float>(library, update, dlsym(loaded, (name + "f").c_str()));
  }
  dlclose(loaded);
  return report;
}

std::string differences(const Library& library) {
  const Scratch scratch("gpu-" + library.name);
  write_gpu(scratch.path, library);
  return differences(library, scratch.path);
}

struct Asked {
  std::string robot;
  std::vector<std::string> groups = algorithm::default_groups();
  std::vector<std::string> derivatives = {};
};

Library library(const Asked& asked) {
  std::vector<driver::Derivative> derivatives;
  for (const std::string& text : asked.derivatives) derivatives.push_back(driver::parse_derivative(text));
  return library_of(
      kRobots / asked.robot / (asked.robot + ".kindsl"), asked.robot, std::nullopt, derivatives, asked.groups,
      kGpuFeatures);
}

class GpuRobots : public testing::TestWithParam<Asked> {};

TEST_P(GpuRobots, GiveWhatTheInterpreterGives) {
  const Library robot = library(GetParam());
  ASSERT_FALSE(robot.functions.empty());
  EXPECT_EQ(differences(robot), "");
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    GpuRobots,
    testing::Values(
        Asked{"hyl"},
        Asked{"hyl_parametric", {"inverse_dynamics", "joint_space_inertia"}, {"inverse_dynamics:q,parameters"}},
        // Columns are solved for in a loop.
        Asked{"geared_leg", {"inverse_dynamics_derivatives", "forward_dynamics_derivatives"}},
#if ROBCOGEN_TEST_EVERYTHING
        Asked{"iiwa14", algorithm::groups()},
        Asked{"centaur", algorithm::groups()},
        Asked{"humanoid"},
        Asked{"hexapod"},
        Asked{"gripper", algorithm::groups()},
        Asked{"puma560"},
        Asked{"scara"},
        Asked{"delta"},
#endif
        Asked{"five_bar", {"forward_dynamics", "transforms"}},
        // Many arrays: the poses of all frames.
        Asked{"quadruped", {"all_frames"}},
        Asked{"ball_leg", {"inverse_dynamics", "world"}}),
    [](const auto& asked) { return asked.param.robot; });

TEST(Gpu, WrongArgumentsAreRefused) {
  const Library leg = library({"hyl", {"joint_space_inertia"}});
  const Scratch scratch("gpu-refused");
  write_gpu(scratch.path, leg);
  ASSERT_EQ(
      run(scratch.path,
          "g++ -std=c++17 " + kStrict + "-O0 -shared -fPIC -x c++ hyl_gpu/joint_space_inertia.cu -o all.so"),
      "");
  void* const loaded = dlopen((scratch.path / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << dlerror();
  void* const inertia = dlsym(loaded, "hyl_gpu_batch_joint_space_inertiaf");
  ASSERT_NE(inertia, nullptr);
  std::vector<float> q(9 * 32), H(9 * 32);
  const auto status = [&](std::ptrdiff_t n, const robcogen_gpu_array& first, const robcogen_gpu_array& second) {
    return static_cast<robcogen_gpu_status>(call(inertia, n, {first, second}));
  };
  const robcogen_gpu_array tiles = {q.data(), robcogen_gpu_by_tile, 0}, results = {H.data(), robcogen_gpu_by_tile, 0};
  const char* const between = reinterpret_cast<const char*>(q.data()) + 1;
  EXPECT_EQ(status(32, tiles, results), robcogen_gpu_success);
  EXPECT_EQ(status(0, {}, {}), robcogen_gpu_success);
  EXPECT_EQ(status(-1, tiles, results), robcogen_gpu_negative_count);
  EXPECT_EQ(status(1, {}, results), robcogen_gpu_misaligned);
  EXPECT_EQ(status(1, {between, robcogen_gpu_by_tile, 0}, results), robcogen_gpu_misaligned);
  EXPECT_EQ(status(8, {q.data(), robcogen_gpu_by_element, 7}, results), robcogen_gpu_wrong_stride);
  EXPECT_EQ(status(8, {q.data(), robcogen_gpu_by_state, 2}, results), robcogen_gpu_wrong_stride);
  EXPECT_EQ(status(std::ptrdiff_t(1) << 31, tiles, results), robcogen_gpu_too_large);
  EXPECT_EQ(status(std::ptrdiff_t(1) << 28, tiles, results), robcogen_gpu_too_large);
  EXPECT_EQ(status(8, {q.data(), robcogen_gpu_by_element, 1 << 30}, results), robcogen_gpu_too_large);
  dlclose(loaded);
}

TEST(Gpu, WithOneSignWrongIsFoundOut) {
  const Library leg = library({"hyl", {"joint_space_inertia"}});
  const Scratch scratch("gpu-wrong");
  write_gpu(scratch.path, leg);
  const std::filesystem::path file = scratch.path / "hyl_gpu" / "joint_space_inertia.h";
  std::string text = read_text(file);
  text[text.find(" - ") + 1] = '+';
  write_text(file, text);
  EXPECT_EQ(differences(leg, scratch.path).find("joint_space_inertia: H: element"), 0U);
}

}  // namespace
}  // namespace robcogen::test
