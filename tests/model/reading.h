// Reads documents from files and texts into models.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "../golden_messages.h"
#include "import/kinematics.h"
#include "import/parts.h"

namespace robcogen::test {

inline std::optional<model::KinematicTree> tree_of(
    const std::shared_ptr<const Source>& text,
    Diagnostics& diagnostics) {
  const auto read = import::robot_document(text, {}, diagnostics);
  return read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
}

inline std::optional<model::KinematicTree> tree_of(const std::string& text, Diagnostics& diagnostics) {
  return tree_of(std::make_shared<Source>("test.kindsl", text), diagnostics);
}

}  // namespace robcogen::test
