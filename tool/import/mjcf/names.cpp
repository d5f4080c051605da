#include <fmt/format.h>

#include "import/identifier.h"
#include "import/mjcf/describe.h"
#include "import/xml/namer.h"
#include "support/unique_names.h"

namespace robcogen::import::from_mjcf {

namespace {

class ModelNamer {
 public:
  ModelNamer(const Document& document, Diagnostics& diagnostics) : document_(document), namer_(diagnostics) {}

  // Names in the file are assigned first, so that generated names avoid them.
  Identifiers name() {
    Identifiers result;
    result.robot = identifier(document_.name.text.empty() ? "robot" : document_.name.text);
    namer_.check_length("model", document_.name);
    result.bodies.resize(document_.bodies.size());
    result.joints.resize(document_.bodies.size());
    result.sites.resize(document_.bodies.size());
    for (const bool is_named : {true, false}) {
      for (std::size_t b = 0; b < document_.bodies.size(); ++b) {
        const Name& body = document_.bodies[b].name;
        if (body.text.empty() == is_named) continue;
        result.bodies[b] = namer_.element("body", body, is_named ? body.text : fmt::format("body_{}", b), "", elements_);
        frames_.reserve(result.bodies[b]);
      }
    }
    for (const bool is_named : {true, false}) {
      for (std::size_t b = 0; b < document_.bodies.size(); ++b) {
        const Body& body = document_.bodies[b];
        result.joints[b].resize(body.joints.size());
        result.sites[b].resize(body.sites.size());
        const auto set = [&](const char* kind, const Name& own, auto& taken, std::string& identifier) {
          if (own.text.empty() == is_named) return;
          const std::string made = result.bodies[b] + "_" + kind;
          identifier = namer_.element(kind, own, is_named ? own.text : made, is_named ? std::string("_") + kind : "", taken);
        };
        for (std::size_t j = 0; j < body.joints.size(); ++j)
          set("joint", body.joints[j].name, elements_, result.joints[b][j]);
        for (std::size_t s = 0; s < body.sites.size(); ++s)
          set("site", body.sites[s].name, frames_, result.sites[b][s]);
      }
    }
    namer_.mention_changes();
    return result;
  }

 private:
  const Document& document_;
  xml::Namer namer_;
  UniqueNames elements_;  // bodies and joints
  UniqueNames frames_;    // bodies and sites
};

}  // namespace

Identifiers identifiers_of(const Document& document, Diagnostics& diagnostics) {
  return ModelNamer(document, diagnostics).name();
}

}  // namespace robcogen::import::from_mjcf
