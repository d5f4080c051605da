// A robot whose names are all words that Maxima reserves.
#include "maxima.h"

namespace robcogen::test {
namespace {

const std::filesystem::path kDocument = std::filesystem::path(TEST_SOURCE_DIR) / "words.kindsl";

class MaximaWords : public WithMaxima {};

TEST_F(MaximaWords, ReservedOnesAreNamesToo) {
  for (const char* name : {"if", "numer", "and"}) {
    const backend::Library library = library_of(kDocument, name, model::MovedFramePosition::left);
    EXPECT_EQ(differences(library, maxima_text(library)), "");
  }
}

TEST_F(MaximaWords, OfSystemHeadersAreNamesToo) {
  const backend::Library library =
      library_of(std::filesystem::path(TEST_SOURCE_DIR) / "../../codegen/names.kindsl", "I");
  EXPECT_EQ(differences(library, maxima_text(library)), "");
}

TEST_F(MaximaWords, NoneEndsAComment) {
  backend::Library library = library_of(kDocument, "words");
  library.model_file = "a*/b/*c*/*d\n.kindsl";
  EXPECT_EQ(differences(library, maxima_text(library)), "");
}

TEST(MaximaNames, TellEnclosingNamespaces) {
  backend::Library library = library_of(kDocument, "leg");
  library.enclosing = "a::b";
  const OutputFile text = maxima_text(library);
  EXPECT_EQ(text.path, "a_b_leg.mac");
  EXPECT_NE(text.text.find("\na_b_leg_joint_space_inertia(parameters, q) := "), std::string::npos);
}

}  // namespace
}  // namespace robcogen::test
