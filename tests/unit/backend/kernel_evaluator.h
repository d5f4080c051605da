// Runs the text of a kernel by its own reading of C++: an evaluator of the printed lines that shares nothing with the
// back end, and counts the operators that stand in them.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/count.h"

namespace robcogen::test {

class KernelEvaluator {
 public:
  // Elements of arrays by their text: `q[1]`.
  using Values = std::map<std::string, double>;

  explicit KernelEvaluator(Values inputs) : values_(std::move(inputs)) {}

  // One line: a comment, a definition, a pair of sine and cosine, or a store.
  void run(const std::string& line);

  const Values& values() const { return values_; }
  // mul, add, div, sqrt and sincos in the lines; a unary minus is not an operation.
  const symbolic::OperationCount& count() const { return count_; }

 private:
  Values values_;
  std::map<std::string, std::string> angles_;  // `trig[1]`: the element that it is of
  symbolic::OperationCount count_;
  std::string text_;
  std::size_t at_ = 0;

  bool accept(const std::string& token);
  void expect(const std::string& token);
  void expect_equals();
  std::string word();
  double sum();
  double product();
  double unary();
  double primary();
  double argument();
  void define(const std::string& name, double value);
};

}  // namespace robcogen::test
