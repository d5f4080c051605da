#include "backend/cpp/names.h"

#include <gtest/gtest.h>

namespace robcogen::backend::cpp::names_test {
namespace {

using Names = std::vector<std::string>;

TEST(Names, LegalNamesStayAsTheyAre) {
  for (const char* name : {"HFE", "lowerleg_wx", "q", "a1_b2", "Classy", "foo_"}) EXPECT_EQ(identifier(name), name);
}

TEST(Names, ReservedWordsGetAnUnderscore) {
  for (const std::string word : {"class", "double", "and", "co_await", "static_assert", "requires", "wchar_t"})
    EXPECT_EQ(identifier(word), word + "_");
}

TEST(Names, MacrosOfSystemHeadersGetAnUnderscore) {
  for (const std::string macro :
       {"I",      "M_PI", "major",  "minor", "linux",    "unix",     "NULL",     "errno",  "min",       "far",
        "PI",     "EOF",  "ERANGE", "EIO",   "SIZE_MAX", "INFINITY", "BUFSIZ",   "assert", "signbit",   "isnan",
        "SIGINT", "B0",   "stdin",  "NAN",   "PRId64",   "INT8_C",   "PATH_MAX", "i386",   "CLOCK_TAI", "offsetof"})
    EXPECT_EQ(identifier(macro), macro + "_");
}

TEST(Names, TypesAndVariablesOfSystemHeadersGetAnUnderscore) {
  for (const std::string name : {"uint", "ulong", "time_t", "environ", "optarg", "signgam"})
    EXPECT_EQ(identifier(name), name + "_");
}

// They can still name functions, members and enumerators.
TEST(Names, FunctionsOfSystemHeadersAreNotNamesOfNamespaces) {
  for (const std::string name : {"sincos", "exp", "index", "y0", "stat", "div", "tm"}) {
    EXPECT_FALSE(is_reserved(name)) << name;
    EXPECT_TRUE(is_reserved_namespace(name)) << name;
  }
  for (const std::string name : {"std", "Eigen", "robcogen", "linux", "double"})
    EXPECT_TRUE(is_reserved_namespace(name)) << name;
  for (const std::string name : {"hyl", "leg", "left", "hopper"}) EXPECT_FALSE(is_reserved_namespace(name)) << name;
}

TEST(Names, LeadingAndDoubleUnderscoresVanish) {
  EXPECT_EQ(identifier("_leg"), "leg");
  EXPECT_EQ(identifier("__cplusplus"), "cplusplus");
  EXPECT_EQ(identifier("left__leg"), "left_leg");
  EXPECT_EQ(identifier("_int"), "int_");
}

TEST(Names, IllegalCharactersBecomeUnderscores) {
  EXPECT_EQ(identifier("left-leg"), "left_leg");
  EXPECT_EQ(identifier("a.b c"), "a_b_c");
  EXPECT_EQ(identifier("knie\xc3\xa4"), "knie_");
  EXPECT_EQ(identifier("7of9"), "n7of9");
  EXPECT_EQ(identifier(""), "n");
  EXPECT_EQ(identifier("_"), "n");
}

TEST(Names, ShortenedKeepsBothEnds) {
  EXPECT_EQ(shortened("short", 10), "short");
  const std::string name = shortened("left_front_shock_absorber_housing_wdx", 20);
  EXPECT_LE(name.size(), 20u);
  EXPECT_TRUE(name.starts_with("left_fro"));
  EXPECT_TRUE(name.ends_with("wdx"));
}

TEST(NameScope, NumbersWhatIsTaken) {
  NameScope scope({"q"});
  EXPECT_EQ(scope.claim("q"), "q_2");
  EXPECT_EQ(scope.claim("q"), "q_3");
  EXPECT_EQ(scope.claim("class"), "class_");
  EXPECT_EQ(scope.claim("class"), "class_2");
  EXPECT_EQ(scope.claim("x"), "x");
}

TEST(NameScope, NumberedNamesDoNotClashWithGivenOnes) {
  NameScope scope;
  EXPECT_EQ(scope.claim("a_2"), "a_2");
  EXPECT_EQ(scope.claim("a"), "a");
  EXPECT_EQ(scope.claim("a"), "a_3");
}

TEST(NameScope, LegalNamesKeepTheirSpellingWhateverComesFirst) {
  NameScope scope;
  EXPECT_EQ(claim_all(scope, {"_leg", "leg", "a-b", "a_b", "leg"}), (Names{"leg_2", "leg", "a_b_2", "a_b", "leg_3"}));
}

TEST(NameScope, NamesThatDifferInCaseOnlyAreDifferent) {
  NameScope scope;
  EXPECT_EQ(claim_all(scope, {"HFE", "hfe"}), (Names{"HFE", "hfe"}));
}

}  // namespace
}  // namespace robcogen::backend::cpp::names_test
