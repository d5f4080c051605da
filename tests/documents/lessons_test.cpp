// The lessons work as their pages say: the commands run in order, print what the pages show and draw their pictures;
// the code on the pages is in the files of the lessons.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "markdown.h"
#include "patterns.h"

namespace robcogen::test::lessons_test {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxLines = 150;

// Rounding differs between processors: by how much numbers may differ from those shown, in units of the last decimal,
// and without decimals.
constexpr double kLastDecimals = 1.01, kWithoutDecimals = 1e-9;

std::vector<fs::path> lessons() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(source_folder() / "robots/lessons"))
    if (entry.is_directory()) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

// A clone of the project: links, and a copy of robots/, where the commands write files.
fs::path clone() {
  static const fs::path folder = [] {
    const fs::path made = fs::path(ROBCOGEN_WORK_DIR) / "clone";
    fs::remove_all(made);
    fs::create_directories(made);
    for (const auto& entry : fs::directory_iterator(source_folder())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".") || name.starts_with("build") || name == "robots") continue;
      fs::create_symlink(entry.path(), made / name);
    }
    fs::copy(source_folder() / "robots", made / "robots", fs::copy_options::recursive);
    for (const fs::path& lesson : lessons()) fs::remove_all(made / "robots/lessons" / lesson.filename() / "build");
    return made;
  }();
  return folder;
}

// Less than the lessons say, so that compiling them takes less time.
constexpr const char* kQuickly = R"(cmake() {
  if [[ $1 == -B ]]; then set -- "$@" -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DROBCOGEN_UNITY_ROBOTS=ON; fi
  command cmake "$@"
}
)";

// Runs lines of bash in the clone, with the installed package on the path.
std::string run_in_clone(const std::string& lines, int& status) {
  const fs::path script = fs::path(ROBCOGEN_WORK_DIR) / "lines.sh";
  fs::create_directories(ROBCOGEN_WORK_DIR);
  std::ofstream(script) << "cd '" << clone().string() << "'\n"
                        << "export CXX='" ROBCOGEN_CXX "' PATH='" ROBCOGEN_PREFIX "/bin':$PATH\n"
                        << kQuickly << lines;
  return output_of("bash -e -o pipefail '" + script.string() + "'", status);
}

// Returns how the text differs from the one shown; empty if it does not. Blanks may differ, and numbers behind a ~.
std::string difference(const std::string& shown, const std::string& text) {
  const std::string pattern = R"(-?\d+(\.(\d+))?(e[-+]?\d+)?)";
  std::istringstream words(shown), others(text);
  std::string word, other;
  const auto skeleton = [&](const std::string& s) { return replaced(s, pattern, "#"); };
  while (words >> word) {
    if (!(others >> other)) return "ends before " + word;
    const std::string fault = other + " instead of " + word;
    if (skeleton(word) != skeleton(other)) return fault;
    if (word.starts_with("~")) continue;
    const std::vector<Match> expected = all_matches(word, pattern), found = all_matches(other, pattern);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const auto decimals = static_cast<double>(expected[k][2].length());
      const double tolerance = decimals == 0 ? kWithoutDecimals : kLastDecimals * std::pow(10.0, -decimals);
      if (std::abs(std::stod(expected[k][0]) - std::stod(found[k][0])) > std::max(tolerance, 1e-12)) return fault;
    }
  }
  return others >> other ? "continues with " + other : "";
}

// A block of a page: its text is from the line after the fence to the closing one.
struct Block {
  std::string language;
  std::size_t begin, end;
};

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  for (std::size_t at = page.find("\n```"); at != std::string::npos; at = page.find("\n```", at)) {
    const std::size_t begin = page.find('\n', at + 1) + 1, end = page.find("```\n", begin);
    blocks.push_back({page.substr(at + 4, begin - at - 5), begin, end});
    at = end + 3;  // a next block may follow without a line between
  }
  return blocks;
}

