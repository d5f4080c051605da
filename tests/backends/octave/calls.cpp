#include "calls.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>

namespace robcogen::octave {
namespace {

constexpr unsigned kSeed = 20;
constexpr double kStandardGravity[] = {0.0, 0.0, -9.81};

int size(const Argument& a) {
  return a.rows * a.columns;
}

std::string line(const Call& call) {
  std::string text = call.function;
  for (const Argument& a : call.arguments) {
    if (call.omits_gravity && &a == &call.arguments.back()) break;
    text += fmt::format(" {} {} {} {}", a.name, a.rows, a.columns, a.kind);
  }
  text += " >";
  for (const Result& r : call.results) text += fmt::format(" {} {} {}", r.name, r.rows, r.columns);
  return text + "\n";
}

// The distributions of the standard library differ between implementations; the engine does not.
double uniform(std::mt19937& engine, double lower, double upper) {
  return lower + (upper - lower) * (static_cast<double>(engine()) / 4294967296.0);
}

std::vector<double> draw(const Argument& argument, std::mt19937& engine) {
  std::vector<double> values;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size(argument)); ++i)
    values.push_back(
        argument.around.empty() ? uniform(engine, -argument.limit, argument.limit)
                                : argument.around[i] * uniform(engine, 0.8, 1.2));
  for (const int first : argument.quaternions) {
    double square = 0;
    for (int k = first; k < first + 4; ++k) square += values[std::size_t(k)] * values[std::size_t(k)];
    for (int k = first; k < first + 4; ++k) values[std::size_t(k)] /= std::sqrt(square);
  }
  return values;
}

// Evaluates the call at one random state; returns its arguments and results.
std::vector<double> evaluate(const Call& call, std::mt19937& engine) {
  std::vector<std::vector<double>> arguments, results;
  for (const Argument& a : call.arguments) arguments.push_back(draw(a, engine));
  if (call.omits_gravity) arguments.back().assign(std::begin(kStandardGravity), std::end(kStandardGravity));
  for (const Result& r : call.results) results.emplace_back(static_cast<std::size_t>(r.rows * r.columns), std::nan(""));
  std::vector<const double*> in;
  std::vector<double*> out;
  for (const std::vector<double>& a : arguments) in.push_back(a.data());
  for (std::vector<double>& r : results) out.push_back(r.data());
  call.evaluate(in.data(), out.data());

  std::vector<double> record;
  if (call.omits_gravity) arguments.pop_back();
  for (const std::vector<double>& a : arguments) record.insert(record.end(), a.begin(), a.end());
  for (const std::vector<double>& r : results) record.insert(record.end(), r.begin(), r.end());
  for (const double value : record)
    if (!std::isfinite(value)) throw std::runtime_error(call.function + " gives a value that is not finite");
  return record;
}

}  // namespace

void write_values(const std::vector<Call>& calls, int states, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream lines(folder / "calls.txt", std::ios::binary);
  std::ofstream values(folder / "values.bin", std::ios::binary);
  std::mt19937 engine(kSeed);
  for (const Call& call : calls) {
    lines << line(call);
    for (int state = 0; state < states; ++state) {
      const std::vector<double> record = evaluate(call, engine);
      values.write(
          reinterpret_cast<const char*>(record.data()), static_cast<std::streamsize>(record.size() * sizeof(double)));
    }
  }
  lines.close();
  values.close();
  if (!lines || !values) throw std::runtime_error("cannot write to " + folder.string());
}

int write_values(const std::vector<Call>& calls, const std::vector<std::string>& arguments, std::size_t first) {
  try {
    write_values(calls, std::stoi(arguments.at(first)), arguments.at(first + 1));
    return 0;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "{}\n", fault.what());
    return 1;
  }
}

}  // namespace robcogen::octave
