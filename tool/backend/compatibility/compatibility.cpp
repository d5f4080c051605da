#include "backend/compatibility/compatibility.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "backend/compatibility/words.h"
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/names.h"
#include "backend/cpp/printers.h"
#include "support/index.h"

namespace robcogen::backend::compatibility {
namespace {

struct Header {
  const char *name, *what, *text;
};
#define HEADER(name, what, text) {name, what, text},
const Header kHeaders[] = {
#include "backend/compatibility/headers.inc"
};
#undef HEADER

std::string compiled_path(const std::string& library_folder) {
  return library_folder + "/kernel/compiled.h";
}

// Files that include the texts of kernels do not compile those again that the library has.
std::string print_compiled(const cpp::Api& api, const std::string& path) {
  std::string text;
  for (const std::string& group : groups())
    for (const cpp::Callable* c : cpp::callables_of(api, group))
      for (const std::string& scalar : api.scalars()) {
        const std::string name = c->kernel + "<" + scalar + ">";
        text += "extern template decltype(" + name + ") " + name + ";\n";
      }
  return cpp::paragraphs(
      {cpp::banner(*api.library, path, "kernels that the library compiles, for files that include their texts"),
       "#pragma once\n", cpp::includes({cpp::quoted(cpp::kernels_path(cpp::folder(*api.library)))}),
       cpp::in_namespace(api.space + "::kernel", text)});
}

std::string type_of(const model::KinematicTree& tree, int joint) {
  if (!tree.joints[at(joint)].spherical.empty()) return "spherical";
  if (tree.joints[at(joint)].type == model::JointType::helical) return "helical";
  return tree.coupling_of(joint) ? "coupled to others" : "";
}

}  // namespace

std::string default_include_path(const std::string& name) {
  std::string path = "iit/robots/";
  for (const char c : name) path += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return path;
}

const std::vector<std::string>& groups() {
  static const std::vector<std::string> list = {
      "inverse_dynamics",           "bias_forces", "forward_dynamics", "joint_space_inertia",
      "joint_space_inertia_factor", "centroidal",  "transforms",       "jacobians"};
  return list;
}

void check(const model::KinematicTree& tree, Diagnostics& diagnostics) {
  std::map<std::string, std::string> taken;
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const model::Joint& joint = tree.joints[j];
    taken[cpp::identifier(joint.name)] = "joint '" + joint.name + "'";
    const std::string type = type_of(tree, static_cast<int>(j));
    if (type.empty() || !joint.is_first()) continue;
    const std::string name = joint.declared_name();
    diagnostics.error("compatibility-joint", joint.place, "--compatibility: joint '" + name + "' is " + type).hint =
        "programs of the first RobCoGen have no such joint: use the functions of the library";
  }
  const std::vector<std::string> links = link_identifiers(tree);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto [place, is_new] = taken.emplace(links[i], "link '" + tree.links[i].name + "'");
    if (is_new) continue;
    diagnostics.error(
        "compatibility-names", tree.links[i].place,
        "--compatibility: link '" + tree.links[i].name + "' and " + place->second + " would both be the enumerator '" +
            links[i] + "'");
  }
}

void add_link_transforms(const model::KinematicTree& tree, model::DesiredTransforms& desired) {
  const auto frame = [&](int link) { return *tree.find_frame(model::implicit_frame_name(tree.links[at(link)].name)); };
  for (const model::Joint& joint : tree.joints) {
    const model::Frame parent = frame(joint.parent), child = frame(joint.child);
    for (const model::FramePair& pair : {model::FramePair{child, parent}, model::FramePair{parent, child}})
      if (std::find(desired.transforms.begin(), desired.transforms.end(), pair) == desired.transforms.end())
        desired.transforms.push_back(pair);
  }
}

std::vector<std::string> outputs(const std::string& library_folder, const std::string& include_path) {
  std::vector<std::string> paths = {compiled_path(library_folder)};
  for (const Header& header : kHeaders) paths.push_back(include_path + "/" + header.name);
  return paths;
}

std::vector<OutputFile> print(const Library& library, const Options& options) {
  const cpp::Api api = cpp::api(library);
  const std::string space = options.space.empty() ? "iit::" + cpp::identifier(library.tree.name) : options.space;
  const std::map<std::string, std::string> values = words(api, space);
  const std::string compiled = compiled_path(cpp::folder(library));
  std::vector<OutputFile> files = {{compiled, print_compiled(api, compiled)}};
  for (const Header& header : kHeaders) {
    const std::string path = options.include_path + "/" + header.name;
    const bool is_list = path.ends_with(".inc");
    files.push_back(
        {path, cpp::banner(library, path, std::string(header.what) + ", for programs of the first RobCoGen") +
                   (is_list ? "" : "\n#pragma once\n") + filled(header.text, values)});
  }
  return files;
}

}  // namespace robcogen::backend::compatibility
