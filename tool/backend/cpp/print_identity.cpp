#include "backend/common/identity.h"

#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {

std::string identity_reference(const Api& api, const std::string& header) {
  const std::string name = name_of_model(*api.library);
  const std::string reference = in_namespace(
      api.space + "::identity", comment(kTwoModels) + "extern const char " + name +
                                    ";\n[[gnu::used]] static const char* const of_" + header + " = &" + name + ";\n");
  return std::string("#ifdef ") + kRefersToModel + "\n\n" + reference + "\n#endif  // " + kRefersToModel + "\n";
}

std::string identity_definition(const Api& api, const std::string& group) {
  std::string text;
  for (const std::string& name : identity_names(*api.library, group)) text += "extern const char " + name + " = 0;\n";
  return in_namespace(api.space + "::identity", text);
}

}  // namespace robcogen::backend::cpp
