#include "pass/passes.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace robcogen::pass {
namespace {

struct Pass {
  const char* name;
  symbolic::Program (*run)(symbolic::Program);
};

constexpr std::array kPasses = {Pass{"canonical", canonical}, Pass{"reassociate", reassociate}, Pass{"sink", sink}};

}  // namespace

const std::vector<std::string>& names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list;
    for (const Pass& pass : kPasses) list.emplace_back(pass.name);
    return list;
  }();
  return all;
}

symbolic::Program run(symbolic::Program program, const std::vector<std::string>& passes) {
  for (const std::string& name : passes)
    if (std::find(names().begin(), names().end(), name) == names().end())
      throw std::logic_error("unknown pass '" + name + "'");
  for (const Pass& pass : kPasses)
    if (std::find(passes.begin(), passes.end(), pass.name) != passes.end()) program = pass.run(std::move(program));
  return program;
}

}  // namespace robcogen::pass
