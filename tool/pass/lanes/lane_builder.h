// Builds a program with lanes: its statements, their names, sections and order.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pass/lanes/correspondence.h"
#include "symbolic/program.h"

namespace robcogen::pass {

class LaneBuilder {
 public:
  // Inputs, constants, names and sections are those of `old`.
  explicit LaneBuilder(const symbolic::Program& old);

  // The next statements replace these statements of the old program (if there are none, the one at `place`), and come
  // after all statements that replace those at an earlier place.
  void begin(const Tuple& lanes, int place);

  int width(const symbolic::Operand& o) const;
  symbolic::Operand constant(const symbolic::Constant& value);  // not negative
  // A value with these numbers in its lanes, some of them negated; a scalar if they are equal in all lanes.
  symbolic::Operand numbers(const Tuple& lanes, unsigned negated_lanes);
  symbolic::Operand gather(Tuple lanes);
  symbolic::Operand product(symbolic::Operand a, symbolic::Operand b);
  symbolic::Operand quotient(symbolic::Operand a, symbolic::Operand b);
  symbolic::Operand unary(symbolic::Op op, const symbolic::Operand& a);
  symbolic::Operand binary(symbolic::Op op, const symbolic::Operand& a, symbolic::Operand b);
  // A chain that begins with a term that is not a product and adds the others in the order in which they become
  // available, so that each addition can be fused with a product; unless that first term is a sum over lanes that is
  // known only after several of the products.
  symbolic::Operand sum(std::vector<symbolic::Operand> terms);
  // The sum of the lanes of `a`; a scalar counts `width` times.
  symbolic::Operand sum_lanes(const symbolic::Operand& a, int width);

  // Gives the value the name that these statements have in common.
  void name(const symbolic::Operand& value, const Tuple& lanes);

  // Statements in the order of their places; a statement that brings numbers into lanes stands next to its first use.
  symbolic::Program program(const std::vector<std::vector<symbolic::Operand>>& outputs);

 private:
  struct Scheduled {
    symbolic::Statement statement;
    int place = 0;
    bool late = false;
    int ready = 0;  // the cycle after which the value is known
  };

  symbolic::Operand append(symbolic::Statement s, int latency);
  int ready(const symbolic::Operand& o) const;
  bool is_product(const symbolic::Operand& o) const;
  bool is_sum_of_lanes(const symbolic::Operand& o) const;
  int section_of(const Tuple& lanes, int place);
  void fold_constants(std::vector<symbolic::Operand>& terms);
  void settle_late();
  std::vector<int> order() const;

  const symbolic::Program& old_;
  symbolic::Program new_;
  std::vector<Scheduled> scheduled_;
  std::map<std::vector<int>, int> sections_;                                // by the sections of the lanes
  std::map<std::vector<std::pair<int, bool>>, symbolic::Operand> numbers_;  // by constants and signs
  std::map<int, symbolic::Operand> sums_of_lanes_;                          // by statement
  int place_ = 0, section_ = 0;
};

}  // namespace robcogen::pass
