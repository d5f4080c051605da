// Reads worlds and models.
#include "import/sdf/read.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "import/sdf/check.h"
#include "import/sdf/include.h"
#include "import/sdf/shapes.h"
#include "support/index.h"

namespace robcogen::import::from_sdf {
namespace {

constexpr int kFirstVersion = 4, kLastVersion = 12;  // minor numbers of SDF 1.x
// XML is nested at most 100 levels deep, but files include others.
constexpr int kMaxDepth = 50;

// A model that is the robot, or is nested in another one, and what an `include` says about it instead.
struct ModelToRead {
  const Element* element = nullptr;
  FileContext context;
  const Element* include = nullptr;
  std::shared_ptr<const IncludedFile> file = nullptr;  // of the include; holds `element`
  Name name = {};
  bool is_named_by_include = false;
  bool is_static = false;
};

class DocumentReader {
 public:
  DocumentReader(
      const std::filesystem::path& file,
      const SdfOptions& options,
      std::vector<std::filesystem::path>& included,
      Diagnostics& diagnostics)
      : options_(options),
        diagnostics_(diagnostics),
        snapper_(options.snap_angles, diagnostics),
        reader_(snapper_, diagnostics),
        includer_(file, options.folders, included, diagnostics),
        included_(included),
        folder_(file.parent_path()) {}

  Document read(const Element& root) {
    document_.name = {"robot", root.place};
    document_.frames.emplace_back().name = {"world", root.place};
    document_.scopes.emplace_back();
    const std::optional<int> version = read_version(root, diagnostics_);
    if (!version) return std::move(document_);
    check_names(root, diagnostics_);
    const FileContext context = {*version, folder_};
    const Element* world = find_world(root);
    std::vector<ModelToRead> models = models_in(root, context);
    if (world != nullptr)
      for (ModelToRead& model : models_in(*world, context)) models.push_back(std::move(model));
    if (const std::optional<ModelToRead> robot = choose(root, models)) {
      count_ignored(root, document_.ignored);
      if (world != nullptr) read_world(*world, context);
      read_robot(*robot);
      if (world != nullptr) read_joints_of_world(*world, context, models, *robot);
      snapper_.note_count();
    }
    if (options_.shapes.visuals) document_.ignored.erase("visual");
    if (options_.shapes.collisions) document_.ignored.erase("collision");
    for (const auto& [folder, meshes] : meshes_)
      included_.insert(included_.end(), meshes.files().begin(), meshes.files().end());
    return std::move(document_);
  }

 private:
  // --- choice of the robot ----------------------------------------------------------------------------------------

  const Element* find_world(const Element& root) {
    const Element* first = nullptr;
    for (const Element& child : root.children) {
      if (child.name != "world") continue;
      if (first == nullptr) {
        first = &child;
        continue;
      }
      diagnostics_.error("several-worlds", child.place, "this file has a second world")
          .notes.push_back({first->place, "the first one is here"});
      break;
    }
    return first;
  }

  std::vector<ModelToRead> models_in(const Element& parent, const FileContext& context) {
    std::vector<ModelToRead> models;
    for (const Element& child : parent.children) {
      if (child.name == "model") models.push_back(model_of(child, context));
      if (child.name != "include") continue;
      // What cannot be found may be the ground, which is part of most worlds.
      const auto file = includer_.open(child, context.folder, true, reader_);
      if (file == nullptr) continue;
      includer_.close();
      if (file->model != nullptr) models.push_back(included_model(child, file));
    }
    return models;
  }

  ModelToRead model_of(const Element& element, const FileContext& context) const {
    ModelToRead result = {&element, context};
    result.name = ElementReader::reference(element, "name");
    result.is_static = reader_.flag(element, "static", false);
    return result;
  }

  ModelToRead included_model(const Element& include, const std::shared_ptr<const IncludedFile>& file) const {
    ModelToRead result = model_of(*file->model, file->context);
    result.include = &include;
    result.file = file;
    result.is_static = reader_.flag(include, "static", result.is_static);
    if (const Element* name = reader_.child(include, "name"))
      result.name = ElementReader::reference(*name), result.is_named_by_include = true;
    return result;
  }

