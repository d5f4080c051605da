#include "backend/common/identity.h"

#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

std::string space_of(const Api& api) {
  return api.space + "::identity";
}

}  // namespace

std::string identity_reference(const Api& api, const std::string& header) {
  const std::string name = "model_" + identity(*api.library);
  const std::string reference = in_namespace(
      space_of(api),
      comment("A program with two models of this name does not link: give one of them another NAME or NAMESPACE.") +
          "extern const char " + name + ";\n[[gnu::used]] static const char* const of_" + header + " = &" + name +
          ";\n");
  return std::string("#ifdef ") + kRefersToModel + "\n\n" + reference + "\n#endif  // " + kRefersToModel + "\n";
}

std::string identity_definition(const Api& api, const std::string& group) {
  if (group != group_of_identity(*api.library)) return "";
  return in_namespace(
      space_of(api),
      "extern const char model_" + identity(*api.library) + " = 0;\nextern const char " + kOnlyOne + " = 0;\n");
}

}  // namespace robcogen::backend::cpp
