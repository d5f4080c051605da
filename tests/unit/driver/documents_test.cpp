// The language of a document, and the text of files.
#include "driver/documents.h"

#include "documents.h"
#include "driver/failure.h"

namespace robcogen::driver::documents_test {
namespace {

using test::Folder;
namespace fs = std::filesystem;

TEST(Documents, HaveTheLanguageOfTheirSuffix) {
  EXPECT_EQ(language_of_suffix("a/arm.kindsl"), Language::robot);
  EXPECT_EQ(language_of_suffix("arm.urdf"), Language::urdf);
  EXPECT_EQ(language_of_suffix("arm.sdf"), Language::sdf);
  EXPECT_EQ(language_of_suffix("arm.motdsl"), Language::motions);
  EXPECT_EQ(language_of_suffix("arm.ctdsl"), Language::transforms);
  EXPECT_EQ(language_of_suffix("arm.dtdsl"), Language::desired);
  for (const char* other : {"arm.xml", "arm", "kindsl", "arm.kindsl.bak"})
    EXPECT_FALSE(language_of_suffix(other)) << other;
}

TEST(Documents, OfOtherSuffixesAreJudgedByTheirContent) {
  const Folder folder;
  EXPECT_EQ(language_of(folder.file("robot.xml", test::kRodsUrdf)), Language::urdf);
  EXPECT_EQ(language_of(folder.file("robot", test::kRods)), Language::robot);
  for (const char* name : {"model.xml", "model.urdf", "model.kindsl", "model"})
    EXPECT_EQ(language_of(folder.file(name, "<?xml version='1.0'?>\n<mujoco model='m'/>")), Language::mjcf) << name;
  for (const char* name : {"model.sdf", "arm.world", "model.kindsl", "model"})
    EXPECT_EQ(language_of(folder.file(name, "<?xml version='1.0'?>\n<sdf version='1.9'/>")), Language::sdf) << name;
  EXPECT_EQ(language_of(folder.file("robot.kindsl", test::kRodsUrdf)), Language::urdf);  // a wrong extension
  EXPECT_EQ(language_of(folder.file("frames.motdsl", test::kRodsUrdf)), Language::motions);
  EXPECT_EQ(language_of("no_such_file"), Language::robot);
}

TEST(Documents, RobotsComeInFourLanguages) {
  EXPECT_TRUE(
      is_robot(Language::robot) && is_robot(Language::urdf) && is_robot(Language::mjcf) && is_robot(Language::sdf));
  EXPECT_FALSE(is_robot(Language::motions) || is_robot(Language::transforms) || is_robot(Language::desired));
}

TEST(Documents, AreReadByteForByte) {
  const Folder folder;
  const fs::path file = folder.file("text", "a\r\nb\n");
  const auto source = read_source(file);
  EXPECT_EQ(source->text(), "a\r\nb\n");
  EXPECT_EQ(source->name(), file.string());
  // A file is read again after it has changed.
  folder.file("text", "c");
  EXPECT_EQ(read_source(file)->text(), "c");
}

// The failure that reading this file causes; `ok` without a message if there is none.
Failure failure_of(const fs::path& file) {
  try {
    read_source(file);
  } catch (const Failure& failure) {
    return failure;
  }
  return {ok, ""};
}

TEST(Documents, ThatAreNotThereFail) {
  const Failure failure = failure_of("/no/such/file.kindsl");
  EXPECT_EQ(failure.status, wrong_usage);
  EXPECT_NE(failure.message.find("/no/such/file.kindsl"), std::string::npos) << failure.message;
}

TEST(Documents, ThatAreNotTextFail) {
  const Folder folder;
  const fs::path file = folder.file("robot.kindsl", std::string("Robot\nR\0x", 9));
  const Failure failure = failure_of(file);
  EXPECT_EQ(failure.status, wrong_input);
  EXPECT_EQ(failure.message.find(file.string() + ":2:2: error: "), 0U) << failure.message;
  EXPECT_NE(failure.message.find("[not-text]"), std::string::npos);
}

}  // namespace
}  // namespace robcogen::driver::documents_test
