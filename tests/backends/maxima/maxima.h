// Runs generated text in Maxima.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../calls.h"

namespace robcogen::test {

// Skips the test if Maxima is missing, or fails it if Maxima is required.
class WithMaxima : public virtual testing::Test {
 protected:
  void SetUp() override;
};

// Loads the files in order into a new Maxima process. Returns the printed lines that begin with "= ", without this
// prefix and without trailing blanks. A file that cannot be loaded ends the run, and the test fails with all that was
// printed.
std::vector<std::string> run_maxima(const std::vector<OutputFile>& files);

// The text of a library.
OutputFile maxima_text(const backend::Library& library);

// Calls every function of the library in the text on random states and compares all elements of the results with the
// interpreter's. Returns a line for each difference; empty if there is none.
std::string differences(const backend::Library& library, const OutputFile& text);

}  // namespace robcogen::test
