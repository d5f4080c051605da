// Node as a judge of the modules that the generator prints.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../calls.h"

namespace robcogen::test {

// Skips without Node, or fails where it is required.
class WithNode : public virtual testing::Test {
 protected:
  void SetUp() override;
};

// Runs the last of the files, a module beside the others: the lines that it prints. A fault of Node's fails the test
// with what it said.
std::vector<std::string> run_node(const std::vector<OutputFile>& files);

// The module of a library.
OutputFile module_of(const backend::Library& library);

// Calls every function of the library, as the module defines them, on random states, and compares all elements of their
// results with those of the interpreter: a line for each difference; empty when there is none. `calls`, where given,
// takes how many were compared.
std::string differences(const backend::Library& library, const OutputFile& module, int* calls = nullptr);

}  // namespace robcogen::test
