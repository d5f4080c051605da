#include "backend/c/printers.h"
#include "backend/common/identity.h"

namespace robcogen::backend::c {
namespace {

// With two underscores, the names are not those of functions.
std::string name_of_model(const Names& names) {
  return names.prefix + "_c__model_" + identity(names.library);
}

std::string name_of_only_one(const Names& names) {
  return names.prefix + "_c__" + kOnlyOne;
}

}  // namespace

std::string identity_reference(const Names& names) {
  return comment("A program with two models of this name does not link: give one of them another NAME or NAMESPACE.") +
         "#ifdef " + kRefersToModel + "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\nextern const char " +
         name_of_model(names) + ";\n__attribute__((used)) static const char *const " + names.prefix +
         "_c__model_of_functions = &" + name_of_model(names) + ";\n#ifdef __cplusplus\n}\n#endif\n#endif\n";
}

std::string identity_definition(const Names& names, const std::string& group) {
  if (group != group_of_identity(names.library)) return "";
  std::string text;
  for (const std::string& name : {name_of_model(names), name_of_only_one(names)})
    text += "\nextern const char " + name + ";\nconst char " + name + " = 0;\n";
  return text;
}

}  // namespace robcogen::backend::c
