// Files of the generator include the headers of what they use, or include a file of the generator that does.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace robcogen {
namespace {

namespace fs = std::filesystem;

// Names, and the headers that declare them: any of them does.
const std::vector<std::pair<std::string, std::set<std::string>>> kDeclared = {
    {"std::(all_of|any_of|none_of|find|find_if|count_if|sort|stable_sort|transform|copy|copy_if|remove_if|min|max|max_"
     "element|"
     "min_element|reverse|fill|unique|lower_bound|upper_bound|equal|replace|adjacent_find|set_difference|clamp)",
     {"algorithm"}},
    {"std::array", {"array"}},
    {"std::(abs|sqrt|sin|cos|atan2|hypot|isfinite|isnan|ldexp|nextafter|lround|remainder|copysign)", {"cmath"}},
    {"std::(u?int(8|16|32|64)_t)", {"cstdint"}},
    {"std::filesystem", {"filesystem"}},
    {"std::[io]?fstream", {"fstream"}},
    {"std::function", {"functional"}},
    {"std::numeric_limits", {"limits"}},
    {"std::(multi)?map", {"map"}},
    {"std::(unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared)", {"memory"}},
    {"std::mutex", {"mutex"}},
    {"std::numbers", {"numbers"}},
    {"std::(iota|accumulate|partial_sum|inner_product|gcd)", {"numeric"}},
    {"std::(optional|nullopt)", {"optional"}},
    {"std::(multi)?set", {"set"}},
    {"std::span", {"span"}},
    {"std::[io]?stringstream", {"sstream"}},
    {"std::(logic_error|runtime_error|domain_error|out_of_range|invalid_argument)", {"stdexcept"}},
    {"std::(string|to_string|stoi|stod)", {"string"}},
    {"std::string_view", {"string_view"}},
    {"std::(tuple|tie|make_tuple)", {"tuple"}},
    {"std::unordered_map", {"unordered_map"}},
    {"std::unordered_set", {"unordered_set"}},
    {"std::(variant|visit|monostate|get_if|holds_alternative)", {"variant"}},
    {"std::vector", {"vector"}},
    {"fmt::(format|format_to)", {"fmt/format.h", "fmt/ranges.h", "fmt/chrono.h"}},
    {"fmt::join", {"fmt/ranges.h", "fmt/format.h"}},
    {"nlohmann::", {"nlohmann/json.hpp", "nlohmann/json_fwd.hpp"}},
};

struct File {
  std::string text;                // without comments
  std::vector<std::string> own;    // files of the generator that it includes
  std::set<std::string> packaged;  // other headers
};

File read(const fs::path& path) {
  File file;
  std::ifstream stream(path);
  const std::regex include(R"(\s*#include ([<"])([^>"]+)[>"].*)");
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (std::regex_match(line, match, include)) {
      if (match[1] == "<")
        file.packaged.insert(match[2]);
      else
        file.own.push_back(match[2]);
      continue;
    }
    file.text += line.substr(0, line.find("//")) + "\n";
  }
  return file;
}

using Files = std::map<std::string, File>;

Files files_of_the_tool() {
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(TOOL_DIR)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp" || extension == ".inc")
      files.emplace(fs::relative(entry.path(), TOOL_DIR).generic_string(), read(entry.path()));
  }
  return files;
}

// The packaged headers that a file includes, also by way of the generator's own.
void add_packaged(
    const Files& files,
    const std::string& name,
    std::set<std::string>& visited,
    std::set<std::string>& result) {
  const auto found = files.find(name);
  if (found == files.end() || !visited.insert(name).second) return;
  result.insert(found->second.packaged.begin(), found->second.packaged.end());
  for (const std::string& own : found->second.own) add_packaged(files, own, visited, result);
}

// The first name that the file uses although it includes none of the headers.
std::string missing(const File& file, const std::set<std::string>& included) {
  for (const auto& [names, headers] : kDeclared) {
    const bool is_included = std::any_of(
        headers.begin(), headers.end(), [&](const std::string& header) { return included.count(header) > 0; });
    std::smatch match;
    if (!is_included && std::regex_search(file.text, match, std::regex(names + "\\b"))) return match[0];
  }
  return "";
}

TEST(Includes, AreThoseOfWhatAFileUses) {
  const Files files = files_of_the_tool();
  ASSERT_GT(files.size(), 400u);
  for (const auto& [name, file] : files) {
    std::set<std::string> visited, included;
    add_packaged(files, name, visited, included);
    EXPECT_EQ(missing(file, included), "") << name;
  }
}

TEST(Includes, AreMissedWhereThereAreNone) {
  EXPECT_EQ(missing({"std::vector<int> v;", {}, {}}, {"string"}), "std::vector");
  EXPECT_EQ(missing({"std::vector<int> v;", {}, {}}, {"vector"}), "");
}

}  // namespace
}  // namespace robcogen
