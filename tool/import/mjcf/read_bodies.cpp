// Reads the tree of bodies.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/mjcf/read.h"
#include "import/mjcf/segment.h"

namespace robcogen::import::from_mjcf {

namespace {

bool has_joint(const Element& body) {
  return std::any_of(body.children.begin(), body.children.end(), [](const Element& e) {
    const bool is_transparent = e.name == "frame" || e.name == "replicate";
    return e.name == "joint" || e.name == "freejoint" || (is_transparent && has_joint(e));
  });
}

// More would be a mistake, and would take long to read.
constexpr std::size_t kMostCopies = 10000;

// What the elements around an element mean for it.
struct Scope {
  Pose frame;                             // of the enclosing `frame` elements, in the frame of the body
  const Attribute* childclass = nullptr;  // default class
  std::string suffix = {};                // of names
  std::size_t copies = 1;                 // that `replicate` makes
};

class BodyReader {
 public:
  BodyReader(const Settings& settings, const Defaults& defaults, Document& document, Diagnostics& diagnostics)
      : settings_(settings), defaults_(defaults), document_(document), diagnostics_(&diagnostics) {}

  void read_world(const Element& worldbody) { read_content(worldbody, 0, {}); }

 private:
  void read_content(const Element& parent, std::size_t body, const Scope& scope) {
    for (const Element& e : parent.children) {
      if (e.name == "body") {
        read_body(e, body, scope);
      } else if (e.name == "frame") {
        Scope inner = scope;
        inner.frame = scope.frame * pose_of(e, settings_, *diagnostics_);
        inner.childclass = class_of_content(e, scope.childclass);
        read_content(e, body, inner);
      } else if (e.name == "replicate") {
        read_copies(e, body, scope);
      } else if (e.name == "joint" || e.name == "freejoint") {
        read_joint_of(e, body, scope);
      } else if (e.name == "geom") {
        const Element geom = defaults_.resolved(e, scope.childclass);
        for (const Element& child : e.children) read_other(child, "geom");
        document_.bodies[body].geoms.push_back({geom, scope.frame});
      } else if (e.name == "site") {
        const Element site = defaults_.resolved(e, scope.childclass);
        document_.bodies[body].sites.push_back({name_of(e, scope), written(e, scope), scope.frame * site_pose(site)});
      } else if (e.name == "inertial") {
        read_inertial(e, parent, body);
      } else {
        read_other(e, parent.name);
      }
    }
  }

  static Name name_of(const Element& element, const Scope& scope) {
    const Attribute* name = find(element, "name");
    if (name == nullptr || name->value.empty()) return {"", name == nullptr ? element.place : name->place};
    return {name->value + scope.suffix, name->place};
  }

  static Written written(const Element& element, const Scope& scope) {
    const Attribute* name = find(element, "name");
    return {name == nullptr ? "" : name->value, scope.suffix};
  }

  const Attribute* class_of_content(const Element& element, const Attribute* outer) {
    const Attribute* own = find(element, "childclass");
    return own != nullptr && defaults_.knows(*own) ? own : outer;
  }

  // With `fromto`, the origin is the middle of the segment, and z points from the second point to the first.
  Pose site_pose(const Element& site) {
    const Attribute* type = find(site, "type");
    const std::optional<Segment> segment = read_segment(site, type == nullptr ? "sphere" : type->value, *diagnostics_);
    if (segment) return {segment->middle, smallest_rotation_to_axis(segment->along)};
    return pose_of(site, settings_, *diagnostics_);
  }

