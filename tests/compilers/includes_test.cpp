// Each file of the generator includes the headers of what it uses, or includes a file of the generator that does. A
// build that compiles headers once for all files does not show what is missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "patterns.h"

namespace robcogen {
namespace {

namespace fs = std::filesystem;

// Every name from outside the project that the generator uses, and its headers: any of them declares it. A nested
// namespace of std stands for all names in it.
const std::vector<std::pair<std::string, std::string>> kDeclarations = {
    {"algorithm",
     "std::adjacent_find std::all_of std::any_of std::binary_search std::clamp std::copy std::copy_if std::count "
     "std::count_if std::equal std::fill std::find std::find_first_of std::find_if std::find_if_not std::for_each "
     "std::is_sorted "
     "std::lower_bound "
     "std::max std::max_element std::min std::min_element std::minmax std::mismatch std::none_of std::nth_element "
     "std::remove_if std::replace std::reverse std::rotate std::search std::set_intersection "
     "std::set_symmetric_difference std::sort "
     "std::stable_partition std::stable_sort std::transform std::unique std::upper_bound"},
    {"array", "std::array std::to_array"},
    {"atomic", "std::atomic"},
    {"bit", "std::bit_cast std::bit_ceil std::bit_width std::countr_zero std::has_single_bit"},
    {"cassert", "assert"},
    {"cctype",
     "std::isalnum std::isalpha std::islower std::isprint std::isspace std::isupper std::tolower std::toupper"},
    {"cerrno", "errno"},
    {"charconv", "std::chars_format std::from_chars std::to_chars"},
    {"cmath",
     "std::abs std::acos std::asin std::atan2 std::ceil std::copysign std::cos std::floor std::fmax std::fmin "
     "std::fmod "
     "std::hypot std::isfinite std::isinf std::isnan std::ldexp std::llround std::log10 std::lround std::pow "
     "std::remainder "
     "std::round std::sin std::sqrt std::tan"},
    {"csignal", "std::signal"},
    {"cstddef", "std::ptrdiff_t"},
    {"cstring", "std::memcpy"},
    {"cstdint", "std::int64_t std::uint16_t std::uint32_t std::uint64_t std::uint8_t"},
    {"cstdio",
     "EOF stderr stdin stdout std::FILE std::fclose std::ferror std::fflush std::fopen std::fread std::fwrite "
     "std::getc"},
    {"cstdlib", "std::getenv"},
    {"deque", "std::deque"},
    {"exception", "std::current_exception std::exception_ptr std::rethrow_exception"},
    {"exception stdexcept", "std::exception"},
    {"filesystem", "std::filesystem"},
    {"fmt/format.h fmt/ranges.h", "fmt::format fmt::format_string fmt::join fmt::print"},
    {"fstream", "std::ifstream std::ofstream"},
    {"fstream sstream", "std::ios std::streamsize std::ws"},
    {"functional", "std::function std::greater std::less std::not_fn"},
    {"functional string string_view", "std::hash"},
    {"iterator", "std::back_inserter std::input_iterator_tag std::make_move_iterator std::next std::prev"},
    {"limits", "std::numeric_limits"},
    {"map", "std::map std::multimap"},
    {"memory", "std::make_shared std::make_unique std::shared_ptr std::unique_ptr"},
    {"mutex", "std::mutex std::scoped_lock"},
    {"new", "std::bad_alloc"},
    {"nlohmann/json.hpp", "nlohmann::json nlohmann::json_sax nlohmann::ordered_json"},
    {"numbers", "std::numbers"},
    {"numeric", "std::gcd std::inner_product std::iota std::partial_sum"},
    {"optional", "std::nullopt std::nullopt_t std::optional"},
    {"queue", "std::priority_queue"},
    {"random", "std::minstd_rand std::mt19937_64 std::uniform_real_distribution"},
    {"set", "std::set"},
    {"span", "std::span"},
    {"sstream", "std::istringstream std::ostringstream"},
    {"stdexcept", "std::logic_error"},
    {"string", "std::getline std::string std::to_string"},
    {"string_view", "std::string_view"},
    {"system_error", "std::error_code std::generic_category std::system_error"},
    {"system_error charconv", "std::errc"},
    {"thread", "std::thread"},
    {"tuple", "std::tie std::tuple"},
    {"type_traits", "std::is_same_v std::is_trivially_destructible_v std::remove_cvref_t"},
    {"unordered_map", "std::unordered_map"},
    {"unordered_set", "std::unordered_set"},
    {"utility", "std::as_const std::exchange std::forward std::move std::pair std::swap"},
    {"variant", "std::get_if std::holds_alternative std::monostate std::variant std::visit"},
    {"vector", "std::vector"},
    // Names that each container header provides, too.
    {"cstddef array map memory optional set span string string_view unordered_map unordered_set vector", "std::size_t"},
    {"iterator array map set span string string_view unordered_map unordered_set vector",
     "std::begin std::end std::ssize"},
    {"map set string unordered_map unordered_set vector", "std::erase std::erase_if"},
    {"initializer_list map set string unordered_map unordered_set vector", "std::initializer_list"},
    {"array tuple utility variant", "std::get"},
};

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

// Returns the headers of each name.
std::map<std::string, std::vector<std::string>> declarations() {
  std::map<std::string, std::vector<std::string>> result;
  for (const auto& [headers, names] : kDeclarations)
    for (const std::string& name : words(names)) result.emplace(name, words(headers));
  return result;
}

// Returns the text without string literals and comments.
std::string without_literals(const std::string& text) {
  const std::string literal =
      "R\"(\\w*)\\([^]*?\\)\\1\"|\"(?:\\\\.|[^\"\\\\\n])*\"|'(?:\\\\.|[^'\\\\\n])+'|//[^\n]*|/\\*[^]*?\\*/";
  return test::replaced(text, literal, "\"\"");
}

using Names = std::set<std::string>;

struct File {
  std::string text;              // without includes, literals and comments
  std::vector<std::string> own;  // files of the generator that it includes
  Names packaged;                // other headers
  Names declared;                // functions, variables and pointers to functions
};

// The names that a text declares, in any scope: functions, variables and pointers to functions.
Names declared_in(const std::string& text) {
  static const Names words_before_calls = {"return", "else", "throw", "case"};
  Names result;
  for (const test::Match& found : test::all_matches(text, R"(([\w>]+)[&*]*\s[&*]?(\w+)( = |[(,;)]))"))
    if (words_before_calls.count(found[1]) == 0) result.insert(found[2]);
  for (const test::Match& found : test::all_matches(text, R"(\(\*(\w+)\)\()")) result.insert(found[1]);
  return result;
}

// The functions that a header declares for all who include it: those that stand at the beginning of a line.
Names offered_by(const std::string& header) {
  Names result;
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);)
    if (const auto found = test::first_match(line, R"(^\w[^(=]*[\w>][&*]*\s[&*]?(\w+)\()")) result.insert((*found)[1]);
  return result;
}

