#include "kernel_evaluator.h"

#include <cmath>

namespace robcogen::test {

void KernelEvaluator::run(const std::string& line) {
  text_ = line;
  at_ = 0;
  if (accept("//")) return;
  if (accept("const auto [")) {
    const std::string sine = word();
    expect(", ");
    const std::string cosine = word();
    expect("] = ");
    double angle;
    if (accept("robcogen::sincos(")) {
      angle = argument();
    } else {
      angle = values_.at(angles_.at(word()));
    }
    ++count_.sincos;
    define(sine, std::sin(angle));
    define(cosine, std::cos(angle));
  } else if (accept("const robcogen::SinCosOf<Scalar, ")) {
    const int count = std::stoi(word());
    expect("> ");
    const std::string name = word();
    expect("(&");
    std::string first = word();
    const std::size_t bracket = first.find('[');
    const int begin = std::stoi(first.substr(bracket + 1));
    first.erase(bracket);
    for (int k = 0; k < count; ++k)
      angles_[name + "[" + std::to_string(k) + "]"] = first + "[" + std::to_string(begin + k) + "]";
    expect(")");
  } else if (accept("const Scalar ") || accept("const Scalar& ")) {
    const std::string name = word();
    expect_equals();
    define(name, sum());
  } else {
    // The last `=` separates the targets from the value.
    const std::size_t end = text_.rfind(" =");
    std::vector<std::string> targets;
    while (at_ <= end) {
      targets.push_back(word());
      expect_equals();
    }
    const double value = sum();
    for (const std::string& target : targets) define(target, value);
  }
  expect(";");
  if (at_ != text_.size()) throw std::logic_error("text after the end of: " + text_);
}

bool KernelEvaluator::accept(const std::string& token) {
  if (text_.compare(at_, token.size(), token) != 0) return false;
  at_ += token.size();
  return true;
}

void KernelEvaluator::expect(const std::string& token) {
  if (!accept(token)) throw std::logic_error("expected '" + token + "' at " + std::to_string(at_) + " of: " + text_);
}

// The value is in the same line or in the next one.
void KernelEvaluator::expect_equals() {
  if (!accept(" =\n      ")) expect(" = ");
}

// Reads a name, with its index if it has one.
std::string KernelEvaluator::word() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
  if (at_ == begin) throw std::logic_error("expected a name in: " + text_);
  if (accept("[")) at_ = text_.find(']', at_) + 1;
  return text_.substr(begin, at_ - begin);
}

double KernelEvaluator::sum() {
  double value = product();
  while (true) {
    if (accept(" + "))
      value = value + product();
    else if (accept(" - "))
      value = value - product();
    else
      return value;
    ++count_.add;
  }
}

double KernelEvaluator::product() {
  double value = unary();
  while (true) {
    if (accept(" * ")) {
      value = value * unary();
      ++count_.mul;
    } else if (accept(" / ")) {
      value = value / unary();
      ++count_.div;
    } else {
      return value;
    }
  }
}

double KernelEvaluator::unary() {
  return accept("-") ? -unary() : primary();
}

double KernelEvaluator::primary() {
  if (accept("(")) return argument();
  if (accept("Scalar(")) {
    const std::size_t end = text_.find(')', at_);
    const double value = std::stod(text_.substr(at_, end - at_));
    at_ = end + 1;
    return value;
  }
  if (accept("sqrt(")) {
    ++count_.sqrt;
    return std::sqrt(argument());
  }
  if (accept("magnitude(")) {  // as in the program
    ++count_.mul;
    ++count_.sqrt;
    const double value = argument();
    return std::sqrt(value * value);
  }
  for (const bool sine : {true, false}) {
    if (!accept(sine ? "sin(" : "cos(")) continue;
    ++count_.sincos;
    return sine ? std::sin(argument()) : std::cos(argument());
  }
  const std::string name = word();
  const auto value = values_.find(name);
  if (value == values_.end()) throw std::logic_error("'" + name + "' is read before it is known");
  return value->second;
}

double KernelEvaluator::argument() {
  const double value = sum();
  expect(")");
  return value;
}

void KernelEvaluator::define(const std::string& name, double value) {
  if (!values_.emplace(name, value).second) throw std::logic_error("'" + name + "' is defined twice");
}

}  // namespace robcogen::test