  std::optional<ModelToRead> choose(const Element& root, const std::vector<ModelToRead>& models) {
    std::vector<std::string> names;
    std::vector<const ModelToRead*> chosen, moving;
    for (const ModelToRead& model : models) {
      names.push_back(model.name.text);
      if (!model.is_static) moving.push_back(&model);
      if (names.back() == options_.robot) chosen.push_back(&model);
    }
    if (options_.robot.empty()) chosen = models.size() == 1 ? std::vector{&models[0]} : moving;
    if (models.empty()) {
      diagnostics_.error("no-model", root.place, "this file has no model");
    } else if (!options_.robot.empty() && chosen.empty()) {
      diagnostics_.error("unknown-robot", root.place, fmt::format("this file has no model '{}'", options_.robot)).hint =
          fmt::format("its models are {}", fmt::join(names, ", "));
    } else if (chosen.empty()) {
      diagnostics_.error("no-model", root.place, "all models of this file are static").hint =
          fmt::format("--robot (ROBOT in CMake) chooses one of {}", fmt::join(names, ", "));
    } else if (chosen.size() > 1) {
      diagnostics_.error("several-models", chosen[1]->element->place, "this file has several models").hint =
          fmt::format("--robot (ROBOT in CMake) chooses one of {}", fmt::join(names, ", "));
    } else {
      mention_left_out(models, *chosen[0]);
      return *chosen[0];
    }
    return std::nullopt;
  }

  void mention_left_out(const std::vector<ModelToRead>& models, const ModelToRead& robot) {
    std::vector<std::string> names;
    for (const ModelToRead& model : models)
      if (model.element != robot.element || model.include != robot.include) names.push_back(model.name.text);
    if (!names.empty())
      diagnostics_.note(
          "outside-robot", robot.name.place,
          fmt::format("not part of robot '{}', and left out: models '{}'", robot.name.text, fmt::join(names, "', '")));
  }

  // --- models -----------------------------------------------------------------------------------------------------

  void read_robot(const ModelToRead& robot) {
    document_.name = robot.name;
    if (document_.name.text.empty()) document_.name.text = "robot";
    document_.is_static = robot.is_static;
    document_.model = static_cast<int>(document_.frames.size());
    if (robot.file) includer_.reopen(*robot.file);
    read_model(robot, 0, true);
    if (robot.file) includer_.close();
  }

  bool is_merged(const ModelToRead& model) const {
    const Attribute* merge = model.include == nullptr ? nullptr : xml::find(*model.include, "merge");
    return merge != nullptr && (merge->value == "true" || merge->value == "True" || merge->value == "1");
  }

  // Returns the frame of the model.
  int read_model(const ModelToRead& model, int outer, bool is_robot) {
    const Element& element = *model.element;
    const Name name = is_robot                    ? document_.name
                      : model.is_named_by_include ? model.name
                                                  : reader_.name(element);
    const int frame = static_cast<int>(document_.frames.size()), scope = static_cast<int>(document_.scopes.size());
    const bool merges = !is_robot && is_merged(model);
    document_.scopes.emplace_back();
    Scope& own = document_.scopes.back();
    own.frame = frame;
    own.names = merges ? document_.scopes[at(outer)].names : scope;
    const std::string prefix = document_.scopes[at(outer)].prefix;
    own.prefix = is_robot ? "" : merges ? prefix : prefix + name.text + "::";
    document_.frames.push_back(frame_of_model(model, name, outer, scope));
    if (!merges) {
      declare(frames_in(outer), name, frame);
      document_.scopes[at(document_.scopes[at(outer)].names)].scopes.emplace(name.text, scope);
    }
    count_ignored(element, document_.ignored);
    if (++depth_ > kMaxDepth) {
      diagnostics_.error(
          "nesting-too-deep", element.place, fmt::format("models are nested more than {} levels deep", kMaxDepth));
      return frame;
    }
    const int canonical = read_content(element, scope, model.context);
    --depth_;
    if (canonical < 0) diagnostics_.error("no-link", element.place, fmt::format("model '{}' has no link", name.text));
    document_.frames[at(frame)].carrier = std::max(canonical, kWorld);
    if (!is_robot && model.is_static && !document_.is_static)
      diagnostics_.warning(
          "nested-static", element.place,
          fmt::format("model '{}' is static, but moves with the model around it", name.text));
    return frame;
  }

  // What an `include` says replaces what the model says.
  Frame frame_of_model(const ModelToRead& model, const Name& name, int outer, int scope) {
    const bool is_replaced = model.include != nullptr && reader_.child(*model.include, "pose") != nullptr;
    const ReadPose pose =
        reader_.pose(is_replaced ? *model.include : *model.element, fmt::format("model '{}'", name.text));
    Frame frame;
    frame.name = {document_.scopes[at(outer)].prefix + name.text, name.place};
    frame.scope = outer;
    frame.inner_scope = scope;
    frame.pose = pose.pose;
    frame.relative_to = pose.relative_to;
    frame.reference = document_.scopes[at(outer)].frame;
    frame.attached_to = ElementReader::reference(*model.element, "canonical_link");
    frame.placement = ElementReader::reference(*model.element, "placement_frame");
    if (model.include != nullptr)
      if (const Element* placement = reader_.child(*model.include, "placement_frame"))
        frame.placement = ElementReader::reference(*placement);
    return frame;
  }