// The functions that a text calls without a scope or an object before them.
Names called_in(const std::string& text) {
  Names result;
  for (const test::Match& found : test::all_matches(text, R"((^|[^\w.>:])([a-z]\w*)\()")) result.insert(found[2]);
  return result;
}

File read(const fs::path& path) {
  File file;
  std::ifstream stream(path);
  std::string text;
  for (std::string line; std::getline(stream, line);) {
    const auto include = test::whole_match(line, R"re(\s*#include ([<"])([^>"]+)[>"].*)re");
    if (!include)
      text += line + "\n";
    else if ((*include)[1] == "<")
      file.packaged.insert((*include)[2]);
    else
      file.own.push_back((*include)[2]);
  }
  file.text = without_literals(text);
  file.declared = declared_in(file.text);
  return file;
}

using Files = std::map<std::string, File>;

Files files_of_the_tool() {
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(TOOL_DIR)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp")
      files.emplace(fs::relative(entry.path(), TOOL_DIR).generic_string(), read(entry.path()));
  }
  return files;
}

// Adds the name of a file of the generator, and of those that it includes, directly or through others.
void add_included(const Files& files, const std::string& name, Names& result) {
  const auto found = files.find(name);
  if (found == files.end() || !result.insert(name).second) return;
  for (const std::string& own : found->second.own) add_included(files, own, result);
}

Names included_by(const Files& files, const std::string& name) {
  Names result;
  add_included(files, name, result);
  return result;
}

