// Files of tool/editors: generated files have the words of the parsers, and the others name all languages.

#include "client.h"
#include "language/common/lexer.h"
#include "patterns.h"
#include "run_tool.h"
#include "server/vocabulary.h"

namespace robcogen::test::grammars_test {
namespace {

namespace fs = std::filesystem;

const fs::path kEditors = ROBCOGEN_EDITORS_DIR;

TEST(Grammars, AreThoseOfTheParsers) {
  const Scratch scratch("grammars");
  ASSERT_EQ(std::system((quoted(ROBCOGEN_WRITE_GRAMMARS) + " " + quoted(scratch.path)).c_str()), 0);
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path)) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(contents(kEditors / fs::relative(entry.path(), scratch.path)), contents(entry.path()))
        << entry.path() << ": the target update_grammars writes it anew";
    ++count;
  }
  EXPECT_EQ(count, 13);
}

// The expressions of a TextMate grammar find the same words, numbers and comments as the lexer.
TEST(Grammars, OfTextMateFindWhatTheLexerFinds) {
  const Json grammar = Json::parse(contents(kEditors / "vscode/syntaxes/kindsl.tmLanguage.json"));
  std::map<std::string, std::string> patterns;
  for (const Json& pattern : grammar.at("patterns"))
    if (pattern.contains("match") && pattern.contains("name"))
      patterns.emplace(pattern["name"].get<std::string>(), pattern["match"].get<std::string>());
  const auto matches = [&](const std::string& name, std::string_view word) {
    return whole_match(std::string(word), patterns.at(name + ".kindsl")).has_value();
  };
  const std::string text = contents(robot("hyl_parametric"));
  Diagnostics none;
  const auto tokens = language::tokenize(std::make_shared<const Source>("", text), none);
  const auto& keywords = server::keywords(driver::Language::robot);
  int words = 0, numbers = 0;
  for (const language::Token& token : tokens.tokens) {
    const bool is_word = token.kind == language::Token::Kind::identifier;
    const bool is_keyword = is_word && std::count(keywords.begin(), keywords.end(), token.text) > 0;
    if (is_word) {
      EXPECT_EQ(matches("keyword.control", token.text), is_keyword) << token.text;
    }
    if (token.kind == language::Token::Kind::number) {
      EXPECT_TRUE(matches("constant.numeric", token.text)) << token.text;
      ++numbers;
    }
    words += is_keyword ? 1 : 0;
  }
  EXPECT_GT(words, 50);
  EXPECT_GT(numbers, 20);
  for (const language::Comment& comment : tokens.comments)
    if (comment.text.starts_with("//")) {
      EXPECT_TRUE(matches("comment.line.double-slash", comment.text)) << comment.text;
    }
}

TEST(Grammars, TheExtensionNamesAllLanguagesAndFiles) {
  const Json package = Json::parse(contents(kEditors / "vscode/package.json"));
  for (const char* language : {"kindsl", "dtdsl", "motdsl", "ctdsl"}) {
    bool is_language = false, is_grammar = false;
    for (const Json& known : package.at("contributes").at("languages")) {
      EXPECT_TRUE(fs::exists(kEditors / "vscode" / known.at("configuration").get<std::string>()));
      is_language =
          is_language || (known.at("id") == language && known.at("extensions")[0] == "." + std::string(language));
    }
    for (const Json& known : package["contributes"].at("grammars")) {
      EXPECT_TRUE(fs::exists(kEditors / "vscode" / known.at("path").get<std::string>()));
      is_grammar = is_grammar || known.at("language") == language;
    }
    EXPECT_TRUE(is_language && is_grammar) << language;
    for (const char* file :
         {"helix/languages.toml", "kate/settings.json", "neovim/plugin/robcogen.lua", "emacs/robcogen-mode.el"})
      EXPECT_NE(
          contents(kEditors / file).find(std::string("\"") + language),
          contents(kEditors / file).find(std::string("'") + language))
          << file << " does not name " << language;
  }
  EXPECT_TRUE(fs::exists(kEditors / "vscode" / package.at("main").get<std::string>()));
  EXPECT_TRUE(package.at("capabilities").at("untrustedWorkspaces").at("supported"));
}

}  // namespace
}  // namespace robcogen::test::grammars_test