  void read_body(const Element& e, std::size_t parent, const Scope& scope) {
    Scope inner;
    inner.childclass = class_of_content(e, scope.childclass);
    inner.suffix = scope.suffix;
    inner.copies = scope.copies;
    const std::size_t body = document_.bodies.size();
    Body own;
    own.name = name_of(e, scope);
    own.written = written(e, scope);
    own.parent = static_cast<int>(parent);
    own.pose = scope.frame * pose_of(e, settings_, *diagnostics_);
    own.moves = document_.bodies[parent].moves || has_joint(e);
    document_.bodies.push_back(std::move(own));
    if (const Attribute* compensation = find(e, "gravcomp");
        compensation != nullptr && !Values(*diagnostics_).scalar(e, "gravcomp").is_zero()) {
      diagnostics_->warning(
          "gravity-compensation", compensation->place, "the gravity compensation of this body is ignored");
    }
    read_content(e, body, inner);
    const auto begin = document_.bodies.begin() + static_cast<std::ptrdiff_t>(body);
    const bool carries = std::any_of(begin, document_.bodies.end(), [](const Body& b) { return b.moves; });
    document_.bodies[body].is_mocap = Values(*diagnostics_).word(e, "mocap", {"false", "true"}, 0) == 1;
    if (document_.bodies[body].is_mocap && carries)
      diagnostics_->warning(
          "motion-capture", find(e, "mocap")->place, "this body is taken as fixed: its pose is not an input");
  }

  // Reads the content once for each copy. Each copy is turned and shifted from the one before it.
  void read_copies(const Element& e, std::size_t body, const Scope& scope) {
    Values values(*diagnostics_);
    const Attribute* attribute = find(e, "count");
    if (attribute == nullptr) {
      diagnostics_->error("missing-attribute", e.place, "this 'replicate' has no attribute 'count'");
      return;
    }
    const double given = values.scalar(e, "count").value();
    const auto count = static_cast<std::size_t>(std::clamp(given, 0.0, 1.0 + kMostCopies));
    if (static_cast<double>(count) != given || count == 0 || count * scope.copies > kMostCopies) {
      diagnostics_->error(
          "copy-count", attribute->place, fmt::format("the number of copies is not between 1 and {}", kMostCopies));
      return;
    }
    const Pose shift = {quantities(values.triple(e, "offset", {})), {}};
    const Attribute* separator = find(e, "sep");
    const std::size_t digits = std::to_string(count - 1).size();
    Scope inner;
    inner.childclass = class_of_content(e, scope.childclass);
    inner.copies = scope.copies * count;
    Pose pose;
    Diagnostics repeated;  // the other copies have the messages of the first one
    Diagnostics* const outer = diagnostics_;
    for (std::size_t i = 0; i < count; ++i) {
      pose.rotation = turn_of_copy(e, i);
      inner.frame = scope.frame * pose;
      inner.suffix = fmt::format("{}{:0{}}{}", separator == nullptr ? "" : separator->value, i, digits, scope.suffix);
      read_content(e, body, inner);
      pose = pose * shift;
      diagnostics_ = &repeated;
    }
    diagnostics_ = outer;
  }

  Rotation turn_of_copy(const Element& e, std::size_t copy) {
    const Attribute* euler = find(e, "euler");
    return euler == nullptr ? Rotation() : multiple_of_euler(*euler, copy, settings_, *diagnostics_);
  }

  void read_inertial(const Element& e, const Element& parent, std::size_t body) {
    std::optional<Element>& own = document_.bodies[body].inertial;
    if (parent.name == "frame" || parent.name == "replicate" || body == 0) {
      diagnostics_->error("misplaced-element", e.place, "an 'inertial' belongs to a body, not to this element");
    } else if (own) {
      diagnostics_->error("repeated-element", e.place, "this body has a second 'inertial'")
          .notes.push_back({own->place, "the first one is here"});
    } else {
      own = e;
    }
  }

  void read_joint_of(const Element& e, std::size_t body, const Scope& scope) {
    if (body == 0) {
      diagnostics_->error("misplaced-element", e.place, "a joint belongs to a body, not to the world");
      return;
    }
    Body& own = document_.bodies[body];
    const bool is_freejoint = e.name == "freejoint";
    const Element joint = is_freejoint ? e : defaults_.resolved(e, scope.childclass);
    const Attribute* type = find(joint, "type");
    const bool is_free = is_freejoint || (type != nullptr && type->value == "free");
    if (own.floats() || (is_free && (own.parent != 0 || !own.joints.empty()))) {
      diagnostics_
          ->error(
              "free-joint-inside", e.place, "a free joint must be the only joint of a body whose parent is the world")
          .hint = "a free-floating body is a separate robot: write it to a separate file";
    } else if (is_free) {
      own.free_joint = FreeJoint{written(e, scope), e.place, std::nullopt, {}};
      if (is_freejoint)
        read_alignment(e, *own.free_joint);
      else
        check_free_joint(joint);
    } else if (std::optional<Joint> read = read_joint(joint, settings_, *diagnostics_)) {
      check_turns(own, *read);
      read->name = name_of(e, scope);
      read->written = written(e, scope);
      read->frame = scope.frame;
      own.joints.push_back(std::move(*read));
    }
  }