  // Returns the frame of the first link, or else that of the first nested model; -1 if there is neither.
  int read_content(const Element& model, int scope, const FileContext& context) {
    int first_link = -1, first_model = -1;
    const auto keep_first = [](int& first, int frame) {
      if (first < 0) first = frame;
    };
    for (const Element& child : model.children) {
      if (child.name == "link") keep_first(first_link, read_link(child, scope, context));
      if (child.name == "frame") read_frame(child, scope);
      if (child.name == "joint") read_joint_of(child, scope, context);
      if (child.name == "model") keep_first(first_model, read_model(model_of(child, context), scope, false));
      if (child.name == "include") keep_first(first_model, read_include(child, scope, context));
    }
    return first_link < 0 ? first_model : first_link;
  }

  int read_include(const Element& include, int scope, const FileContext& context) {
    count_ignored(include, document_.ignored);
    const auto file = includer_.open(include, context.folder, false, reader_);
    if (file == nullptr) return kWorld;  // reported
    int frame = kWorld;
    if (file->model == nullptr)
      diagnostics_.error("no-model", file->root.place, "this included file has no model");
    else
      frame = read_model(included_model(include, file), scope, false);
    includer_.close();
    return frame;
  }

  // --- elements of models -----------------------------------------------------------------------------------------

  // Frames of one scope have different names.
  void declare(std::map<std::string, int>& names, const Name& name, int frame) {
    const auto [earlier, is_new] = names.emplace(name.text, frame);
    if (is_new || name.text.empty()) return;
    if (document_.frames[at(earlier->second)].is_of_joint) {
      earlier->second = frame;
      return;
    }
    diagnostics_
        .error("duplicate-name", name.place, fmt::format("'{}' is declared twice in this model", name.text))
        .notes.push_back({document_.frames[at(earlier->second)].name.place, "first declared here"});
  }

  // Adds a frame whose names are looked up in the scope that it is in.
  Frame& add_frame(const Name& name, const ReadPose& pose, int scope) {
    const Scope& in = document_.scopes[at(scope)];
    Frame& frame = document_.frames.emplace_back();
    frame.name = {in.prefix + name.text, name.place};
    frame.scope = frame.inner_scope = scope;
    frame.pose = pose.pose;
    frame.relative_to = pose.relative_to;
    frame.reference = frame.carrier = in.frame;
    return frame;
  }

  std::map<std::string, int>& frames_in(int scope) {
    return document_.scopes[at(document_.scopes[at(scope)].names)].frames;
  }

  int read_link(const Element& element, int scope, const FileContext& context) {
    count_ignored(element, document_.ignored);
    const Name name = reader_.name(element);
    const int index = static_cast<int>(document_.frames.size());
    Frame& frame = add_frame(name, reader_.pose(element, fmt::format("link '{}'", name.text)), scope);
    frame.carrier = index;
    frame.link = static_cast<int>(document_.links.size());
    Link& link = document_.links.emplace_back();
    link.name = frame.name;
    link.frame = index;
    link.inertial = read_inertial(element, link.name.text, reader_);
    declare(frames_in(scope), name, index);
    for (const Element& child : element.children)
      if (child.name == "visual" || child.name == "collision") read_shape_of(child, scope, context);
    return index;
  }

  // Of the last link.
  void read_shape_of(const Element& element, int scope, const FileContext& context) {
    Link& link = document_.links.back();
    ShapeMeshes& meshes = meshes_.try_emplace(context.folder, context.folder, options_.shapes).first->second;
    std::optional<ReadShape> shape = read_shape(element, link.name.text, options_.shapes, meshes, diagnostics_);
    if (!shape) return;
    const int index = static_cast<int>(document_.frames.size());
    Frame& frame = add_frame(shape->name, shape->pose, scope);
    frame.reference = frame.carrier = link.frame;
    link.shapes.push_back({std::move(shape->shape), index});
  }

  void read_frame(const Element& element, int scope) {
    const Name name = reader_.name(element);
    const int index = static_cast<int>(document_.frames.size());
    Frame& frame = add_frame(name, reader_.pose(element, fmt::format("frame '{}'", name.text)), scope);
    frame.attached_to = ElementReader::reference(element, "attached_to");
    if (frame.relative_to.text.empty()) frame.relative_to = frame.attached_to;
    frame.is_declared = true;
    declare(frames_in(scope), name, index);
  }

