#include "pass/lanes/correspondence.h"

#include <algorithm>
#include <bit>

#include "pass/statements.h"
#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

std::uint64_t mix(std::uint64_t a, std::uint64_t b = 0) {
  std::uint64_t h = (a + 0x9e3779b97f4a7c15ULL) ^ (b + 0x632be59bd9b4e019ULL) * 0xbf58476d1ce4e5b9ULL;
  h ^= h >> 30;
  h *= 0x94d049bb133111ebULL;
  return h ^ h >> 31;
}

constexpr std::size_t kMaxClasses = 8;  // a bit for each limb; further classes have no lanes

// Seeds of hashes, by what is hashed.
enum Kind : std::uint64_t { number = 1, input_of_limb, other_input, shared, any_shared, sum, operation };

std::uint64_t of_operation(Op op) {
  return Kind::operation + static_cast<std::uint64_t>(op);
}

}  // namespace

Correspondence::Correspondence(
    const Program& program,
    const std::vector<InputTuples>& classes,
    const std::vector<bool>& inner)
    : program_(program),
      inner_(inner),
      input_limbs_(at(program.input_count()), 0),
      input_group_(input_limbs_.size(), -1),
      limbs_(program.statements.size(), 0),
      equal_(program.statements.size()),
      similar_(program.statements.size()),
      equal_terms_(program.statements.size()),
      similar_terms_(program.statements.size()) {
  int group = 0;
  for (std::size_t c = 0; c < classes.size() && c < kMaxClasses; ++c) {
    all_limbs_.push_back(0);
    for (const std::vector<int>& tuple : classes[c]) {
      for (std::size_t lane = 0; lane < tuple.size(); ++lane) {
        const std::uint64_t bit = std::uint64_t{1} << (at(kMaxLanes) * c + lane);
        input_limbs_[at(tuple[lane])] = bit;
        all_limbs_.back() |= bit;
        input_group_[at(tuple[lane])] = group;
      }
      ++group;
    }
  }
  for (const symbolic::InputArray& array : program.inputs)
    input_is_number_.insert(input_is_number_.end(), array.elements.size(), array.role == symbolic::Role::parameters);
  for (std::size_t i = 0; i < program.statements.size(); ++i) hash_statement(i);
}

std::uint64_t Correspondence::limbs(const Operand& o) const {
  if (is_constant(o)) return 0;
  return o.kind == Operand::Kind::input ? input_limbs_[at(o.index)] : limbs_[at(o.index)];
}

Correspondence::Owner Correspondence::owner(const Operand& o) const {
  const std::uint64_t bits = limbs(o);
  if (!std::has_single_bit(bits)) return {};
  const int bit = std::countr_zero(bits);
  return {bit / kMaxLanes, bit % kMaxLanes};
}

void Correspondence::hash_statement(std::size_t i) {
  const Statement& s = program_.statements[i];
  limbs_[i] = limbs(s.a) | (symbolic::is_binary(s.op) ? limbs(s.b) : 0);
  // A sum belongs to a limb only when it is complete: terms that one limb adds later do not count.
  for (const std::uint64_t all : all_limbs_)
    if (!inner_[i] && (limbs_[i] & all) == all) limbs_[i] &= ~all;
  const bool is_shared = !std::has_single_bit(limbs_[i]);
  const auto of = [&](Likeness likeness, std::vector<std::uint64_t>& all, std::vector<std::uint64_t>& terms) {
    if (is_sum(s.op)) {
      for (const Operand& o : {s.a, s.b}) {
        const bool is_inner = is_statement(o) && inner_[at(o.index)];
        terms[i] += is_inner ? terms[at(o.index)] : mix(hash(o, likeness));
      }
      all[i] = mix(Kind::sum, terms[i]);
    } else {
      std::uint64_t operands = mix(hash(s.a, likeness));
      if (symbolic::is_binary(s.op)) operands += mix(hash(s.b, likeness), s.op == Op::divide ? 1 : 0);
      all[i] = mix(of_operation(s.op), operands);
    }
    if (is_shared) all[i] = likeness == Likeness::equal ? mix(Kind::shared, i) : mix(Kind::any_shared);
  };
  of(Likeness::equal, equal_, equal_terms_);
  of(Likeness::similar, similar_, similar_terms_);
}

std::uint64_t Correspondence::hash(const Operand& o, Likeness likeness) const {
  const std::size_t i = at(o.index);
  if (is_constant(o)) return mix(Kind::number);
  if (o.kind == Operand::Kind::input) {
    if (input_group_[i] >= 0) return mix(Kind::input_of_limb, static_cast<std::uint64_t>(input_group_[i]));
    if (input_is_number_[i]) return mix(Kind::number);
    return likeness == Likeness::equal ? mix(Kind::other_input, i) : mix(Kind::any_shared);
  }
  if (likeness == Likeness::equal) return equal_[i];
  if (likeness == Likeness::similar || !std::has_single_bit(limbs_[i])) return similar_[i];
  const Statement& s = program_.statements[i];
  return mix(is_sum(s.op) ? static_cast<std::uint64_t>(Kind::sum) : of_operation(s.op));
}

std::vector<Tuple> Correspondence::match(std::vector<std::vector<Operand>>& lists) const {
  struct Candidate {
    std::uint64_t hash;
    bool is_taken;
  };
  std::vector<Tuple> tuples;
  std::vector<Candidate> candidates;  // of all limbs, one after the other
  std::vector<std::size_t> ends(lists.size()), places(lists.size());
  for (const Likeness likeness : {Likeness::equal, Likeness::similar, Likeness::kind}) {
    if (std::any_of(lists.begin(), lists.end(), [](const auto& list) { return list.empty(); })) break;
    candidates.clear();
    for (std::size_t lane = 0; lane < lists.size(); ++lane) {
      for (const Operand& o : lists[lane]) candidates.push_back({hash(o, likeness), false});
      ends[lane] = candidates.size();
    }
    const auto begin = [&](std::size_t lane) { return lane == 0 ? 0 : ends[lane - 1]; };
    for (std::size_t k = 0; k < ends[0]; ++k) {
      const std::uint64_t wanted = candidates[k].hash;
      bool everywhere = true;
      for (std::size_t lane = 0; everywhere && lane < lists.size(); ++lane) {
        std::size_t place = begin(lane);
        while (place < ends[lane] && (candidates[place].is_taken || candidates[place].hash != wanted)) ++place;
        everywhere = place < ends[lane];
        places[lane] = place;
      }
      if (!everywhere) continue;
      Tuple& tuple = tuples.emplace_back();
      tuple.reserve(lists.size());
      for (std::size_t lane = 0; lane < lists.size(); ++lane) {
        tuple.push_back(lists[lane][places[lane] - begin(lane)]);
        candidates[places[lane]].is_taken = true;
      }
    }
    for (std::size_t lane = 0; lane < lists.size(); ++lane) {
      std::size_t k = begin(lane);
      std::erase_if(lists[lane], [&](const Operand&) { return candidates[k++].is_taken; });
    }
  }
  return tuples;
}

}  // namespace robcogen::pass