// Returns the names in the file whose headers are not included, and those that are not in the table, in alphabetical
// order.
std::set<std::string> missing(const std::string& text, const std::set<std::string>& included) {
  static const auto table = declarations();
  const std::string used = R"((^|[^:\w])((std|fmt|nlohmann)::\w+|assert|errno|EOF|stdin|stdout|stderr)\b)";
  std::set<std::string> result;
  for (const test::Match& use : test::all_matches(text, used)) {
    const std::string& name = use[2];
    const auto found = table.find(name);
    if (found == table.end() || std::none_of(
                                    found->second.begin(), found->second.end(),
                                    [&](const std::string& header) { return included.count(header) > 0; }))
      result.insert(name);
  }
  return result;
}

// Returns the functions of this list that a file calls, although neither it nor what it includes declares them.
Names undeclared(const Files& files, const std::string& name, const Names& offered) {
  Names result;
  const Names included = included_by(files, name);
  for (const std::string& called : called_in(files.at(name).text))
    if (offered.count(called) > 0 && std::none_of(included.begin(), included.end(), [&](const std::string& other) {
          return files.at(other).declared.count(called) > 0;
        }))
      result.insert(called);
  return result;
}

TEST(Includes, AreThoseOfWhatAFileUses) {
  const Files files = files_of_the_tool();
  ASSERT_GT(files.size(), 400u);
  for (const auto& [name, file] : files) {
    Names packaged;
    for (const std::string& included : included_by(files, name))
      packaged.insert(files.at(included).packaged.begin(), files.at(included).packaged.end());
    EXPECT_EQ(missing(file.text, packaged), Names()) << name;
  }
}

// Names with an underscore, because the others are often those of members and variables, too.
TEST(Includes, DeclareTheFunctionsThatAFileCalls) {
  const Files files = files_of_the_tool();
  Names offered;
  for (const auto& [name, file] : files)
    if (fs::path(name).extension() == ".h")
      for (const std::string& function : offered_by(file.text))
        if (function.find('_') != std::string::npos) offered.insert(function);
  ASSERT_GT(offered.size(), 400u);
  for (const auto& [name, file] : files) EXPECT_EQ(undeclared(files, name, offered), Names()) << name;
}

TEST(Includes, DeclareCalledFunctionsDirectlyOrThroughOthers) {
  const auto file = [](const std::string& text, const std::vector<std::string>& own) {
    return File{text, own, {}, declared_in(text)};
  };
  const Files files = {
      {"a.h", file("int* one_more(int n);\n", {})},
      {"b.h", file("", {"a.h"})},
      {"with.cpp", file("int n = one_more(2);", {"b.h"})},
      {"without.cpp", file("int f() { return one_more(2); }", {})},
      {"own.cpp", file("const auto one_more = [] {};  one_more();", {})},
      {"member.cpp", file("x.one_more(); y->one_more(); z::one_more();", {})}};
  EXPECT_EQ(offered_by(files.at("a.h").text), Names{"one_more"});
  EXPECT_EQ(undeclared(files, "with.cpp", {"one_more"}), Names());
  EXPECT_EQ(undeclared(files, "without.cpp", {"one_more"}), Names{"one_more"});
  EXPECT_EQ(undeclared(files, "own.cpp", {"one_more"}), Names());
  EXPECT_EQ(undeclared(files, "member.cpp", {"one_more"}), Names());
}

TEST(Includes, AreMissedWhereThereAreNone) {
  EXPECT_EQ(missing("std::vector<std::string> v;", {"string"}), Names{"std::vector"});
  EXPECT_EQ(missing("std::vector<std::string> v;", {"string", "vector"}), Names());
  EXPECT_EQ(missing("std::size_t size;", {"map"}), Names());
}

// A name that is used for the first time must be added to the table.
TEST(Includes, OfUnknownNamesAreMissed) {
  EXPECT_EQ(missing("std::lerp(a, b, 0.5);", {"cmath"}), Names{"std::lerp"});
}

TEST(Includes, OfLiteralsAndCommentsAreNotAskedFor) {
  const std::string text = R"x("std::map \" std::set" // std::span
    R"(std::array "
    )" std::deque)x";
  EXPECT_EQ(missing(without_literals(text), {}), Names{"std::deque"});
}

}  // namespace
}  // namespace robcogen
