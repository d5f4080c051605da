#include "support/files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#endif

namespace robcogen::files_test {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("robcogen-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const fs::path& path, const std::string& text) { std::ofstream(folder_ / path, std::ios::binary) << text; }
  std::string get(const fs::path& path) const {
    std::ifstream file(folder_ / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder_), fs::recursive_directory_iterator()));
  }
  bool write(const std::vector<OutputFile>& files) { return write_files_if_changed(folder_, files, error_); }

  fs::path folder_;
  std::string error_;
};

TEST_F(Files, AreReadByteForByte) {
  const std::string text("a\r\n\0\xff", 5);
  put("in", text);
  EXPECT_EQ(read_file(folder_ / "in", error_), text);
  put("empty", "");
  EXPECT_EQ(read_file(folder_ / "empty", error_), "");
  const std::string large(3'000'000, 'x');
  put("large", large);
  EXPECT_EQ(read_file(folder_ / "large", error_), large);
  EXPECT_EQ(error_, "");
}

TEST_F(Files, ThatCannotBeReadAreErrors) {
  EXPECT_EQ(read_file(folder_ / "absent", error_), std::nullopt);
  EXPECT_EQ(error_, (folder_ / "absent").string() + ": error: cannot read the file: No such file or directory");
  EXPECT_EQ(read_file(folder_, error_), std::nullopt);
  EXPECT_EQ(error_, folder_.string() + ": error: a folder, not a file");
}

TEST_F(Files, AreWrittenWithTheirFolders) {
  ASSERT_TRUE(write({{"a.h", "text"}, {"kernel/deep/b.h", std::string("\r\n\0", 3)}})) << error_;
  EXPECT_EQ(get("a.h"), "text");
  EXPECT_EQ(get("kernel/deep/b.h"), std::string("\r\n\0", 3));
  EXPECT_EQ(entries(), 4u);  // two files and two folders: no temporary file is left
}

TEST_F(Files, AreLeftAloneWhenTheyWouldNotChange) {
  ASSERT_TRUE(write({{"same", "text"}, {"other", "text"}}));
  const fs::file_time_type past = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder_ / "same", past);
  fs::last_write_time(folder_ / "other", past);
  ASSERT_TRUE(write({{"same", "text"}, {"other", "TEXT"}}));
  EXPECT_EQ(fs::last_write_time(folder_ / "same"), past);
  EXPECT_NE(fs::last_write_time(folder_ / "other"), past);
  EXPECT_EQ(get("other"), "TEXT");
}

TEST_F(Files, AreAllUntouchedWhenOneCannotBeWritten) {
  put("a", "old");
  put("plain", "a file, so that no folder can be made of it");
  fs::create_directory(folder_ / "folder");
  const std::size_t before = entries();
  EXPECT_FALSE(write({{"a", "new"}, {"plain/b", "text"}}));
  EXPECT_NE(error_.find("cannot create the folder '" + (folder_ / "plain").string()), std::string::npos) << error_;
  EXPECT_FALSE(write({{"a", "new"}, {"folder", "text"}}));
  EXPECT_EQ(error_, "cannot replace the folder '" + (folder_ / "folder").string() + "': Is a directory");
  EXPECT_EQ(get("a"), "old");
  EXPECT_EQ(entries(), before);
}

#ifdef RLIMIT_FSIZE
// A limit on the file size simulates a full disk: writing fails in the middle.
TEST_F(Files, AreAllUntouchedWhenTheDiskIsFull) {
  put("a", "old");
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
  rlimit small = usual;
  small.rlim_cur = 1000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const bool written = write({{"a", "new"}, {"b", std::string(100'000, 'x')}});
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(written);
  EXPECT_EQ(error_, "cannot write '" + (folder_ / "b").string() + "': File too large");
  EXPECT_EQ(get("a"), "old");
  EXPECT_EQ(entries(), 1u);
}
#endif

TEST_F(Files, ThatAreOneFileOverlap) {
  put("in", "text");
  put("other", "text");
  fs::create_symlink("in", folder_ / "soft");
  fs::create_hard_link(folder_ / "in", folder_ / "hard");
  fs::create_directory(folder_ / "folder");
  const fs::path in = folder_ / "in", other = folder_ / "other";
  for (const char* path : {"in", "soft", "hard", "folder/../in", "new/../in"}) {
    const auto found = overlap({other, folder_ / path}, {folder_ / "absent", in});
    ASSERT_TRUE(found) << path;
    EXPECT_EQ(found->output, folder_ / path);
    EXPECT_EQ(found->input, in);
  }
  EXPECT_FALSE(overlap({other, folder_ / "new", folder_, "/dev/null"}, {in, folder_, "/dev/null", ""}));
  // The temporary file beside an output, and beside the target of a link.
  put("new.robcogen-new", "text");
  fs::create_symlink("new", folder_ / "link");
  EXPECT_TRUE(overlap({folder_ / "new"}, {folder_ / "new.robcogen-new"}));
  put("new", "text");
  EXPECT_TRUE(overlap({folder_ / "link"}, {folder_ / "new.robcogen-new"}));
}

TEST_F(Files, BehindLinksAreReplaced) {
  put("store", "old");
  fs::create_symlink("store", folder_ / "link");
  ASSERT_TRUE(write({{"link", "new"}})) << error_;
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(get("store"), "new");
}

TEST(DependencyFile, IsARuleOfMake) {
  EXPECT_EQ(dependency_file("out/stamp", {"a.kindsl", "b.dtdsl"}), "out/stamp: \\\n  a.kindsl \\\n  b.dtdsl\n");
  EXPECT_EQ(dependency_file("my out", {"a b#c$d"}), "my\\ out: \\\n  a\\ b\\#c$$d\n");
  EXPECT_EQ(dependency_file("stamp", {}), "stamp:\n");
}

// Values from the definition of the function: http://www.isthe.com/chongo/tech/comp/fnv (FNV-1a, 64 bits).
TEST(Hash, IsFnv1a) {
  EXPECT_EQ(hash_text(""), "cbf29ce484222325");
  EXPECT_EQ(hash_text("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(hash_text("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace robcogen::files_test
