// Programs and libraries for the tests of back ends.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "../model/trees.h"
#include "backend/library.h"
#include "symbolic/text.h"

namespace robcogen::test {

// Reads a program in text form; all its names count as describing their values.
inline symbolic::Program described_program(const std::string& text) {
  std::string error;
  std::optional<symbolic::Program> p = symbolic::parse(text, error);
  EXPECT_TRUE(p) << error;
  if (!p) return {};
  for (symbolic::Statement& s : p->statements)
    s.quantity = std::make_shared<const symbolic::Quantity>(symbolic::Quantity{s.name});
  return *p;
}

// A program over q and qd of the joints HFE and KFE with one output array `tau`, in the sections `hip` and `knee`.
inline symbolic::Program leg_program(const std::string& statements, int outputs = 1) {
  return described_program(
      "program leg\n"
      "input q joint_position HFE KFE\n"
      "input qd joint_velocity HFE KFE\n"
      "output tau value " +
      std::to_string(outputs) +
      " 1\n"
      "section hip link hip: velocity\n"
      "section knee link knee: velocity\n"
      "in 0\n" +
      statements);
}

inline backend::Function function(const std::string& name, const std::string& kernel, symbolic::Program program) {
  backend::Function f;
  f.group = name;
  f.name = name;
  f.kernel = kernel;
  f.summary = {"Summary of " + kernel + "."};
  f.program = std::move(program);
  return f;
}

// A base and two links, without functions.
inline backend::Library leg_library() {
  backend::Library library;
  library.name = "leg";
  library.model_file = "leg.kindsl";
  library.model_hash = "0123456789abcdef";
  library.generator_version = "1.2.3";
  model::KinematicTree& tree = library.tree = model::test::only_base("Leg", "trunk");
  const model::Inertia thigh = model::test::body(2.5, {0.1, 0, 0}, {1, 2, 3, 0, 0, 0});
  model::test::add_link(tree, "HFE", model::JointType::revolute, 0, "thigh", thigh);
  model::test::add_link(tree, "KFE", model::JointType::prismatic, 1, "shank", {}, model::test::vector(0.35, 0, 0));
  model::test::add_frame(tree, "fr_foot", 2, model::test::vector(0.33, 0, 0));
  return library;
}

}  // namespace robcogen::test
