#include <algorithm>

#include "pass/passes.h"
#include "pass/statements.h"
#include "support/index.h"
#include "symbolic/cost.h"
#include "symbolic/rebuild.h"

namespace robcogen::pass {
namespace {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::kLatency;
using symbolic::latency;
using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Rebuild;
using symbolic::Statement;

// The latest cycle at which each statement may finish so that all are done by `deadline`.
std::vector<int> latest_finish(const Program& p, int deadline) {
  std::vector<int> latest(p.statements.size(), deadline);
  for (std::size_t i = p.statements.size(); i-- > 0;) {
    const Statement& s = p.statements[i];
    for_each_read(s, [&](int read) {
      const auto r = at(read);
      const bool fused = is_sum(s.op) && p.statements[r].op == Op::multiply;
      latest[r] = std::min(latest[r], fused ? latest[i] : latest[i] - latency(s.op));
    });
  }
  return latest;
}

class Reassociation {
 public:
  explicit Reassociation(const Program& p)
      : p_(p),
        uses_(use_counts(p)),
        inner_(inner_sums(p, uses_)),
        latest_(latest_finish(p, symbolic::time(symbolic::cost(p)))),
        finish_(p.statements.size(), 0),
        rebuild_(graph_, p) {
    for (std::size_t i = 0; i < p.statements.size(); ++i)
      if (p.statements[i].named) inner_[i] = false;
  }

  Program run() {
    for (std::size_t i = 0; i < p_.statements.size(); ++i) {
      if (inner_[i]) continue;  // made with its root
      rebuild_.enter_section_of(i);
      if (!is_sum(p_.statements[i].op) || !make_chain(i)) keep(i);
    }
    return rebuild_.finish();
  }

 private:
  const Program& p_;
  std::vector<int> uses_;
  std::vector<bool> inner_;  // a sum without a name that only another sum reads
  std::vector<int> latest_;
  std::vector<int> finish_;  // of rebuilt statements
  Graph graph_;
  Rebuild rebuild_;

  bool is_product(const Operand& o) const {
    if (!is_statement(o)) return false;
    return p_.statements[at(o.index)].op == Op::multiply && uses_[at(o.index)] == 1;
  }

  // The cycle in which a term can enter a sum: a product is fused, so its factors count.
  int ready(const Operand& o) const {
    if (!is_statement(o)) return 0;
    const int finish = finish_[at(o.index)];
    return is_product(o) ? finish - kLatency : finish;
  }

  bool make_chain(std::size_t root) {
    std::vector<Operand> terms;
    terms_of(p_, inner_, static_cast<int>(root), terms);
    std::stable_sort(
        terms.begin(), terms.end(), [&](const Operand& a, const Operand& b) { return ready(a) < ready(b); });
    const auto first = std::find_if_not(terms.begin(), terms.end(), [&](const Operand& o) { return is_product(o); });
    if (first != terms.end()) std::rotate(terms.begin(), first, first + 1);
    int finish = ready(terms.front());
    for (std::size_t k = 1; k < terms.size(); ++k) finish = std::max(finish, ready(terms[k])) + kLatency;
    if (finish > latest_[root]) return false;
    Expression sum;
    for (const Operand& term : terms) sum += rebuild_.read(term);
    rebuild_.set(root, sum);
    finish_[root] = finish;
    return true;
  }

  // Keeps a statement as it was, inner sums first.
  void keep(std::size_t i) {
    const Statement& s = p_.statements[i];
    int start = 0;
    for (const Operand& o : {s.a, s.b}) {
      if (!is_statement(o)) continue;
      if (inner_[at(o.index)] && is_sum(s.op)) keep(at(o.index));
      start = std::max(start, is_sum(s.op) ? ready(o) : finish_[at(o.index)]);
    }
    rebuild_.set(i, rebuild_.compute(i));
    finish_[i] = start + latency(s.op);
  }
};

}  // namespace

// A processor fuses an addition with one product at no cost. In x + (a b + c d) the inner sum is fused with one product
// and the outer one with none; in (x + a b) + c d both are fused. So a sum becomes a chain that begins with a term that
// is not a product and adds the other terms in the order in which they become available; a sum stays as it was if the
// chain would lengthen the critical path of the program.
Program reassociate(Program p) {
  return Reassociation(p).run();
}

}  // namespace robcogen::pass
