// The pictures of the list of robots are those that the generator draws. robots/gallery/gallery.txt has a line for
// each: the document without extension, and options of `robcogen draw`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "markdown.h"

namespace robcogen::test::gallery_test {
namespace {

namespace fs = std::filesystem;

TEST(Gallery, IsWhatTheGeneratorDraws) {
  const fs::path folder_of_robots = source_folder() / "robots";
  const std::string page = read_text(folder_of_robots / "README.md");
  std::istringstream lines(read_text(folder_of_robots / "gallery/gallery.txt"));
  std::set<std::string> listed;
  std::string document, options;
  while (lines >> document && std::getline(lines, options)) {
    listed.insert(document);
    const std::string file = "gallery/" + fs::path(document).filename().string() + ".svg";
    const fs::path drawing = scratch("gallery").string() + ".svg";
    int status = 0;
    const std::string output = output_of(
        "'" ROBCOGEN_TOOL "' draw --plain '" + (folder_of_robots / document).string() + ".kindsl' -o '" +
            drawing.string() + "'" + options,
        status);
    ASSERT_EQ(status, 0) << output;
    const std::string drawn = read_text(drawing);
    fs::remove(drawing);
    if (std::getenv("ROBCOGEN_UPDATE_DOCUMENTS")) std::ofstream(folder_of_robots / file, std::ios::binary) << drawn;
    EXPECT_EQ(read_text(folder_of_robots / file), drawn) << file << ": build the target update_documents";
    EXPECT_NE(page.find("](" + file + ")"), std::string::npos) << "robots/README.md does not show " << file;
    EXPECT_NE(page.find("](" + document + ".kindsl)"), std::string::npos) << "robots/README.md: " << document;
  }
  for (const auto& folder : fs::directory_iterator(folder_of_robots)) {
    if (!folder.is_directory()) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".kindsl") continue;
      EXPECT_TRUE(listed.count((folder.path().filename() / entry.path().stem()).string()))
          << entry.path() << " is not in robots/gallery/gallery.txt";
    }
  }
}

}  // namespace
}  // namespace robcogen::test::gallery_test
