// Runs generated modules in Node.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../calls.h"

namespace robcogen::test {

// Skips the test if Node is missing, or fails it if Node is required.
class WithNode : public virtual testing::Test {
 protected:
  void SetUp() override;
};

// Runs the last file, a module in the same folder as the others, and returns the lines that it prints. If Node reports
// an error, the test fails with its output.
std::vector<std::string> run_node(const std::vector<OutputFile>& files);

// The module of a library.
OutputFile module_of(const backend::Library& library);

// Calls every function of the library in the module on random states and compares all elements of the results with the
// interpreter's. Returns a line for each difference; empty if there is none. `calls`, if given, receives the number of
// compared calls.
std::string differences(const backend::Library& library, const OutputFile& module, int* calls = nullptr);

}  // namespace robcogen::test
