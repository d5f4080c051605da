// Runs a program without a compiler: the evaluator behind `robcogen eval` and the property tests.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Values by array name; each array has the declared length (matrices column by column).
template <class Real>
using Arrays = std::map<std::string, std::vector<Real>>;

// Missing input arrays count as zero; an array of the wrong length or an unknown name is an internal fault
// (std::logic_error): callers check user input first. Real is float, double or long double.
template <class Real>
Arrays<Real> interpret(const Program& program, const Arrays<Real>& inputs);

extern template Arrays<float> interpret(const Program&, const Arrays<float>&);
extern template Arrays<double> interpret(const Program&, const Arrays<double>&);
extern template Arrays<long double> interpret(const Program&, const Arrays<long double>&);

}  // namespace robcogen::symbolic
