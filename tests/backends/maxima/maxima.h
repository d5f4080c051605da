// Maxima as a judge of the text that the generator prints for it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "backend/library.h"
#include "driver/driver.h"

namespace robcogen::test {

// Skips without Maxima, or fails where it is required.
class WithMaxima : public virtual testing::Test {
 protected:
  void SetUp() override;
};

// Loads the files in their order into a Maxima of its own: the lines that they print with "= " in front, without it and
// without blanks at their end. A file that cannot be loaded ends the run, and the test fails with all that was printed.
std::vector<std::string> run_maxima(const std::vector<OutputFile>& files);

// The library of a robot document, with its list of desired transforms where one stands beside it; or of a
// document of motions or transforms; with these derivatives.
backend::Library library_of(
    const std::filesystem::path& document,
    const std::string& name,
    driver::Primitives primitives = std::nullopt,
    const std::vector<driver::Derivative>& derivatives = {},
    const std::vector<std::string>& groups = algorithm::groups());

// The text of a library.
OutputFile maxima_text(const backend::Library& library);

// Calls every function of the library, as the text defines them, on random states, and compares all elements of their
// results with those of the interpreter: a line for each difference; empty when there is none.
std::string differences(const backend::Library& library, const OutputFile& text);

}  // namespace robcogen::test
