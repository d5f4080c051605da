#include "algorithm/kinematics/merged_primitives.h"

#include <algorithm>
#include <iterator>

namespace robcogen::algorithm {
namespace {

using model::PrimitiveTransform;
using model::Quantity;
using Op = Quantity::Op;

// A sum: its constant, and the other terms with their signs.
struct Sum {
  struct Term {
    Quantity value;
    bool negative;
  };
  Quantity constant;
  std::vector<Term> terms;

  void add(const Quantity& q, bool negative) {
    switch (q.op()) {
      case Op::constant:
        constant = negative ? constant - q : constant + q;
        return;
      case Op::negate:
        return add(q.left(), !negative);
      case Op::add:
      case Op::subtract:
        add(q.left(), negative);
        return add(q.right(), negative != (q.op() == Op::subtract));
      default:
        break;
    }
    const auto opposite =
        std::find_if(terms.begin(), terms.end(), [&](const Term& t) { return t.negative != negative && t.value == q; });
    if (opposite != terms.end())
      terms.erase(opposite);
    else
      terms.push_back({q, negative});
  }

  Quantity value() const {
    Quantity total;
    for (const Term& term : terms) total = term.negative ? total - term.value : total + term.value;
    return total + constant;
  }
};

Quantity sum(const Quantity& a, const Quantity& b) {
  Sum result;
  result.add(a, false);
  result.add(b, false);
  return result.value();
}

bool commute(const PrimitiveTransform& a, const PrimitiveTransform& b) {
  return a.axis == b.axis || (!a.rotation && !b.rotation);
}

}  // namespace

std::vector<PrimitiveTransform> merged(const std::vector<PrimitiveTransform>& primitives) {
  std::vector<PrimitiveTransform> result;
  for (const PrimitiveTransform& next : primitives) {
    const auto is_partner = [&](const PrimitiveTransform& p) {
      return p.rotation == next.rotation && p.axis == next.axis;
    };
    const auto barrier = std::find_if(result.rbegin(), result.rend(), [&](const PrimitiveTransform& p) {
      return is_partner(p) || !commute(p, next);
    });
    if (barrier == result.rend() || !is_partner(*barrier)) {
      if (!next.amount.is_zero()) result.push_back(next);
      continue;
    }
    barrier->amount = sum(barrier->amount, next.amount);
    if (barrier->amount.is_zero()) result.erase(std::next(barrier).base());
  }
  return result;
}

}  // namespace robcogen::algorithm
