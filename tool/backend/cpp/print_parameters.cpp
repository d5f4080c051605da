// <name>/parameters.h: the values of a robot's parameters, and the cache that its functions read.
#include <algorithm>
#include <cmath>

#include "backend/common/cache.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

struct Kind {
  bool is_dynamics = false;
  std::string name;     // Kinematics
  std::string subject;  // kinematics
  std::string what;
};

const Kind kKinds[] = {
    {false, "Kinematics", "kinematics",
     "Parameters in the placement of joints and frames: lengths (m) and angles (rad)."},
    {true, "Dynamics", "dynamics", "Parameters in the mass properties of links: kg, m, kg m^2."}};

bool is_shared(const model::Parameter& p) {
  return model::is_kinematics(p) && model::is_dynamics(p);
}

// Calls f(index) for the parameters of a kind, in order, including those that are of both kinds.
template <class F>
void for_each_of(const Library& library, const Kind& kind, F f) {
  for (std::size_t i = 0; i < library.parameters().size(); ++i) {
    const model::Parameter& p = library.parameters()[i];
    if (kind.is_dynamics ? model::is_dynamics(p) : model::is_kinematics(p)) f(i);
  }
}

bool has_shared(const Library& library) {
  return std::any_of(library.parameters().begin(), library.parameters().end(), is_shared);
}

std::string interface_type(const Api& api, const Kind& kind) {
  const std::string name = kind.name + "Parameters";
  std::string getters;
  for_each_of(*api.library, kind, [&](std::size_t i) {
    getters += "  virtual double " + api.getters[i] + "() const noexcept = 0;\n";
  });
  return comment(kind.what + " Implement this interface to supply the values.") + "class " + name + " {\n public:\n" +
         "  virtual ~" + name + "() = default;\n" + (getters.empty() ? "" : "\n" + getters) + "};\n";
}

std::string field(const Api& api, std::size_t i) {
  const double value = model::default_of(api.library->parameters()[i]);
  const std::string initial =
      std::isnan(value) ? "std::numeric_limits<double>::quiet_NaN();  // no default" : print_double(value) + ";";
  return "  double " + api.fields[i] + " = " + initial + "\n";
}

std::string getter(const Api& api, std::size_t i) {
  return "  double " + api.getters[i] + "() const noexcept override { return " + api.fields[i] + "; }\n";
}

// A virtual base of the values of either kind, so that values of both kinds hold the shared ones once.
std::string shared_values_type(const Api& api) {
  const Library& library = *api.library;
  if (!has_shared(library)) return "";
  std::string fields;
  for (std::size_t i = 0; i < library.parameters().size(); ++i)
    if (is_shared(library.parameters()[i])) fields += field(api, i);
  return "// Parameters of both interfaces.\nstruct SharedValues {\n" + fields + "};\n";
}

std::string values_type(const Api& api, const Kind& kind) {
  const Library& library = *api.library;
  std::string fields, getters;
  for_each_of(library, kind, [&](std::size_t i) {
    if (!is_shared(library.parameters()[i])) fields += field(api, i);
    getters += getter(api, i);
  });
  const std::string body = paragraphs({fields, getters});
  const std::string shared = has_shared(library) ? ", virtual SharedValues" : "";
  return "struct " + kind.name + "Values : " + kind.name + "Parameters" + shared + " {" + (body.empty() ? "" : "\n") +
         body + "};\n";
}

// The names of the parameters for which wants(index) is true.
template <class F>
std::string names_of(const Api& api, F wants) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < api.fields.size(); ++i)
    if (wants(i)) names.push_back(api.fields[i]);
  return joined(names);
}

