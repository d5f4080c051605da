#include "backend/common/line_plan.h"

#include <algorithm>
#include <utility>

#include "support/index.h"
#include "symbolic/stages.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

class LinePlanner {
 public:
  LinePlanner(const Program& program, const Dialect& dialect) : program_(program), dialect_(dialect) {
    std::size_t elements = 0;
    for (const symbolic::InputArray& array : program.inputs) elements += array.elements.size();
    plan_.inputs_used.resize(elements, false);
    plan_.places.resize(program.statements.size(), Place::nowhere);
    plan_.users.resize(program.statements.size(), -1);
    plan_.stores.resize(program.statements.size());
    if (dialect.stores) plan_.blocks = block_plan(program);
  }

  LinePlan run() {
    find_uses();
    share_angles_of_lanes();
    find_pairs_of_sums();
    find_angles_together();
    return std::move(plan_);
  }

 private:
  const Program& program_;
  const Dialect& dialect_;
  LinePlan plan_;

  const Statement& statement(std::size_t i) const { return program_.statements[i]; }

  void find_uses() {
    std::vector<int> uses(plan_.places.size(), 0);        // by statements that are needed themselves
    std::vector<bool> apart(plan_.places.size(), false);  // a lane of it is read, or it is spread to all lanes
    const auto use = [&](const Operand& o, int user) {
      if (o.kind == Operand::Kind::input) plan_.inputs_used[at(o.index)] = true;
      if (!is_statement(o)) return;
      ++uses[at(o.index)];
      plan_.users[at(o.index)] = user;
      const Statement& reader = statement(at(user));
      if (o.lane >= 0 ||
          (reader.op != Op::gather && reader.op != Op::sum_lanes && reader.width != width_of(program_, o)))
        apart[at(o.index)] = true;
    };
    for (std::size_t p = 0; p < program_.outputs.size(); ++p) {
      const std::vector<Operand>& values = program_.outputs[p].values;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Operand& o = values[k];
        if (o.kind == Operand::Kind::input) plan_.inputs_used[at(o.index)] = true;
        if (is_statement(o) && o != symbolic::kNotWritten && !plan_.is_in_block(p, k))
          plan_.stores[at(o.index)].push_back({p, k, o.negative, o.lane});
      }
    }
    for (std::size_t i = plan_.places.size(); i-- > 0;) {
      const bool is_column = dialect_.stores && plan_.blocks.is_column[i];
      if (uses[i] == 0 && plan_.stores[i].empty() && !is_column) continue;
      const Statement& s = statement(i);
      note_width(s.width);
      if (const auto column = plan_.blocks.loaded.find(i); column != plan_.blocks.loaded.end()) {
        plan_.places[i] = Place::loaded;
        continue;
      }
      for_each_operand(s, [&](const Operand& o) { use(o, static_cast<int>(i)); });
      plan_.places[i] =
          (apart[i] || is_column) && !is_angle_function(s.op) ? Place::own : place(i, uses[i], plan_.users[i]);
      if (plan_.places[i] == Place::angle) note_angle(i);
    }
  }

  // Consecutive sums of lanes are defined two at a time.
  void find_pairs_of_sums() {
    const auto is_sum_of_lanes = [&](std::size_t i) {
      return statement(i).op == Op::sum_lanes && plan_.places[i] != Place::nowhere;
    };
    for (std::size_t i = 0; i + 1 < plan_.places.size(); ++i) {
      if (!is_sum_of_lanes(i) || !is_sum_of_lanes(i + 1)) continue;
      const Operand &a = statement(i).a, &b = statement(i + 1).a;
      if (width_of(program_, a) != width_of(program_, b)) continue;
      plan_.places[i] = Place::sums;
      plan_.places[i + 1] = Place::summed;
      if (plan_.users[at(b.index)] == static_cast<int>(i + 1)) plan_.users[at(b.index)] = static_cast<int>(i);
      ++i;
    }
  }

  void note_width(int width) {
    std::vector<int>& widths = plan_.widths;
    const auto place = std::lower_bound(widths.begin(), widths.end(), width);
    if (width > 1 && (place == widths.end() || *place != width)) widths.insert(place, width);
  }

  Place place(std::size_t i, int uses, int user) const {
    const Statement& s = statement(i);
    if (is_angle_function(s.op)) return Place::angle;
    const std::vector<Store>& stores = plan_.stores[i];
    const bool one_sign = std::all_of(
        stores.begin(), stores.end(), [&](const Store& store) { return store.negative == stores.front().negative; });
    if (dialect_.stores && uses == 0 && one_sign && stores.size() <= 2 && s.width == 1) return Place::output;
    if (uses != 1 || !stores.empty() || s.named) return Place::own;
    // A sine and a cosine may share this argument, and it must have one definite type.
    const Statement& u = statement(at(user));
    if (is_angle_function(u.op)) return Place::own;
    if (s.op == Op::gather && u.op == Op::gather) return Place::own;
    // A statement stays with the others of its link, but a product always moves to where it can be fused.
    const bool fusable = s.op == Op::multiply && is_sum(u.op);
    return fusable || s.section == u.section ? Place::inside : Place::own;
  }

  void note_angle(std::size_t i) {
    const Statement& s = statement(i);
    Angle& angle = plan_.angles[key_of(s.a)];
    angle.first = static_cast<int>(i);  // statements are visited last to first
    (s.op == Op::sine ? angle.sine : angle.cosine) = true;
    if (s.width > 1) angle.sine = angle.cosine = true;  // for lanes, only both together exist
  }

  // If the sine and cosine of all lanes of a value exist, a single lane takes its own from these.
  void share_angles_of_lanes() {
    std::map<AngleKey, Angle>& angles = plan_.angles;
    for (auto angle = angles.begin(); angle != angles.end();) {
      const AngleKey& key = angle->first;
      const auto whole = key.lane < 0 ? angles.end() : angles.find({key.kind, key.index});
      if (whole == angles.end()) {
        ++angle;
        continue;
      }
      whole->second.first = std::min(whole->second.first, angle->second.first);
      angle = angles.erase(angle);
    }
  }

  // Decides whether sines and cosines of inputs are computed together. They must belong to one array and include most
  // of the elements between the first and the last.
  void find_angles_together() {
    std::vector<int> angles;
    for (const auto& [key, angle] : plan_.angles)
      if (key.kind == Operand::Kind::input) angles.push_back(key.index);
    if (dialect_.angles_together == 0 || angles.size() < dialect_.angles_together) return;
    const std::size_t count = at(angles.back() - angles.front()) + 1;
    std::size_t end = 0;
    for (const symbolic::InputArray& array : program_.inputs) {
      end += array.elements.size();
      if (at(angles.front()) < end) break;
    }
    if (at(angles.back()) >= end || count > 2 * angles.size()) return;
    plan_.first_together = angles.front();
    plan_.together = count;
    for (auto& [key, angle] : plan_.angles)
      if (key.kind == Operand::Kind::input) angle.sine = angle.cosine = true;
  }
};

}  // namespace

LinePlan line_plan(const Program& program, const Dialect& dialect) {
  return LinePlanner(program, dialect).run();
}

bool is_angle_function(Op op) {
  return op == Op::sine || op == Op::cosine;
}

}  // namespace robcogen::backend
