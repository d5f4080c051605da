#include <fmt/format.h>

#include "import/identifier.h"
#include "import/mjcf/describe.h"
#include "support/unique_names.h"

namespace robcogen::import::from_mjcf {

namespace {

constexpr std::size_t kMaxNameLength = 255;  // of a robot document

class Namer {
 public:
  Namer(const Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  // Names in the file are assigned first, so that generated names avoid them.
  Identifiers name() {
    Identifiers result;
    result.robot = identifier(document_.name.text.empty() ? "robot" : document_.name.text);
    check_length("model", document_.name);
    result.bodies.resize(document_.bodies.size());
    result.joints.resize(document_.bodies.size());
    result.sites.resize(document_.bodies.size());
    for (const bool is_named : {true, false}) {
      for (std::size_t b = 0; b < document_.bodies.size(); ++b) {
        const Name& body = document_.bodies[b].name;
        if (body.text.empty() == is_named) continue;
        result.bodies[b] = element("body", body, is_named ? body.text : fmt::format("body_{}", b), "", elements_);
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
          identifier = element(kind, own, is_named ? own.text : made, is_named ? std::string("_") + kind : "", taken);
        };
        for (std::size_t j = 0; j < body.joints.size(); ++j)
          set("joint", body.joints[j].name, elements_, result.joints[b][j]);
        for (std::size_t s = 0; s < body.sites.size(); ++s)
          set("site", body.sites[s].name, frames_, result.sites[b][s]);
      }
    }
    mention_changes();
    return result;
  }

 private:
  void check_length(const char* kind, const Name& name) {
    if (name.text.size() <= kMaxNameLength) return;
    diagnostics_.error(
        "name-too-long", name.place,
        fmt::format("the name of this {} has more than {} characters", kind, kMaxNameLength));
  }

  // Returns the identifier of the wanted name. If it is taken, the suffix is added, and then a number.
  std::string element(
      const char* kind,
      const Name& name,
      const std::string& wanted,
      const std::string& suffix,
      UniqueNames& taken) {
    check_length(kind, name);
    if (!name.text.empty()) {
      const auto [earlier, is_new] = declared_.insert({kind + (":" + name.text), name.place});
      if (!is_new) {
        diagnostics_.error("duplicate-name", name.place, fmt::format("{} '{}' is declared twice", kind, name.text))
            .notes.push_back({earlier->second, "first declared here"});
        return "";
      }
    }
    std::string identifier = import::identifier(wanted);
    if (taken.contains(identifier)) identifier += suffix;
    identifier = taken.add(identifier);
    if (identifier == name.text) return identifier;
    if (changes_.empty()) first_change_ = name.place;
    changes_.push_back(
        name.text.empty() ? fmt::format("a {} without a name becomes '{}'", kind, identifier)
                          : fmt::format("{} '{}' becomes '{}'", kind, name.text, identifier));
    return identifier;
  }

  void mention_changes() {
    constexpr std::size_t kShown = 4;
    if (changes_.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < changes_.size() && i < kShown; ++i) list += (i == 0 ? "" : ", ") + changes_[i];
    if (changes_.size() > kShown) list += fmt::format(", and {} more", changes_.size() - kShown);
    diagnostics_.note("names-changed", first_change_, list);
  }

  const Document& document_;
  Diagnostics& diagnostics_;
  UniqueNames elements_;  // bodies and joints
  UniqueNames frames_;    // bodies and sites
  std::map<std::string, Place> declared_;
  std::vector<std::string> changes_;
  Place first_change_;
};

}  // namespace

Identifiers identifiers_of(const Document& document, Diagnostics& diagnostics) {
  return Namer(document, diagnostics).name();
}

}  // namespace robcogen::import::from_mjcf