std::string array_type(const Api& api) {
  const std::string size = std::to_string(api.library->parameters().size());
  std::vector<std::string> names, remarks;
  for (const model::Parameter& p : api.library->parameters()) {
    names.push_back(quoted(p.name));
    const std::string& subject = kKinds[model::is_dynamics(p) ? 1 : 0].subject;
    remarks.push_back(is_shared(p) ? kKinds[0].subject + " and " + subject : subject);
  }
  return "// Values of all parameters, in the order of kParameterNames, for code that does not know their names.\n"
         "using ParameterArray = std::array<double, " +
         size + ">;\n\n" +
         remarked_list("inline constexpr std::array<const char*, " + size + "> kParameterNames", names, remarks);
}

std::string all_values_type(const Api& api) {
  const Library& library = *api.library;
  // One getter for both interfaces; otherwise the inherited name would be ambiguous.
  std::string getters;
  for (std::size_t i = 0; i < library.parameters().size(); ++i)
    if (is_shared(library.parameters()[i])) getters += getter(api, i);
  return "// Values of all parameters, initially as declared; a parameter without default is NaN until it is set.\n"
         "struct ParameterValues : KinematicsValues, DynamicsValues {" +
         (getters.empty() ? "" : "\n" + getters) + "};\n";
}

std::string compute(const Api& api, const std::vector<std::size_t>& parts) {
  const std::vector<CachePart> all = cache_parts(*api.library);
  std::string body;
  for (const std::size_t k : parts) {
    const auto& [begin, size] = all[k];
    if (size == 0) continue;
    body += "    compute<" + std::to_string(begin) + ", " + std::to_string(begin + size) +
            ">(&kernel::" + api.updates[k].kernel + "<double>);\n";
  }
  return body;
}

// Reads values anew, then computes the parts of the cache that depend on them. A value that both interfaces have is
// read from the first one.
std::string update(const Api& api, const std::vector<Kind>& read, const std::vector<std::size_t>& parts) {
  std::vector<std::string> arguments;
  std::string body;
  for (const Kind& kind : read) {
    bool is_read = false;
    for_each_of(*api.library, kind, [&](std::size_t i) {
      if (&kind != &read.front() && is_shared(api.library->parameters()[i])) return;
      body += "    values_[" + std::to_string(i) + "] = " + kind.subject + "." + api.getters[i] + "();\n";
      is_read = true;
    });
    arguments.push_back("const " + kind.name + "Parameters& " + (is_read ? kind.subject : "/*" + kind.subject + "*/"));
  }
  body += compute(api, parts);
  return declaration("void update", arguments, body.empty() ? " noexcept {}" : " noexcept {", 2) +
         (body.empty() ? "" : body + "  }\n");
}

// The names of the parameters that both interfaces have.
std::string shared_names(const Api& api) {
  return names_of(api, [&](std::size_t i) { return is_shared(api.library->parameters()[i]); });
}

std::string shared_remark(const Api& api) {
  return has_shared(*api.library)
             ? comment("Parameters of both kinds are taken from `kinematics`: " + shared_names(api) + ".", 2)
             : "";
}

std::string last_remark(const Api& api) {
  return has_shared(*api.library)
             ? comment(
                   "Parameters of both kinds have one value, that of the last update: " + shared_names(api) + ".", 2)
             : "";
}

std::string values_function(const Api& api) {
  std::string body = "    ParameterValues values;\n";
  for (const Kind& kind : kKinds)
    for_each_of(*api.library, kind, [&](std::size_t i) {
      const bool shared = is_shared(api.library->parameters()[i]);
      if (shared && kind.is_dynamics) return;
      const std::string owner = shared ? "Shared" : kind.name;
      body += "    values." + owner + "Values::" + api.fields[i] + " = values_[" + std::to_string(i) + "];\n";
    });
  return "  // The values of the last update.\n  ParameterValues values() const noexcept {\n" + body +
         "    return values;\n  }\n  const ParameterArray& array() const noexcept { return values_; }\n";
}

