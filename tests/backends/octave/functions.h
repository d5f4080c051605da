// A library's function as Octave sees it.
#pragma once

#include <optional>

#include "backend/library.h"
#include "calls.h"
#include "driver/driver.h"

namespace robcogen::octave {

inline const std::string kNone = "none";

// Loads the library of a robot with these groups, or of a document of motions or transforms; nullopt if the document
// has errors. `desired` may be kNone; `primitives` is kNone, left or right; `derivatives` are values of --derivatives.
std::optional<backend::Library> load(
    const std::filesystem::path& model,
    const std::string& desired,
    const std::string& name,
    const std::string& primitives,
    const std::vector<std::string>& groups,
    const driver::Steps& steps,
    const std::vector<std::string>& derivatives = {});

// Returns the name of the function in the package, its arguments and its results, without an evaluator.
Call shape(const backend::Library& library, const backend::Function& function);

// Returns the same for the product of primitives as which a homogeneous transform is also printed; nullopt if there is
// none.
std::optional<Call> shape_of_product(const backend::Library& library, const backend::Function& function);

// True if the base is fixed, the last argument is gravity, and no overload omits it.
bool may_omit_gravity(const backend::Library& library, const backend::Function& function);

}  // namespace robcogen::octave
