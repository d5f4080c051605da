#include "view/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "backend/javascript/javascript.h"
#include "support/concat.h"
#include "support/index.h"
#include "view/canvas.h"
#include "view/page_files.h"
#include "view/page_shapes.h"

namespace robcogen::view {
namespace {

using Json = nlohmann::ordered_json;

// Each module comes after those that it uses.
constexpr const char* kScripts[] = {"vectors.js", "shapes.js",  "positions.js", "posture.js",
                                    "camera.js",  "picture.js", "panels.js",    "main.js"};

// The text for a script element. These sequences would end or change the element; in strings, the replacements mean the
// same.
std::string in_script(const std::string& text) {
  return replaced(replaced(text, "</", "<\\/"), "<!--", "<\\!--");
}

constexpr std::string_view kExport = "export ", kImport = "import ";

// A module as a part of another one: without its imports, and with its exports as plain declarations, whose names are
// added to `names`.
std::string inlined(std::string_view module, std::vector<std::string>* names = nullptr) {
  std::string result;
  for (std::size_t begin = 0; begin < module.size();) {
    const std::size_t end = std::min(module.find('\n', begin), module.size());
    std::string_view line = module.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with(kImport)) continue;
    if (line.starts_with(kExport)) {
      line.remove_prefix(kExport.size());
      const std::size_t name = line.find(' ') + 1;
      if (names) names->emplace_back(line.substr(name, line.find_first_of(" (", name) - name));
    }
    result += line;
    result += '\n';
  }
  return result;
}

// `const generated = …`: the functions of the robot, as the back end prints them.
std::string generated(const backend::Library& library) {
  std::vector<std::string> names;
  const std::string text = inlined(backend::javascript::print(library).front().text, &names);
  return "const generated = (() => {\n" + text + "return { " + fmt::format("{}", fmt::join(names, ", ")) +
         " };\n})();\n";
}

// ---- The subject of a warning.

bool is_quoted(const std::string& message, const std::string& name) {
  return message.find("'" + name + "'") != std::string::npos;
}

// The link that a message names, or whose joint it names; otherwise the link that is declared last before the message's
// place; or -1.
int link_of(const Diagnostic& d, const model::KinematicTree& tree) {
  for (std::size_t l = 0; l < tree.links.size(); ++l)
    if (is_quoted(d.message, tree.links[l].name)) return static_cast<int>(l);
  for (const model::Joint& joint : tree.joints)
    if (!tree.links[at(joint.child)].is_repeated && is_quoted(d.message, joint.declared_name())) return joint.child;
  int link = -1;
  std::size_t last = 0;
  const auto consider = [&](const Place& place, int candidate) {
    if (!place.source || place.source != d.place.source) return;
    if (place.span.begin > d.place.span.begin || place.span.begin < last) return;
    last = place.span.begin;
    link = candidate;
  };
  for (std::size_t l = 0; l < tree.links.size(); ++l)
    if (!tree.links[l].is_repeated) consider(tree.links[l].place, static_cast<int>(l));
  for (const model::Joint& joint : tree.joints)
    if (!tree.links[at(joint.child)].is_repeated) consider(joint.place, joint.child);
  return link;
}

std::string place_of(const Diagnostic& d) {
  const Place place = written_at(d.place);
  if (!place.source) return "";
  const LineColumn at = place.source->locate(place.span.begin);
  const std::string name = std::filesystem::path(place.source->name()).filename().string();
  return place.source->text().empty() ? name : fmt::format("{}:{}:{}", name, at.line, at.column);
}

Json warnings_of(const Diagnostics& diagnostics, const model::KinematicTree& tree) {
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::note) continue;
    list.push_back(
        {{"code", d.code},
         {"message", d.message},
         {"hint", d.hint},
         {"where", place_of(d)},
         {"link", link_of(d, tree)}});
  }
  return list;
}

const char* word(ViewedFrame::Kind kind) {
  switch (kind) {
    case ViewedFrame::Kind::link:
      return "link";
    case ViewedFrame::Kind::joint:
      return "joint";
    case ViewedFrame::Kind::user:
      break;
  }
  return "user";
}

Json data_of(
    const driver::Model& model,
    const ViewedRobot& robot,
    const Diagnostics& diagnostics,
    const PageOptions& options) {
  const backend::Library& library = robot.library;
  Json frames = Json::array(), parameters = Json::object();
  for (const ViewedFrame& frame : robot.frames)
    frames.push_back({{"kind", word(frame.kind)}, {"name", frame.name}, {"index", frame.index}, {"link", frame.link}});
  Json loops = Json::array();
  for (const ViewedLoop& loop : robot.loops) loops.push_back({{"name", loop.name}, {"frames", loop.frames}});
  for (std::size_t k = 0; k < library.tree.parameters.size(); ++k)
    parameters[library.tree.parameters[k].name] = options.parameters[k];
  const std::size_t count = at(library.tree.dof()) - 2 * library.tree.spherical_joints().size();
  const std::string about = fmt::format(
      "{} · {} joint{} · {}", library.model_file, count, count == 1 ? "" : "s",
      robot.floats ? "floating base, fixed in this view" : "fixed base");
  Json data = {{"about", about},   {"q", options.q}, {"parameters", parameters},
               {"frames", frames}, {"loops", loops}, {"warnings", warnings_of(diagnostics, model.robot()->tree)}};
  if (library.tree.geometry.shapes.empty()) return data;
  PageShapes shapes = page_shapes(library.tree.geometry.shapes);
  data["shapes"] = std::move(shapes.shapes);
  data["meshes"] = std::move(shapes.meshes);
  if (shapes.shown_triangles < shapes.triangles)
    data["about"] =
        fmt::format("{} · meshes simplified: {} of {} triangles", about, shapes.shown_triangles, shapes.triangles);
  return data;
}

}  // namespace

std::string page(
    const driver::Model& model,
    const ViewedRobot& robot,
    const Diagnostics& diagnostics,
    const PageOptions& options) {
  std::string script = generated(robot.library);
  for (const char* name : kScripts) script += "\n" + inlined(page_file(name));
  const Json data = data_of(model, robot, diagnostics, options);
  const std::string json = replaced(data.dump(1, ' ', true, Json::error_handler_t::replace), "<", "\\u003c");
  // The places are filled in order, so that inserted text is not searched for the places after it.
  std::string result;
  std::string_view rest = page_file("page.html");
  for (const auto& [place, text] :
       {std::pair<std::string_view, std::string>{"{{title}}", escaped(robot.library.title())},
        {"{{style}}", std::string(page_file("page.css"))},
        {"{{data}}", json},
        {"{{script}}", in_script(script)}}) {
    const std::size_t at = rest.find(place);
    result += rest.substr(0, at);
    result += text;
    rest.remove_prefix(at + place.size());
  }
  result += rest;
  return result;
}

}  // namespace robcogen::view
