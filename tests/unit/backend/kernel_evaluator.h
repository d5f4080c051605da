// Runs the text of a kernel with its own reading of C++: it evaluates the printed lines and counts their operators, and
// shares nothing with the back end.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/cost.h"

namespace robcogen::test {

class KernelEvaluator {
 public:
  // Array elements by their text, such as `q[1]`.
  using Values = std::map<std::string, double>;

  explicit KernelEvaluator(Values inputs) : values_(std::move(inputs)) {}

  // Runs one line: a comment, a definition, a pair of sine and cosine, or a store.
  void run(const std::string& line);

  const Values& values() const { return values_; }
  // Counts of mul, add, div, sqrt and sincos in the lines; a unary minus is not an operation.
  const symbolic::Cost& count() const { return count_; }

 private:
  Values values_;
  std::map<std::string, std::string> angles_;  // the element from which `trig[1]` is computed
  symbolic::Cost count_;
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
