// A document with parts and its expanded plain document give the same programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "driver/documents.h"
#include "driver/driver.h"
#include "symbolic/text.h"

namespace robcogen::driver::expanded_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> robots() {
  std::vector<fs::path> result;
  for (const auto& entry : fs::recursive_directory_iterator(ROBCOGEN_ROBOTS_DIR))
    if (entry.path().extension() == ".kindsl") result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

// Reads `text` instead of the file, if it is given.
std::vector<std::string> programs_of(const fs::path& file, const std::shared_ptr<const Source>& text) {
  LoadOptions options;
  options.may_be_library = true;
  const fs::path list = fs::path(file).replace_extension(".dtdsl");
  if (fs::exists(list)) options.desired = list;
  if (text) options.open_texts = [&](const fs::path& path) { return path == file ? text : nullptr; };
  Diagnostics diagnostics;
  const std::optional<Model> model = load(file, options, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  std::vector<std::string> result;
  if (!model) return result;
  const std::vector<std::string> groups = {"inverse_dynamics", "joint_space_inertia", "transforms", "jacobians"};
  for (const Function& f : programs(*model, groups, {all_steps(), 0}).list)
    result.push_back(symbolic::print(f.program));
  return result;
}

TEST(ExpandedDocument, HasTheProgramsOfTheDocumentWithParts) {
  int with_parts = 0;
  for (const fs::path& file : robots()) {
    Diagnostics diagnostics;
    const auto document = load_robot_document(file, {}, diagnostics);
    ASSERT_TRUE(document) << diagnostics.render();
    if (!document->document.has_robot()) continue;
    const std::string plain = language::kinematics::print(document->document);
    const std::vector<std::string> expected = programs_of(file, nullptr);
    EXPECT_EQ(programs_of(file, std::make_shared<const Source>(file.string(), plain)), expected) << file;
    EXPECT_FALSE(expected.empty()) << file;
    EXPECT_TRUE(document->document.parts.empty() && document->document.imports.empty()) << file;
    Diagnostics ignored;
    const auto written = language::kinematics::parse(read_source(file), ignored);
    const auto carries = [](const auto& link) { return !link.instances.empty(); };
    with_parts += std::any_of(written.links.begin(), written.links.end(), carries) ? 1 : 0;
  }
  EXPECT_GE(with_parts, 5);
}

}  // namespace
}  // namespace robcogen::driver::expanded_test
