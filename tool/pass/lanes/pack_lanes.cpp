#include "pass/lanes/pack_lanes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "pass/lanes/lane_program.h"
#include "pass/lanes/plan_signs.h"
#include "support/index.h"
#include "symbolic/cost.h"

namespace robcogen::pass {
namespace {

using symbolic::is_clearly_faster;
using symbolic::Operand;
using symbolic::predicted_time;
using symbolic::Program;
using symbolic::Statement;

// The program with these classes in lanes; nullopt if values would depend on each other, or if some have lanes already.
std::optional<Program> with_lanes(const Program& program, const std::vector<InputTuples>& classes) {
  if (program.has_lanes()) return std::nullopt;
  LaneBuilder builder(program);
  const std::optional<LanePlan> plan = lane_plan(program, classes, builder.constant(symbolic::Constant()));
  if (!plan) return std::nullopt;
  return lane_program(program, *plan, plan_signs(*plan), builder);
}

bool can_be_lanes(const InputTuples& limbs) {
  const std::size_t width = limbs.empty() ? 0 : limbs.front().size();
  return width == 2 || width == 4 || width == at(kMaxLanes);
}

// Which input elements the program reads, by flat index.
std::vector<bool> inputs_read(const Program& program) {
  std::vector<bool> read(at(program.input_count()), false);
  const auto note = [&](const Operand& o) {
    if (o.kind == Operand::Kind::input) read[at(o.index)] = true;
  };
  for (const Statement& s : program.statements) for_each_operand(s, note);
  for (const symbolic::OutputArray& array : program.outputs)
    std::for_each(array.values.begin(), array.values.end(), note);
  return read;
}

// A program that reads one limb only, such as a transform, computes nothing twice.
bool reads_two(const std::vector<bool>& read, const InputTuples& limbs) {
  std::size_t lanes = 0;
  for (std::size_t lane = 0; lane < limbs.front().size(); ++lane)
    lanes +=
        std::any_of(limbs.begin(), limbs.end(), [&](const std::vector<int>& tuple) { return read[at(tuple[lane])]; });
  return lanes >= 2;
}

}  // namespace

bool reads_congruent_limbs(const Program& program, const std::vector<InputTuples>& classes) {
  const std::vector<bool> read = inputs_read(program);
  return std::any_of(classes.begin(), classes.end(), [&](const InputTuples& limbs) {
    return can_be_lanes(limbs) && reads_two(read, limbs);
  });
}

Program packed(const Program& program, const std::vector<InputTuples>& classes) {
  std::vector<InputTuples> with_inputs;
  std::copy_if(classes.begin(), classes.end(), std::back_inserter(with_inputs), can_be_lanes);
  return with_lanes(program, with_inputs).value_or(program);
}

Program with_plain_numbers(const Program& program) {
  Program result = program;
  result.constants.clear();
  std::vector<int> place;
  for (const symbolic::Constant& c : program.constants) {
    const symbolic::Constant plain = c.number();
    const auto known = std::find(result.constants.begin(), result.constants.end(), plain);
    place.push_back(static_cast<int>(known - result.constants.begin()));
    if (known == result.constants.end()) result.constants.push_back(plain);
  }
  const auto renumber = [&](Operand& o) {
    if (is_constant(o)) o.index = place[at(o.index)];
  };
  for (Statement& s : result.statements) for_each_operand(s, renumber);
  for (symbolic::OutputArray& array : result.outputs) std::for_each(array.values.begin(), array.values.end(), renumber);
  return result;
}

// Packs all classes at once; if that does not pay, one class after the other, as long as one of them adds a gain.
std::optional<Packed> pack_lanes_within(const Program& program, const std::vector<InputTuples>& classes, int time) {
  const std::vector<bool> none(classes.size(), false);
  Packed best = {{}, none};
  std::vector<bool> all;
  const std::vector<bool> read = inputs_read(program);
  for (const InputTuples& limbs : classes) all.push_back(can_be_lanes(limbs) && reads_two(read, limbs));
  if (all == none) return std::nullopt;
  const auto attempt = [&](const std::vector<bool>& in_lanes) {
    std::vector<InputTuples> chosen;
    for (std::size_t c = 0; c < classes.size(); ++c)
      if (in_lanes[c]) chosen.push_back(classes[c]);
    std::optional<Program> candidate = with_lanes(program, chosen);
    if (!candidate) return false;
    const int candidate_time = predicted_time(*candidate);
    if (!is_clearly_faster(candidate_time, time)) return false;
    time = candidate_time;
    best = {std::move(*candidate), in_lanes};
    return true;
  };
  if (attempt(all)) return best;
  std::size_t in_vain = 0;  // classes since the last gain
  for (std::size_t c = 0; in_vain < classes.size(); c = (c + 1) % classes.size()) {
    ++in_vain;
    std::vector<bool> more = best.in_lanes;
    more[c] = all[c];
    if (more != best.in_lanes && more != all && attempt(more)) in_vain = 0;
  }
  if (best.in_lanes == none) return std::nullopt;
  return best;
}

Packed pack_lanes(
    const Program& program,
    const std::vector<InputTuples>& classes,
    const std::optional<Program>& congruent) {
  const int time = predicted_time(program);
  std::optional<Packed> best = pack_lanes_within(program, classes, time);
  if (congruent) {
    std::optional<Packed> other = pack_lanes_within(with_plain_numbers(*congruent), classes, time);
    if (other && (!best || predicted_time(other->program) < predicted_time(best->program))) best = std::move(other);
  }
  if (best) return std::move(*best);
  return {program, std::vector<bool>(classes.size(), false)};
}

}  // namespace robcogen::pass
