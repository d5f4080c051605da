// Documents of other projects: each is either read unchanged and survives printing, or is refused for its known reason
// at the known place.
#include <algorithm>
#include <map>
#include <set>

#include "patterns.h"
#include "reading.h"

namespace robcogen::corpus_test {
namespace {

using std::filesystem::path;

std::vector<path> documents(const std::string& extension) {
  std::vector<path> result;
  if (!std::filesystem::is_directory(ROBCOGEN_CORPUS_DIR)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(ROBCOGEN_CORPUS_DIR))
    if (entry.path().extension() == extension) result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

struct Fault {
  std::string code;
  std::size_t line;
  std::size_t column;
};

const std::map<std::string, Fault> kRefused = {
    {"ESROCOS_kin-gen__tests_models_malformed_cmm-typo.kindsl", {"unknown-item", 20, 2}},
    {"mfrigerio17_dsl-kinematics__models_two_links.kindsl", {"old-dialect", 7, 3}},
    {"ESROCOS_kin-gen__tests_coverage_sample_fk1_model_ur5.dtdsl", {"query-dialect", 7, 1}},
    {"idra-lab_quadruped_robcogen__config_robot.dtdsl", {"template", 1, 7}},
};

class CorpusText : public testing::Test {
 protected:
  void SetUp() override {
    if (documents(".kindsl").empty()) GTEST_SKIP() << "no documents in " << ROBCOGEN_CORPUS_DIR;
  }
};

// Returns true if the document is refused; expects the known reason to be the only one.
bool is_refused(const path& document, const Diagnostics& diagnostics) {
  const auto refused = kRefused.find(document.filename().string());
  if (refused == kRefused.end()) {
    EXPECT_TRUE(diagnostics.all().empty()) << document << "\n" << diagnostics.render();
    return diagnostics.has_errors();
  }
  EXPECT_EQ(diagnostics.all().size(), 1u) << document << "\n" << diagnostics.render();
  if (diagnostics.all().empty()) return true;
  const Diagnostic& d = diagnostics.all().front();
  const LineColumn at = d.place.source->locate(d.place.span.begin);
  EXPECT_EQ(d.code, refused->second.code) << document;
  EXPECT_EQ(at.line, refused->second.line) << document;
  EXPECT_EQ(at.column, refused->second.column) << document;
  return true;
}

// Expects that the printed document reads back as the same document and prints the same.
template <class Document>
void expect_survives_printing(
    const Document& document,
    Document (*parse)(std::shared_ptr<const Source>, Diagnostics&)) {
  const std::string text = print(document);
  Diagnostics diagnostics;
  const Document again = parse(test::source(text), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
  EXPECT_TRUE(equal(document, again)) << text;
  EXPECT_EQ(print(again), text);
}

TEST_F(CorpusText, OfRobotsIsReadAndSurvivesPrinting) {
  std::size_t refused = 0;
  for (const path& file : documents(".kindsl")) {
    SCOPED_TRACE(file.filename().string());
    Diagnostics diagnostics;
    const auto document = language::kinematics::parse(test::source_of_file(file), diagnostics);
    if (is_refused(file, diagnostics)) {
      ++refused;
    } else {
      expect_survives_printing(document, &language::kinematics::parse);
    }
  }
  EXPECT_EQ(refused, 2u);
}

TEST_F(CorpusText, OfMotionsIsReadAndSurvivesPrinting) {
  EXPECT_GE(documents(".motdsl").size(), 2u);
  for (const path& file : documents(".motdsl")) {
    SCOPED_TRACE(file.filename().string());
    Diagnostics diagnostics;
    const auto document = language::motion::parse(test::source_of_file(file), diagnostics);
    EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
    EXPECT_GE(document.motions.size(), 7u);
    expect_survives_printing(document, &language::motion::parse);
  }
}

TEST_F(CorpusText, OfTransformsIsReadAndSurvivesPrinting) {
  EXPECT_GE(documents(".ctdsl").size(), 2u);
  for (const path& file : documents(".ctdsl")) {
    SCOPED_TRACE(file.filename().string());
    Diagnostics diagnostics;
    const auto document = language::transforms::parse(test::source_of_file(file), diagnostics);
    EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
    EXPECT_GE(document.transforms.size(), 4u);
    expect_survives_printing(document, &language::transforms::parse);
  }
}

TEST_F(CorpusText, OfDesiredTransformsIsReadAndSurvivesPrinting) {
  std::size_t refused = 0;
  for (const path& file : documents(".dtdsl")) {
    SCOPED_TRACE(file.filename().string());
    Diagnostics diagnostics;
    const auto document = language::desired::parse(test::source_of_file(file), diagnostics);
    if (is_refused(file, diagnostics)) {
      ++refused;
    } else {
      expect_survives_printing(document, &language::desired::parse);
    }
  }
  EXPECT_EQ(refused, 2u);
}

// The text without its comments, which a pattern finds without the lexer.
std::string without_comments(const path& file) {
  return test::replaced(test::contents(file), R"re(/\*([^*]|\*[^/])*\*/|//[^\n]*)re", " ");
}

std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  std::vector<std::string> result;
  for (const test::Match& match : test::all_matches(text, pattern)) result.push_back(match[1]);
  return result;
}

TEST_F(CorpusText, HasTheElementsThatPatternsFind) {
  for (const path& file : documents(".kindsl")) {
    if (kRefused.contains(file.filename().string())) continue;
    SCOPED_TRACE(file.filename().string());
    const auto document = test::read_robot(test::contents(file));
    const std::string text = without_comments(file);
    std::vector<std::string> links, joints, pairs, numbers;
    std::size_t frames = 0;
    for (const auto& link : document.links) {
      if (!link.is_base) links.push_back(link.name.text);
      frames += link.frames.size();
      for (const auto& child : link.children) pairs.push_back(child.link.text + "/" + child.joint.text);
      if (link.inertia && link.inertia->ixy->kind == language::Expression::Kind::number)
        numbers.push_back(print_double(link.inertia->ixy->number.value()));
    }
    for (const auto& joint : document.joints) joints.push_back(joint.name.text);
    EXPECT_EQ(links, found(text, R"re(\blink\s+(\w+)\s*\{)re"));
    EXPECT_EQ(joints, found(text, R"re(\b[rp]_joint\s+(\w+)\s*\{)re"));
    EXPECT_EQ(frames, found(text, R"re((\w+)\s*\{\s*translation)re").size() - joints.size());
    EXPECT_EQ(pairs.size(), found(text, R"re((\bvia\b))re").size());
    std::vector<std::string> expected;
    for (const std::string& number : found(text, R"re(\bIxy\s*=\s*([-+.0-9eE]+))re"))
      expected.push_back(print_double(std::strtod(number.c_str(), nullptr)));
    EXPECT_EQ(numbers, expected);
  }
}

TEST_F(CorpusText, HasThePairsThatPatternsFind) {
  for (const path& file : documents(".dtdsl")) {
    if (kRefused.contains(file.filename().string())) continue;
    SCOPED_TRACE(file.filename().string());
    const auto document = test::read_desired(test::contents(file));
    const std::string text = without_comments(file);
    std::vector<std::string> left, expected = found(text, R"re(\bbase\s*=\s*(\w+))re");
    for (const auto* pairs : {&document.transforms, &document.jacobians})
      for (const auto& pair : *pairs) left.push_back(pair.left.text);
    for (const std::string& name : found(text, R"re((\w+)\s*<-)re")) expected.push_back(name);
    std::sort(left.begin(), left.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(left, expected);
  }
}

}  // namespace
}  // namespace robcogen::corpus_test
