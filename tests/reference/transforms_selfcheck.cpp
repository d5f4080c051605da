// The self-check of one generated library of coordinate transforms: over random values of its variables and parameters,
// against the products that its document says, and against identities between transforms. Compiled once per library,
// with
//     ROBCOGEN_REFLECTION_HEADER      the generated header, as <…>
//     ROBCOGEN_TRANSFORMS_NAMESPACE   the namespace of the generated code
//
//     euler_selfcheck [--seed N] [--samples N]
//
// prints one line per check, and exits with 1 if one failed, 2 if the command line is wrong.
#include ROBCOGEN_REFLECTION_HEADER

#include "robcogen/reference/check_transforms.h"
#include "robcogen/reference/command_line.h"

int main(int argc, char** argv) {
  namespace generated = ROBCOGEN_TRANSFORMS_NAMESPACE;
  const std::optional<robcogen::reference::CommandLine> options = robcogen::reference::command_line(argc, argv);
  if (!options) return 2;
  const robcogen::reflection::Transforms& model = generated::reflection::model;
  std::printf(
      "%s: seed %llu, %d samples\n", model.name, static_cast<unsigned long long>(options->seed), options->samples);
  const robcogen::reference::Checks checks =
      robcogen::reference::check_transforms(model, options->seed, options->samples);
  std::printf("%s%d checks, %d failed\n", checks.report().c_str(), checks.size(), checks.failures());
  return checks.failures() == 0 ? 0 : 1;
}