  void read_alignment(const Element& e, FreeJoint& joint) {
    const std::size_t choice = Values(*diagnostics_).word(e, "align", {"false", "true", "auto"}, 2);
    if (choice == 2) return;
    joint.is_aligned = choice == 1;
    joint.align_place = find(e, "align")->place;
  }

  // In MuJoCo, the axes of a ball joint are those of its body, so a joint that turns cannot follow it in the same body.
  void check_turns(const Body& body, const Joint& next) {
    const auto is_ball = [](const Joint& joint) { return joint.type == model::JointType::spherical; };
    if (next.type == model::JointType::prismatic || std::none_of(body.joints.begin(), body.joints.end(), is_ball))
      return;
    diagnostics_
        ->error("turn-behind-ball", next.name.place, "a hinge or ball joint follows a ball joint in the same body")
        .hint = "put it before the ball joint, or into a separate body";
  }

  void check_free_joint(const Element& joint) {
    for (const char* attribute : {"damping", "frictionloss", "armature", "stiffness", "springdamper"}) {
      const Attribute* found = find(joint, attribute);
      if (found == nullptr || !has_nonzero(*found, *diagnostics_)) continue;
      diagnostics_
          ->warning("free-joint-drive", found->place, fmt::format("the {} of a free joint is left out", attribute))
          .hint = "<freejoint/> takes no defaults of joints";
    }
  }

  // `owner` is the name of the element around it.
  void read_other(const Element& e, const std::string& owner) {
    static const std::vector<std::string> kKnown = {"body",  "joint",  "freejoint", "inertial", "site",     "geom",
                                                    "frame", "camera", "light",     "plugin",   "replicate"};
    static const std::vector<std::string> kUnsupported = {"composite", "flexcomp", "attach"};
    if (e.name == "plugin") {
      read_plugin(e, owner);
    } else if (std::find(kUnsupported.begin(), kUnsupported.end(), e.name) != kUnsupported.end()) {
      diagnostics_
          ->error(
              "unsupported-element", e.place, fmt::format("element '{}' is not supported: it generates bodies", e.name))
          .hint = "write these bodies, or let mj_saveLastXML of MuJoCo write them";
    } else if (owner != "geom" && (e.name == "camera" || e.name == "light")) {
      ++document_.ignored[e.name];
    } else {
      report_unknown(e, owner == "geom" ? std::vector<std::string>{"plugin"} : kKnown, *diagnostics_);
    }
  }

  // A plugin of a geom computes its distance to others; a plugin of a body computes forces on the body.
  void read_plugin(const Element& e, const std::string& owner) {
    if (owner == "geom") {
      ++document_.ignored["plugin"];
      return;
    }
    const Attribute* kind = find(e, "plugin");
    if (kind == nullptr) kind = find(e, "instance");
    diagnostics_->warning(
        "plugin-forces", e.place,
        fmt::format(
            "the forces of plugin '{}' on this body are not part of the dynamics", kind == nullptr ? "" : kind->value));
  }

  const Settings& settings_;
  const Defaults& defaults_;
  Document& document_;
  Diagnostics* diagnostics_;
};

}  // namespace

void read_bodies(
    const Element& worldbody,
    const Settings& settings,
    const Defaults& defaults,
    Document& document,
    Diagnostics& diagnostics) {
  BodyReader(settings, defaults, document, diagnostics).read_world(worldbody);
}

}  // namespace robcogen::import::from_mjcf
