#include "backend/c/printers.h"
#include "backend/common/identity.h"

namespace robcogen::backend::c {

// With two underscores, the names are not those of functions.
std::string identity_reference(const Names& names) {
  const std::string start = names.prefix + "_c__", model = start + name_of_model(names.library);
  return comment(kTwoModels) + "#ifdef " + kRefersToModel +
         "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\nextern const char " + model +
         ";\n__attribute__((used)) static const char *const " + start + "model_of_functions = &" + model +
         ";\n#ifdef __cplusplus\n}\n#endif\n#endif\n";
}

std::string identity_definition(const Names& names, const std::string& group) {
  std::string text;
  for (const std::string& wanted : identity_names(names.library, group)) {
    const std::string name = names.prefix + "_c__" + wanted;
    text += "\nextern const char " + name + ";\nconst char " + name + " = 0;\n";
  }
  return text;
}

}  // namespace robcogen::backend::c
