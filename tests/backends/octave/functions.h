// A function of a library as Octave sees it.
#pragma once

#include <optional>

#include "backend/library.h"
#include "calls.h"
#include "driver/driver.h"

namespace robcogen::octave {

inline const std::string kNone = "none";

// The library of a robot with these groups, or of a document of motions or transforms; nullopt when it is wrong.
// `desired` may be kNone, `primitives` is kNone, left or right, `derivatives` are those of --derivatives.
std::optional<backend::Library> load(
    const std::filesystem::path& model,
    const std::string& desired,
    const std::string& name,
    const std::string& primitives,
    const std::vector<std::string>& groups,
    const driver::Steps& steps,
    const std::vector<std::string>& derivatives = {});

// The function's package name, arguments and results; nothing that evaluates it.
Call shape(const backend::Library& library, const backend::Function& function);

// The same for the product of primitives that a homogeneous transform is printed as, too; nullopt when it is not.
std::optional<Call> shape_of_product(const backend::Library& library, const backend::Function& function);

// Whether the base is fixed, the last argument is gravity, and no overload does without it.
bool may_omit_gravity(const backend::Library& library, const backend::Function& function);

}  // namespace robcogen::octave
