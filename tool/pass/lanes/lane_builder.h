// Makes the program that pack_lanes computes: statements with lanes, their names, sections and order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pass/lanes/correspondence.h"
#include "symbolic/program.h"

namespace robcogen::pass {

class LaneBuilder {
 public:
  // Inputs, constants, names and sections are those of `old`.
  explicit LaneBuilder(const symbolic::Program& old);

  // What is made next stands for these statements of the old program (none: for the one at `place`), and comes after
  // everything that stands for an earlier place than this.
  void begin(const Tuple& lanes, int place);

  int width(const symbolic::Operand& o) const;
  symbolic::Operand number(const Number& value);  // not negative
  // Numbers in the lanes, some of them negated. The same in all: one scalar.
  symbolic::Operand numbers(const Tuple& lanes, unsigned flips);
  symbolic::Operand gather(Tuple lanes);
  symbolic::Operand product(symbolic::Operand a, symbolic::Operand b);
  symbolic::Operand quotient(symbolic::Operand a, symbolic::Operand b);
  symbolic::Operand unary(symbolic::Op op, const symbolic::Operand& a);
  symbolic::Operand binary(symbolic::Op op, const symbolic::Operand& a, symbolic::Operand b);
  // A chain that begins with a term that is no product and takes the others as they get ready, so that each addition
  // can be fused with a product; unless that term is a sum of lanes that is known after several products.
  symbolic::Operand sum(std::vector<symbolic::Operand> terms);
  // Of a value that is a scalar in `width` equal lanes, too.
  symbolic::Operand sum_lanes(const symbolic::Operand& a, int width);

  // Gives the value the name that these statements have in common.
  void name(const symbolic::Operand& value, const Tuple& lanes);

  // Statements in the order of their places; what brings numbers into lanes, next to its first use.
  symbolic::Program program(const std::vector<std::vector<symbolic::Operand>>& outputs);

 private:
  struct Made {
    symbolic::Statement statement;
    int place = 0;
    bool late = false;
    int ready = 0;  // after how many cycles
  };

  symbolic::Operand make(symbolic::Statement s, int latency);
  int ready(const symbolic::Operand& o) const;
  bool is_product(const symbolic::Operand& o) const;
  bool is_sum_of_lanes(const symbolic::Operand& o) const;
  int section_of(const Tuple& lanes, int place);
  void fold_constants(std::vector<symbolic::Operand>& terms);
  void settle_late();
  std::vector<int> order() const;
  void name_all(symbolic::Program& program) const;

  const symbolic::Program& old_;
  symbolic::Program new_;
  std::vector<Made> made_;
  std::map<std::vector<int>, int> sections_;                                // by those of the lanes
  std::map<std::vector<std::pair<int, bool>>, symbolic::Operand> numbers_;  // by constants and signs
  std::map<int, symbolic::Operand> sums_of_lanes_;                          // by statement
  int place_ = 0, section_ = 0;
};

}  // namespace robcogen::pass
