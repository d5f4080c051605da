// From a file to the text of a library, with the calls of a program that embeds the generator.
#include "driver/driver.h"

#include <cmath>
#include <set>

#include "backend/languages.h"
#include "documents.h"
#include "symbolic/interpret.h"

namespace robcogen::driver::driver_test {
namespace {

using namespace test;

const Steps kNoSearch{all_steps(), 0};

TEST(Driver, GeneratesALibraryInEachLanguage) {
  const Folder folder;
  const Model model = loaded(folder.file("rods.kindsl", kRods));
  LibraryOptions options;
  options.names = {"rods"};
  options.groups = {"inverse_dynamics", "transforms"};
  options.steps = kNoSearch;
  for (const backend::Language& language : backend::languages()) {
    SCOPED_TRACE(language.name);
    const auto print = [&] { return language.print(library(model, options, language.features)); };
    const std::vector<OutputFile> files = print(), again = print();
    ASSERT_FALSE(files.empty());
    std::set<fs::path> paths;
    bool has_robot = false;
    for (std::size_t k = 0; k < files.size(); ++k) {
      EXPECT_TRUE(files[k].path.is_relative()) << files[k].path;
      EXPECT_TRUE(paths.insert(files[k].path).second) << files[k].path;
      EXPECT_EQ(files[k].text.find(fs::temp_directory_path().string()), std::string::npos) << files[k].path;
      EXPECT_EQ(files[k].text, again.at(k).text) << files[k].path;
      has_robot = has_robot || files[k].text.find("elbow") != std::string::npos;
    }
    EXPECT_TRUE(has_robot);
  }
}

// The library contains the results of the programs: the second mass loads the elbow.
TEST(Driver, FunctionsOfALibraryAreRightInEveryForm) {
  const Model model = rods();
  const double q1 = 0.4, q2 = -1.1, expected = kGravity * kM2 * kL2 * std::cos(q1 + q2);
  LibraryOptions options;
  options.names = {"rods"};
  options.groups = {"inverse_dynamics"};
  for (const backend::Features& features :
       {backend::Features(), backend::Features{true, true, false}, backend::Features{true, true, true}}) {
    const backend::Library result = library(model, options, features);
    ASSERT_FALSE(result.functions.empty());
    EXPECT_EQ(result.trigonometry.has_value(), features.takes_sines);
    const backend::Function& f = result.functions.front();
    EXPECT_EQ(f.name, "inverse_dynamics");
    EXPECT_NEAR(symbolic::interpret<double>(f.program, {{"q", {q1, q2}}}).at("tau").at(1), expected, 1e-13);
  }
}

TEST(Driver, ProgramsAreTheSameFunctionsWithoutALibrary) {
  const Model model = rods();
  LibraryOptions options;
  options.names = {"rods"};
  options.groups = {"joint_space_inertia", "energy"};
  const backend::Library whole = library(model, options);
  const Functions functions = programs(model, options.groups, options.steps);
  ASSERT_EQ(functions.list.size(), whole.functions.size());
  for (std::size_t k = 0; k < whole.functions.size(); ++k) {
    EXPECT_EQ(functions.list[k].name, whole.functions[k].name);
    const symbolic::Arrays<double> state = {{"q", {0.3, 0.9}}, {"qd", {-1.0, 0.5}}};
    symbolic::Arrays<double> inputs;
    for (const symbolic::InputArray& array : whole.functions[k].program.inputs)
      if (state.contains(array.name)) inputs[array.name] = state.at(array.name);
    EXPECT_EQ(
        symbolic::interpret<double>(functions.list[k].program, inputs),
        symbolic::interpret<double>(whole.functions[k].program, inputs));
  }
}

// The function groups of robots have no effect on transforms.
TEST(Driver, TransformsTakeTheSamePath) {
  const Folder folder;
  for (const fs::path& file : {folder.file("arm.motdsl", kMotions), folder.file("arm.ctdsl", kTransforms)}) {
    LibraryOptions options;
    options.names = {"arm"};
    options.has_batches = true;
    for (const backend::Language& language : backend::languages()) {
      EXPECT_EQ(language.takes_transforms, language.name != "gpu") << language.name;
      if (!language.takes_transforms) continue;
      backend::Library result = library(loaded(file), options, language.features);
      EXPECT_EQ(result.groups, std::vector<std::string>{kTransformsGroup});
      EXPECT_EQ(result.functions.size(), 6U);
      EXPECT_TRUE(result.has_batches);
      result.has_batches = false;
      bool has_transform = false;
      for (const OutputFile& each : language.print(result))
        has_transform = has_transform || each.text.find("base_X_hand") != std::string::npos;
      EXPECT_TRUE(has_transform) << language.name;
    }
  }
}

}  // namespace
}  // namespace robcogen::driver::driver_test
