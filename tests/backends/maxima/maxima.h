// Maxima as a judge of the text that the generator prints for it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../calls.h"

namespace robcogen::test {

// Skips without Maxima, or fails where it is required.
class WithMaxima : public virtual testing::Test {
 protected:
  void SetUp() override;
};

// Loads the files in their order into a Maxima of its own: the lines that they print with "= " in front, without it and
// without blanks at their end. A file that cannot be loaded ends the run, and the test fails with all that was printed.
std::vector<std::string> run_maxima(const std::vector<OutputFile>& files);

// The text of a library.
OutputFile maxima_text(const backend::Library& library);

// Calls every function of the library, as the text defines them, on random states, and compares all elements of their
// results with those of the interpreter: a line for each difference; empty when there is none.
std::string differences(const backend::Library& library, const OutputFile& text);

}  // namespace robcogen::test
