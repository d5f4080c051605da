// Generates code for random robots with congruent limbs, with various options of the generator, and compiles it. If
// code is not generated or does not compile, it reports the seed and the options.
//
//     compile_limbed_robots TOOL DIR FIRST COUNT COMPILER...
//     compile_limbed_robots --run SOURCES TOOL DIR FIRST COUNT COMPILER...
//
// `COMPILER…` is a command that takes the name of one unit. A unit contains the code of many robots, so that the
// compiler reads headers once. With --run each robot, generated with default options, is linked with the self-check
// whose sources are in that folder, and compared with the independent reference.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "limbed_document.h"

namespace {

namespace fs = std::filesystem;

// Robots in one unit: with more, the compiler takes more memory and no less time.
constexpr std::uint64_t kTogether = 25;

// Options of the generator, one set after the other for successive robots.
constexpr const char* kDefault = "";
constexpr const char* kOtherFunctions =
    "--algorithms inverse_dynamics,forward_dynamics,joint_space_inertia,coriolis_matrix,centroidal,velocities,"
    "accelerations,jacobian_derivatives";
const std::array<const char*, 16> kWays = {
    kDefault,        "--batch",
    kOtherFunctions, "--effort 0",
    kDefault,        "--passes canonical,lanes --effort 0",
    kDefault,        "--passes frames,turn-inertia,reassociate,lanes",
    kOtherFunctions, "--passes lanes --effort 0",
    kDefault,        "--passes base-parameters,choose-fd,canonical,sink,lanes --effort 0",
    kDefault,        "--effort 2",
    kDefault,        "--passes frames,canonical,reassociate,sink,lanes"};

std::string in_quotes(const std::string& text) {
  return "'" + text + "'";
}

std::string name_of(std::uint64_t seed) {
  return "limbs" + std::to_string(seed);
}

// Includes every unit of the robot, with kernels for double and float.
std::string includes(const fs::path& dir, const std::string& name) {
  std::vector<std::string> units;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(dir / name)) {
    const std::string unit = fs::relative(entry.path(), dir / name).generic_string();
    // Other levels of functions over many states are the same text, compiled with other options.
    if (unit.ends_with(".cpp") && (unit.find('/') == std::string::npos || unit.ends_with("_baseline.cpp")))
      units.push_back(unit);
  }
  std::sort(units.begin(), units.end());
  std::string text;
  for (const std::string& unit : units) text += "#include \"" + name + "/" + unit + "\"\n";
  return text;
}

bool generate(const std::string& tool, const fs::path& dir, std::uint64_t seed, const std::string& options) {
  const std::string name = name_of(seed), document = (dir / (name + ".kindsl")).string();
  fs::remove_all(dir / name);
  std::ofstream(document) << robcogen::test::limbed_document(seed);
  const std::string log = (dir / (name + ".log")).string();
  const std::string command = in_quotes(tool) + " generate " + in_quotes(document) + " -o " + in_quotes(dir.string()) +
                              " --name " + name + " " + options + " > " + in_quotes(log) + " 2>&1";
  if (std::system(command.c_str()) == 0) return true;
  std::cout << "not generated: " << command << '\n' << std::ifstream(log).rdbuf() << '\n';
  return false;
}

bool compiles(const std::string& compiler, const fs::path& dir, const std::vector<std::uint64_t>& seeds) {
  const std::string unit = (dir / (name_of(seeds.front()) + "_all.cpp")).string();
  std::ofstream text(unit);
  for (const std::uint64_t seed : seeds) text << includes(dir, name_of(seed));
  text.close();
  return std::system((compiler + " " + in_quotes(unit)).c_str()) == 0;
}

// True if the self-check of the robot, one program, reports no fault.
bool passes(const std::string& compiler, const fs::path& dir, const std::string& selfcheck, std::uint64_t seed) {
  const std::string name = name_of(seed), unit = (dir / (name + "_check.cpp")).string();
  std::ofstream text(unit);
  text << "#define ROBCOGEN_ROBOT_HEADER <" << name << "/" << name << ".h>\n#define ROBCOGEN_REFLECTION_HEADER <"
       << name << "/reflection.h>\n#define ROBCOGEN_ROBOT_NAMESPACE " << name << "\n";
  text << includes(dir, name);
  for (const char* source : {"selfcheck.cpp", "robot_selfcheck.cpp"})
    text << "#include \"" << selfcheck << "/" << source << "\"\n";
  text.close();
  const std::string program = (dir / (name + "_check")).string();
  const bool links = std::system((compiler + " " + in_quotes(unit) + " -o " + in_quotes(program)).c_str()) == 0;
  return links && std::system((in_quotes(program) + " --samples 10").c_str()) == 0;
}

bool run_all(
    const std::string& selfcheck,
    const std::string& tool,
    const fs::path& dir,
    std::uint64_t first,
    std::uint64_t count,
    const std::string& compiler) {
  bool all_good = true;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    if (generate(tool, dir, seed, "") && passes(compiler, dir, selfcheck, seed)) continue;
    std::cout << "self-check fails: seed " << seed << std::endl;
    all_good = false;
  }
  return all_good;
}

bool compile_all(
    const std::string& tool,
    const fs::path& dir,
    std::uint64_t first,
    std::uint64_t count,
    const std::string& compiler) {
  bool all_good = true;
  std::vector<std::uint64_t> together;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    if (generate(tool, dir, seed, kWays[seed % kWays.size()])) {
      together.push_back(seed);
    } else {
      all_good = false;
    }
    if (together.empty() || (together.size() < kTogether && seed + 1 < first + count)) continue;
    if (!compiles(compiler, dir, together)) {
      all_good = false;
      for (const std::uint64_t one : together)
        if (!compiles(compiler, dir, {one}))
          std::cout << "does not compile: seed " << one << ", " << kWays[one % kWays.size()] << std::endl;
    }
    together.clear();
  }
  return all_good;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::string selfcheck;
  if (arguments.size() > 1 && arguments[0] == "--run") {
    selfcheck = arguments[1];
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.size() < 5) {
    std::cerr << "usage: compile_limbed_robots [--run SOURCES] TOOL DIR FIRST COUNT COMPILER...\n";
    return 2;
  }
  const std::string tool = arguments[0];
  const fs::path dir = arguments[1];
  const std::uint64_t first = std::stoull(arguments[2]), count = std::stoull(arguments[3]);
  fs::create_directories(dir);
  std::string compiler;
  for (std::size_t i = 4; i < arguments.size(); ++i) compiler += in_quotes(arguments[i]) + " ";
  compiler += "-I" + in_quotes(dir.string());
  const bool all_good = selfcheck.empty() ? compile_all(tool, dir, first, count, compiler)
                                          : run_all(selfcheck, tool, dir, first, count, compiler);
  return all_good ? 0 : 1;
}
