#include "pass/split_angles.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "pass/read_angles.h"
#include "pass/statements.h"
#include "support/index.h"
#include "support/parallel.h"

namespace robcogen::pass {
namespace {

using symbolic::InputArray;
using symbolic::Op;
using symbolic::Operand;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;
using symbolic::Statement;

// The program with sines and cosines as inputs after the joint positions. It is rewritten statement by statement, so
// that it rounds as the program does.
class Core {
 public:
  Core(const Program& program, const Readings& readings, const InputArray& sines, const InputArray& cosines)
      : program_(program), readings_(readings), sines_(sines), cosines_(cosines) {
    const InputPlace q = place_of(program, Role::joint_position);
    behind_ = static_cast<std::size_t>(q.array - program.inputs.data()) + 1;
    end_ = q.begin + q.size();
  }

  Program run() {
    Program core = program_;
    for (std::size_t i = 0; i < core.statements.size(); ++i) {
      Statement& s = core.statements[i];
      if (!readings_[i].empty() && s.width > 1)
        s = gathered(i);
      else
        for_each_operand(s, [&](Operand& o) { move(o); });
    }
    for (OutputArray& array : core.outputs)
      for (Operand& o : array.values) move(o);
    core.inputs.insert(core.inputs.begin() + static_cast<std::ptrdiff_t>(behind_), {sines_, cosines_});
    return eliminate_dead_code(std::move(core));
  }

 private:
  int count() const { return static_cast<int>(sines_.elements.size()); }

  void move(Operand& o) const {
    if (o.kind == Operand::Kind::input && o.index >= end_) o.index += 2 * count();
    if (!is_statement(o) || readings_[at(o.index)].empty()) return;
    const bool is_whole = program_.statements[at(o.index)].width > 1 && o.lane < 0;
    if (!is_whole) o = input(at(o.index), at(std::max(o.lane, 0)), o.negative);
  }

  // The input that replaces a sine or cosine in this lane.
  Operand input(std::size_t statement, std::size_t lane, bool negative) const {
    const Reading& reading = readings_[statement][lane];
    const bool is_cosine = program_.statements[statement].op == Op::cosine;
    const int element = end_ + reading.angle + (is_cosine ? count() : 0);
    return {Operand::Kind::input, element, negative != (reading.negative && !is_cosine)};
  }

  Statement gathered(std::size_t i) {
    const Statement& old = program_.statements[i];
    Statement s;
    s.op = Op::gather;
    s.section = old.section;
    s.width = old.width;
    for (std::size_t lane = 0; lane < readings_[i].size(); ++lane) s.lanes.push_back(input(i, lane, false));
    return s;
  }

  const Program& program_;
  const Readings& readings_;
  const InputArray &sines_, &cosines_;
  std::size_t behind_ = 0;  // the array after the joint positions
  int end_ = 0;             // the element after them
};

std::set<int> angles_read(const Readings& readings) {
  std::set<int> read;
  for (const auto& lanes : readings)
    for (const Reading& reading : lanes) read.insert(reading.angle);
  return read;
}

}  // namespace

SplitAngles split_angles(const std::vector<WithLanes>& programs, const std::vector<Position>& positions) {
  InputArray parameters;
  for (const WithLanes& p : programs)
    if (const InputPlace place = place_of(p.program, Role::parameters); place.array) parameters = *place.array;
  AngleTable angles(parameters, positions);
  std::vector<Readings> readings, readings_in_lanes;
  for (const WithLanes& p : programs) readings.push_back(read_angles(p.program, angles));
  for (const WithLanes& p : programs)
    readings_in_lanes.push_back(p.in_lanes ? read_angles(*p.in_lanes, angles) : Readings());

  SplitAngles result;
  result.angle_count = angles.count();
  const InputArray sines = angles.sines(), cosines = angles.cosines();
  result.cores.resize(programs.size());
  for_each_index(programs.size(), [&](std::size_t i) {
    std::optional<symbolic::Core>& core = result.cores[i];
    std::set<int> read = angles_read(readings[i]);
    read.merge(angles_read(readings_in_lanes[i]));
    if (read.empty()) return;
    const auto& [program, in_lanes] = programs[i];
    core.emplace();
    core->program = Core(program, readings[i], sines, cosines).run();
    if (in_lanes) core->in_lanes = Core(*in_lanes, readings_in_lanes[i], sines, cosines).run();
    core->read = {read.begin(), read.end()};
    core->angles = angles.program("angles_" + program.name, core->read);
  });
  std::vector<int> all;
  for (int k = 0; k < angles.count(); ++k) all.push_back(k);
  result.angles = angles.program("joint_trigonometry", all);
  result.addition = angles.addition("joint_trigonometry_given");
  return result;
}

}  // namespace robcogen::pass
