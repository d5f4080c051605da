// The grammars of tool/language/README.md and the parsers accept the same documents and have the same keywords.
#include "grammar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

#include "language/desired/document.h"
#include "language/desired/keywords.h"
#include "language/kinematics/document.h"
#include "language/kinematics/keywords.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "markdown.h"

namespace robcogen::test::grammar_test {
namespace {

namespace fs = std::filesystem;

constexpr int kDocuments = 500;  // derived from each grammar
constexpr unsigned kSeed = 1;
constexpr int kDeep = 8, kShallow = 3;  // depth of nested rules, for documents to parse and for documents to change
constexpr std::size_t kManyTokens = 400;

struct Language {
  std::string extension;  // of files; the title of the guide's section ends in it
  std::vector<std::string> keywords;
  std::function<void(std::shared_ptr<const Source>, Diagnostics&)> parse;
};

std::vector<Language> languages() {
  using namespace language;
  return {
      {"kindsl", kinematics::keywords(), kinematics::parse},
      {"dtdsl", desired::keywords(), desired::parse},
      {"motdsl", motion::keywords(), motion::parse},
      {"ctdsl", transforms::keywords(), transforms::parse}};
}

std::vector<CodeBlock> blocks() {
  return code_blocks(read_text(source_folder() / "tool/language/README.md"));
}

// The rules of a language's section, followed by those of expressions.
const Grammar& grammar_of(const Language& language) {
  static std::map<std::string, Grammar> grammars;
  if (const auto read = grammars.find(language.extension); read != grammars.end()) return read->second;
  std::string rules;
  for (const std::string& section : {"." + language.extension, std::string("Expressions")})
    for (const CodeBlock& block : blocks())
      if (block.language == "ebnf" && block.section.ends_with(section)) rules += block.text;
  return grammars.emplace(language.extension, Grammar(rules)).first->second;
}

// The errors of the document, without warnings.
std::string errors(const Language& language, const std::string& text) {
  Diagnostics diagnostics;
  language.parse(std::make_shared<Source>("document", text), diagnostics);
  return diagnostics.has_errors() ? diagnostics.render() : "";
}

bool is_matched(const Language& language, const std::string& text) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>("document", text);
  const std::set<std::string> keywords(language.keywords.begin(), language.keywords.end());
  const std::vector<language::Token> tokens = language::tokenize(source, diagnostics).tokens;
  return !diagnostics.has_errors() && grammar_of(language).matches(tokens, keywords);
}

TEST(Grammar, IsComplete) {
  for (const Language& language : languages())
    EXPECT_EQ(grammar_of(language).undefined(), std::vector<std::string>()) << language.extension;
}

TEST(Grammar, HasTheKeywordsOfTheParsers) {
  for (const Language& language : languages()) {
    const std::set<std::string> keywords(language.keywords.begin(), language.keywords.end());
    EXPECT_EQ(grammar_of(language).words("Expression"), keywords) << language.extension;
  }
}

TEST(Grammar, ParsersAcceptWhatItDerives) {
  for (const Language& language : languages()) {
    const Grammar& grammar = grammar_of(language);
    std::mt19937 random(kSeed);
    for (int i = 0; i < kDocuments; ++i) {
      const std::string text = grammar.derive(random, kDeep);
      const std::string fault = errors(language, text);
      ASSERT_EQ(fault, "") << language.extension << " document " << i << " of seed " << kSeed << ":\n" << text;
    }
  }
}

// One token is left out, doubled or moved: grammar and parser either both accept or both refuse the result.
TEST(Grammar, RefusesWhatParsersRefuse) {
  for (const Language& language : languages()) {
    const Grammar& grammar = grammar_of(language);
    std::mt19937 random(kSeed);
    int refused = 0;
    for (int i = 0; i < kDocuments; ++i) {
      Diagnostics diagnostics;
      const auto source = std::make_shared<Source>("document", grammar.derive(random, kShallow));
      const std::vector<language::Token> tokens = language::tokenize(source, diagnostics).tokens;
      if (tokens.size() > kManyTokens) continue;
      const std::size_t at = random() % (tokens.size() - 1), other = random() % (tokens.size() - 1);
      const auto kind = random() % 3;
      std::string text;
      bool is_after_point = false;
      const auto put = [&](const language::Token& token) {
        const std::string written(source->text().substr(token.span.begin, token.span.end - token.span.begin));
        text += (written == "." || is_after_point ? "" : " ") + written;
        is_after_point = written == ".";
      };
      for (std::size_t k = 0; k + 1 < tokens.size(); ++k) {
        if (k == at && kind == 0) continue;
        put(tokens[k == at && kind == 2 ? other : k]);
        if (k == at && kind == 1) put(tokens[k]);
      }
      const bool is_accepted = errors(language, text).empty();
      refused += is_accepted ? 0 : 1;
      EXPECT_EQ(is_matched(language, text), is_accepted) << language.extension << ":\n"
                                                         << text << "\n"
                                                         << errors(language, text);
    }
    EXPECT_GT(refused, kDocuments / 4) << language.extension;
  }
}

TEST(Grammar, MatchesTheDocumentsOfTheRobots) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() / "robots"))
    for (const Language& language : languages())
      if (entry.path().extension() == "." + language.extension) {
        EXPECT_TRUE(is_matched(language, read_text(entry.path()))) << entry.path();
        ++count;
      }
  EXPECT_GE(count, 19);
}

TEST(Grammar, ExamplesOfTheGuideAreDocuments) {
  for (const Language& language : languages()) {
    std::size_t count = 0;
    for (const CodeBlock& block : blocks()) {
      if (block.language != language.extension) continue;
      ++count;
      EXPECT_EQ(errors(language, block.text), "");
      EXPECT_TRUE(is_matched(language, block.text)) << block.text;
    }
    EXPECT_GE(count, 1) << language.extension;
  }
}

}  // namespace
}  // namespace robcogen::test::grammar_test
