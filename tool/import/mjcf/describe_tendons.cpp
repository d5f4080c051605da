// Springs and dampers of fixed tendons.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "import/identifier.h"
#include "import/mjcf/describe_loops.h"
#include "support/unique_names.h"

namespace robcogen::import::from_mjcf {

namespace {

class TendonDescriber {
 public:
  TendonDescriber(
      const Document& document,
      const Identifiers& identifiers,
      model::Description& description,
      Diagnostics& diagnostics)
      : document_(document), identifiers_(identifiers), description_(description), diagnostics_(diagnostics) {}

  void add(const Tendon& tendon) {
    std::vector<std::vector<Found>> joints;  // by term: the joint, or its copies
    for (const Tendon::Term& term : tendon.terms) {
      joints.push_back(find(term.joint));
      if (joints.back().empty()) return;
    }
    if (joints.empty()) return;
    // A tendon between copies is a copy itself.
    const auto copied = std::find_if(joints.begin(), joints.end(), [](const auto& found) { return found.size() > 1; });
    for (const Found& copy : copied == joints.end() ? joints.front() : *copied) {
      std::vector<Found> of_copy;
      for (const std::vector<Found>& found : joints) of_copy.push_back(same_copy(found, copy));
      add(tendon, of_copy);
    }
  }

 private:
  struct Found {
    const Joint* joint = nullptr;
    std::string name;
    bool is_part = false;  // of the robot
  };

  const Document& document_;
  const Identifiers& identifiers_;
  model::Description& description_;
  Diagnostics& diagnostics_;
  UniqueNames names_;

  static Found same_copy(const std::vector<Found>& found, const Found& copy) {
    const auto is_same = [&](const Found& f) { return f.joint->written.suffix == copy.joint->written.suffix; };
    const auto same = std::find_if(found.begin(), found.end(), is_same);
    return same == found.end() ? found.front() : *same;
  }

  std::vector<Found> find(const Name& name) {
    std::vector<Found> found;
    std::vector<std::string> names;
    for (std::size_t b = 0; b < document_.bodies.size(); ++b)
      for (std::size_t j = 0; j < document_.bodies[b].joints.size(); ++j) {
        const Joint& joint = document_.bodies[b].joints[j];
        if (is_named(joint, name.text)) found.push_back({&joint, identifiers_.joints[b][j], document_.robot.has[b]});
        if (!joint.name.text.empty()) names.push_back(joint.name.text);
      }
    if (found.empty())
      diagnostics_.error("coupled-joint", name.place, fmt::format("joint '{}' is not declared", name.text)).hint =
          did_you_mean(name.text, names);
    return found;
  }

  void add(const Tendon& tendon, const std::vector<Found>& joints) {
    const auto inside = std::count_if(joints.begin(), joints.end(), [](const Found& f) { return f.is_part; });
    if (inside == 0) return;
    const std::string label = tendon.name.text.empty() ? "this tendon" : fmt::format("tendon '{}'", tendon.name.text);
    if (inside < static_cast<std::ptrdiff_t>(joints.size())) {
      diagnostics_.warning(
          "tendon-forces", tendon.name.place,
          fmt::format("the force of {} is ignored: one of its joints is not part of the robot", label));
      return;
    }
    model::DescribedTendon described;
    described.name = names_.add(tendon.name.text.empty() ? "tendon" : identifier(tendon.name.text));
    described.place = tendon.name.place;
    described.stiffness = quantity(tendon.stiffness);
    described.damping = quantity(tendon.damping);
    described.stiffness_place = tendon.stiffness_place;
    described.damping_place = tendon.damping_place;
    Number length;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const Number& factor = tendon.terms[k].factor;
      length = length + factor * joints[k].joint->spring_reference;
      described.terms.push_back({joints[k].name, quantity(factor), tendon.terms[k].joint.place});
    }
    described.rest = tendon.stiffness.is_zero() ? model::Quantity() : quantity(tendon.rest.value_or(length));
    description_.tendons.push_back(std::move(described));
  }
};

}  // namespace

void add_tendons(
    const Document& document,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics) {
  TendonDescriber describer(document, identifiers, description, diagnostics);
  for (const Tendon& tendon : document.tendons)
    if (tendon.has_force()) describer.add(tendon);
}

}  // namespace robcogen::import::from_mjcf