std::string constructors(const Api& api) {
  const std::vector<model::Parameter>& parameters = api.library->parameters();
  const std::string missing = names_of(api, [&](std::size_t i) { return !parameters[i].default_value; });
  std::string text;
  if (missing.empty()) {
    text += "  // The declared defaults.\n  Parameters() noexcept : Parameters(ParameterValues()) {}\n";
  } else {
    text += comment("Without default: " + missing + ".", 2) +
            "  Parameters() = delete;  // some parameters have no default: construct with values\n";
  }
  return text + "  explicit Parameters(const ParameterValues& values) noexcept : Parameters(values, values) {}\n" +
         "  explicit Parameters(const ParameterArray& values) noexcept { update(values); }\n" +
         declaration(
             "Parameters", {"const KinematicsParameters& kinematics", "const DynamicsParameters& dynamics"},
             " noexcept {", 2) +
         "    update(kinematics, dynamics);\n  }\n";
}

std::string parameters_type(const Api& api) {
  const int size = cache_size(*api.library);
  const std::vector<std::string> parts = {
      constructors(api),
      "  // Updates all values.\n" + shared_remark(api) + update(api, {kKinds[0], kKinds[1]}, {0, 1, 2}) +
          "  void update(const ParameterValues& values) noexcept { update(values, values); }\n" +
          "  void update(const ParameterArray& values) noexcept {\n    values_ = values;\n" + compute(api, {0, 1, 2}) +
          "  }\n",
      "  // Updates the values of one interface and keeps the others.\n" + last_remark(api) +
          update(api, {kKinds[0]}, {0, 2}) + update(api, {kKinds[1]}, {1, 2}),
      values_function(api),
      "  // The cache, in the layout that kernels take.\n"
      "  const Scalar* data() const noexcept { return cache_.data(); }\n"
      "  static constexpr std::size_t size() noexcept { return " +
          std::to_string(size) + "; }\n"};
  const std::string privates =
      " private:\n"
      "  // Computes in double precision for any Scalar, and rounds once.\n"
      "  template <int kBegin, int kEnd>\n"
      "  void compute(void (*kernel)(const double* values, double* part) noexcept) noexcept {\n"
      "    std::array<double, kEnd - kBegin> part;\n"
      "    kernel(values_.data(), part.data());\n"
      "    for (std::size_t i = 0; i < part.size(); ++i) cache_[kBegin + i] = static_cast<Scalar>(part[i]);\n"
      "  }\n\n"
      "  std::array<double, " +
      std::to_string(api.library->parameters().size()) +
      "> values_;\n"
      "  std::array<Scalar, " +
      std::to_string(size) + "> cache_;\n";
  return "// The parameters of the functions of the robot, with all values that depend only on parameters. These "
         "values are\n"
         "// computed when the parameters change.\n"
         "//\n"
         "// Functions only read it, so any number of threads may share one object, as long as none updates it. To "
         "change\n"
         "// values in the meantime, update a copy and pass the copy on.\n"
         "template <class Scalar = double>\nclass Parameters {\n public:\n" +
         paragraphs(parts) + "\n" + privates + "};\n";
}

}  // namespace

std::string print_parameters(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  const std::string head = banner(library, path, "values of its parameters");
  if (!api.is_parametric())
    return paragraphs({head + "// The robot has no parameters: all its quantities are constants.\n", "#pragma once\n"});
  std::vector<std::string> parts;
  for (const Kind& kind : kKinds) parts.push_back(interface_type(api, kind));
  parts.push_back(shared_values_type(api));
  for (const Kind& kind : kKinds) parts.push_back(values_type(api, kind));
  parts.insert(parts.end(), {all_values_type(api), array_type(api), parameters_type(api)});
  return paragraphs(
      {head, "#pragma once\n", includes({"<array>", "<cstddef>", "<limits>"}),
       includes({cpp::quoted(kernels_path(folder(library)))}), in_namespace(api.space, paragraphs(parts))});
}

}  // namespace robcogen::backend::cpp
