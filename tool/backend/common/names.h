// Identifiers of generated text: legal, free of a language's reserved words, and unique in their scope.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/name_table.h"

namespace robcogen::backend {

// Whether the language reserves the name.
using IsReserved = bool (*)(const std::string& name);

// For languages that reserve no names.
inline bool is_free(const std::string&) {
  return false;
}

// The nearest legal identifier: illegal characters become '_', leading and double underscores vanish, a reserved word
// gets a final '_'. A name that is legal already comes back unchanged.
std::string identifier(const std::string& wanted, IsReserved is_reserved);

// Shortens a name to at most `limit` characters: the middle is cut, because the ends say most about the meaning.
std::string shortened(const std::string& name, std::size_t limit, IsReserved is_reserved);

// Identifiers taken in one scope.
class NameScope {
 public:
  explicit NameScope(IsReserved reserved, const std::vector<std::string>& taken = {});

  // Marks the name as taken; true if it was free.
  bool take(const std::string& name);
  // The identifier for `wanted`, numbered (`foot_2`) when it is taken.
  std::string claim(const std::string& wanted);
  IsReserved is_reserved() const { return is_reserved_; }

 private:
  IsReserved is_reserved_;
  NameTable<int> uses_;
};

// One identifier for each name. Names that are legal as they stand keep their spelling, even if an identifier that
// comes before them would be the same.
std::vector<std::string> claim_all(NameScope& scope, std::vector<std::string> wanted);
// The same in a new scope, for example that of the members of a structure.
std::vector<std::string> claim_all(const std::vector<std::string>& wanted, IsReserved is_reserved);

// `transforms.homogeneous` for `transforms::homogeneous`.
std::string dotted(const std::string& scope);

// `a/b/hyl` for `hyl` in `a::b`, which may be empty.
std::string scoped(const std::string& enclosing, const std::string& name, const std::string& between);
// `a_b_hyl` for `hyl` in `a::b`, which may be empty.
std::string flat(const std::string& enclosing, const std::string& name);

}  // namespace robcogen::backend
