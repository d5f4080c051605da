// Reads elements of SDF as names, numbers and poses.
#pragma once

#include <array>
#include <string>

#include "import/sdf/document.h"
#include "import/snap_angles.h"

namespace robcogen::import::from_sdf {

// A pose, and the frame in which the file gives it; an empty name is the default of the element.
struct ReadPose {
  Pose pose;
  Name relative_to;
};

class ElementReader {
 public:
  ElementReader(AngleSnapper& snapper, Diagnostics& diagnostics)
      : snapper_(snapper), diagnostics_(diagnostics), values_(diagnostics) {}

  Diagnostics& diagnostics() const { return diagnostics_; }

  // Returns the first child of this name; nullptr if there is none. Warns about further ones.
  const Element* child(const Element& element, const std::string& name) const;
  // Reports a missing child.
  const Element* require_child(const Element& element, const std::string& name) const;

  // Reads the attribute `name`. Reports a missing or empty one, and one that SDF reserves.
  Name name(const Element& element) const;
  // Reads a name that an attribute, or the text of an element, refers to. Empty if there is none.
  static Name reference(const Element& element, const char* attribute);
  static Name reference(const Element& element);

  // Reads the text of a child. Returns `otherwise` if the child is missing, or, with a warning, if it is empty.
  bool flag(const Element& element, const char* child, bool otherwise) const;
  Number number(const Element& element, const char* child, const Number& otherwise = Number());
  // As above; infinite values are allowed, and those from 1e9 on are infinite.
  double limit(const Element& element, const char* child, double otherwise);

  // Reads the text of the element. Reports a direction that is zero.
  std::array<Number, 3> direction(const Element& element, const std::string& owner);
  std::array<Number, 3> triple(const Element& element);

  // Reads the child `pose`; the identity if there is none. `owner` is for messages: `link 'hip'`.
  ReadPose pose(const Element& element, const std::string& owner);

 private:
  AngleSnapper& snapper_;
  Diagnostics& diagnostics_;
  xml::Values values_;

  const Element* child_with_value(const Element& element, const char* name) const;
  bool flag(const Attribute& value, bool otherwise) const;
  Rotation rotation(const Element& pose, const std::vector<Number>& values, const std::string& owner);
};

}  // namespace robcogen::import::from_sdf