// Runs the commands of a page. A block `text` that directly follows commands is what they print.
void follow(const fs::path& lesson) {
  const std::string mark = "@@ end of block @@\n";
  std::string page = read_text(lesson / "README.md"), lines;
  const std::vector<Block> blocks = blocks_of(page);
  for (const Block& block : blocks)
    if (block.language == "sh")
      lines +=
          page.substr(block.begin, block.end - block.begin) + "echo; echo '" + mark.substr(0, mark.size() - 1) + "'\n";
  int status = 0;
  std::string output = run_in_clone(lines, status);
  ASSERT_EQ(status, 0) << lesson << ":\n" << output;

  std::vector<std::string> printed(blocks.size());
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k].language != "sh") continue;
    const std::size_t end = output.find(mark);
    ASSERT_NE(end, std::string::npos);
    printed[k] = output.substr(0, end - 1);  // without the line of the mark's echo
    output.erase(0, end + mark.size());
  }
  const bool updates = std::getenv("ROBCOGEN_UPDATE_DOCUMENTS") != nullptr;
  for (std::size_t k = blocks.size(); k-- > 1;) {
    if (blocks[k].language != "text" || blocks[k - 1].language != "sh") continue;
    const std::string shown = page.substr(blocks[k].begin, blocks[k].end - blocks[k].begin);
    const std::string fault = difference(shown, printed[k - 1]);
    if (updates && !fault.empty()) page.replace(blocks[k].begin, shown.size(), printed[k - 1]);
    if (updates) continue;
    EXPECT_EQ(fault, "") << lesson << " shows\n" << shown << "but the commands print\n" << printed[k - 1];
  }
  if (updates) std::ofstream(lesson / "README.md", std::ios::binary) << page;

  for (const auto& entry : fs::directory_iterator(lesson)) {
    if (entry.path().extension() != ".svg") continue;
    const std::string drawn = read_text(clone() / "robots/lessons" / lesson.filename() / entry.path().filename());
    if (updates) std::ofstream(entry.path(), std::ios::binary) << drawn;
    EXPECT_EQ(read_text(entry.path()), drawn) << entry.path();
  }
}

// Each lesson compiles a project. The first two are those that every newcomer follows.
TEST(Lessons, WorkAsWritten) {
  const std::vector<fs::path> all = lessons();
  ASSERT_EQ(all.size(), 5U);
  const std::size_t followed = ROBCOGEN_TEST_EVERYTHING ? all.size() : 2;
  for (std::size_t i = 0; i < followed; ++i) follow(all[i]);
}

// The lines of a text without indentation.
std::string flat(const std::string& text) {
  return replaced("\n" + text, "\n[ \t]+", "\n");
}

TEST(Lessons, QuoteTheirFiles) {
  for (const fs::path& lesson : lessons()) {
    const std::string page = read_text(lesson / "README.md");
    std::string files;
    for (const auto& entry : fs::directory_iterator(lesson))
      if (entry.is_regular_file() && entry.path().extension() != ".md") files += flat(read_text(entry.path()));
    for (const Block& block : blocks_of(page)) {
      if (block.language == "sh" || block.language == "text") continue;
      const std::string quoted = page.substr(block.begin, block.end - block.begin);
      EXPECT_NE(files.find(flat(quoted)), std::string::npos) << lesson << " has no file with\n" << quoted;
    }
  }
}

TEST(Lessons, AreShortAndLeadOn) {
  for (const fs::path& lesson : lessons()) {
    const std::string page = read_text(lesson / "README.md");
    EXPECT_LE(std::count(page.begin(), page.end(), '\n'), kMaxLines) << lesson;
    EXPECT_EQ(page.find("\n## ", page.find("\n## Read next\n") + 1), std::string::npos) << lesson;
  }
}

// The page of all lessons says how to prepare, and how to do without an installation.
TEST(Lessons, ArePreparedAsWritten) {
  const std::string page = read_text(source_folder() / "robots/lessons/README.md");
  const std::vector<Block> blocks = blocks_of(page);
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_TRUE(page.substr(blocks[0].begin).starts_with("cmake/bootstrap.sh install ~/robcogen "));
  const fs::path lists = clone() / "robots/lessons" / lessons()[0].filename() / "CMakeLists.txt";
  std::string text = read_text(lists);
  const std::string package = "find_package(robcogen REQUIRED)\n";
  ASSERT_NE(text.find(package), std::string::npos);
  text.replace(text.find(package), package.size(), page.substr(blocks[1].begin, blocks[1].end - blocks[1].begin));
  std::ofstream(lists) << text;
  int status = 0;
  const std::string output = run_in_clone(
      "cmake -S '" + lists.parent_path().string() +
          "' -B apart -G Ninja -DROBCOGEN_HOST_TOOL='" ROBCOGEN_TOOL "'\ncmake --build apart --target arm_codegen\n",
      status);
  EXPECT_EQ(status, 0) << output;
}

TEST(Lessons, DifferencesAreFound) {
  EXPECT_EQ(difference("H = 0.24  -0.5\n", "H =  0.241 -0.50\n"), "");
  EXPECT_EQ(difference("it takes ~0.3 us", "it takes ~2.11 us"), "");
  EXPECT_EQ(difference("H = 0.24", "H = 0.26"), "0.26 instead of 0.24");
  EXPECT_EQ(difference("arm.urdf:3:14", "arm.urdf:3:15"), "arm.urdf:3:15 instead of arm.urdf:3:14");
  EXPECT_EQ(difference("1.0 m", "1.0 kg"), "kg instead of m");
  EXPECT_EQ(difference("1.0 m", "1.0"), "ends before m");
  EXPECT_EQ(difference("1.0", "1.0 m"), "continues with m");
}

}  // namespace
}  // namespace robcogen::test::lessons_test