  void read_joint_of(const Element& element, int scope, const FileContext& context) {
    count_ignored(element, document_.ignored);
    const Name name = reader_.name(element);
    std::optional<Joint> joint = read_joint(element, name, context.version, reader_);
    if (!joint) return;
    joint->scope = scope;
    joint->frame = static_cast<int>(document_.frames.size());
    Frame& frame = add_frame(name, reader_.pose(element, fmt::format("joint '{}'", name.text)), scope);
    joint->name = frame.name;
    frame.is_of_joint = true;
    frame.attached_to = joint->child;
    if (frame.relative_to.text.empty()) frame.relative_to = joint->child;
    // In older versions, a link or a frame may have the name of a joint. The name then is that of the former.
    frames_in(scope).emplace(name.text, joint->frame);
    auto& joints = document_.scopes[at(document_.scopes[at(scope)].names)].joints;
    if (!joints.emplace(name.text, static_cast<int>(document_.joints.size())).second)
      diagnostics_.error("duplicate-name", name.place, fmt::format("joint '{}' is declared twice in this model", name.text));
    document_.joints.push_back(*std::move(joint));
  }

  // --- the world --------------------------------------------------------------------------------------------------

  void read_world(const Element& world, const FileContext&) {
    count_ignored(world, document_.ignored);
    if (const Element* gravity = reader_.child(world, "gravity")) note_gravity(*gravity);
    for (const Element& child : world.children)
      if (child.name == "frame") read_frame(child, 0);
  }

  void note_gravity(const Element& element) {
    const auto g = reader_.triple(element);
    const bool is_standard = g[0].is_zero() && g[1].is_zero() && (g[2].value() == -9.8 || g[2].value() == -9.81);
    if (is_standard) return;
    diagnostics_.note(
        "other-gravity", xml::text_of(element).place,
        fmt::format(
            "the gravity of this file is ({}, {}, {}); functions use (0, 0, -9.81) unless they are given another",
            print_double(g[0].value()), print_double(g[1].value()), print_double(g[2].value())));
  }

  // Joints between the world and the robot. Others are left out with the models that they move.
  void read_joints_of_world(
      const Element& world,
      const FileContext& context,
      const std::vector<ModelToRead>& models,
      const ModelToRead& robot) {
    for (const Element& child : world.children) {
      if (child.name != "joint") continue;
      const auto is_outside = [&](const char* end) {
        const Element* name = reader_.child(child, end);
        const std::string first = name == nullptr ? "" : name->text.substr(0, name->text.find("::"));
        return std::any_of(models.begin(), models.end(), [&](const ModelToRead& model) {
          return model.element != robot.element && model.name.text == first;
        });
      };
      if (is_outside("parent") || is_outside("child"))
        diagnostics_.warning(
            "mechanics-not-read", child.place, "this joint is left out: one of its ends is not part of the robot");
      else
        read_joint_of(child, 0, context);
    }
  }

  const SdfOptions& options_;
  Diagnostics& diagnostics_;
  AngleSnapper snapper_;
  ElementReader reader_;
  Includer includer_;
  std::map<std::filesystem::path, ShapeMeshes> meshes_;  // by folder
  std::vector<std::filesystem::path>& included_;
  std::filesystem::path folder_;
  Document document_;
  int depth_ = 0;
};

}  // namespace

std::optional<int> read_version(const Element& root, Diagnostics& diagnostics) {
  const Attribute* version = xml::find(root, "version");
  if (version == nullptr) {
    diagnostics.error("missing-attribute", root.place, "this 'sdf' has no attribute 'version'").hint =
        "write <sdf version=\"1.9\">";
    return std::nullopt;
  }
  const std::string& text = version->value;
  int minor = -1;
  if (text.starts_with("1.")) std::from_chars(text.data() + 2, text.data() + text.size(), minor);
  if (minor >= kFirstVersion && minor <= kLastVersion) return minor;
  if (minor > kLastVersion) {
    diagnostics.warning(
        "unknown-version", version->place, fmt::format("version {} of SDF is unknown: read as 1.{}", text, kLastVersion));
    return kLastVersion;
  }
  diagnostics.error(
      "unsupported-version", version->place,
      fmt::format("version '{}' of SDF is not supported: 1.{} and later are", text, kFirstVersion));
  return std::nullopt;
}

Document read_document(
    const Element& root,
    const std::filesystem::path& file,
    const SdfOptions& options,
    std::vector<std::filesystem::path>& included,
    Diagnostics& diagnostics) {
  return DocumentReader(file, options, included, diagnostics).read(root);
}

}  // namespace robcogen::import::from_sdf
