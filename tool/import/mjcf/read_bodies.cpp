// Reads the tree of bodies.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/mjcf/read.h"
#include "import/mjcf/segment.h"

namespace robcogen::import::from_mjcf {

namespace {

Name name_of(const Element& element) {
  const Attribute* name = find(element, "name");
  return name == nullptr ? Name{"", element.place} : Name{name->value, name->place};
}

bool has_joint(const Element& body) {
  return std::any_of(body.children.begin(), body.children.end(), [](const Element& e) {
    return e.name == "joint" || e.name == "freejoint" || (e.name == "frame" && has_joint(e));
  });
}

// A body whose elements are being read.
struct OpenBody {
  std::size_t index = 0;
  bool moves = false;
  Element inertial;
  bool has_inertial = false;
  std::vector<PlacedElement> geoms;
};

class BodyReader {
 public:
  BodyReader(const Settings& settings, const Defaults& defaults, Document& document, Diagnostics& diagnostics)
      : settings_(settings), defaults_(defaults), document_(document), diagnostics_(diagnostics) {}

  void read_world(const Element& worldbody) {
    OpenBody world;
    read_content(worldbody, world, {}, nullptr);
    document_.ignored["geom"] += static_cast<int>(world.geoms.size());
  }

 private:
  Context context(const Attribute* childclass) { return {settings_, defaults_, diagnostics_, childclass}; }

  // `frame` is the pose of the enclosing `frame` elements, in the frame of the body.
  void read_content(const Element& parent, OpenBody& body, const Pose& frame, const Attribute* childclass) {
    for (const Element& e : parent.children) {
      if (e.name == "body") {
        read_body(e, body, frame, childclass);
      } else if (e.name == "frame") {
        const Pose pose = frame * pose_of(e, settings_, diagnostics_);
        read_content(e, body, pose, class_of_content(e, childclass));
      } else if (e.name == "joint" || e.name == "freejoint") {
        read_joint_of(e, body, frame, childclass);
      } else if (e.name == "geom") {
        body.geoms.push_back({defaults_.resolved(e, childclass), frame});
      } else if (e.name == "site") {
        const Element site = defaults_.resolved(e, childclass);
        document_.bodies[body.index].sites.push_back({name_of(e), frame * site_pose(site)});
      } else if (e.name == "inertial") {
        read_inertial(e, parent, body);
      } else {
        read_other(e);
      }
    }
  }

  const Attribute* class_of_content(const Element& element, const Attribute* outer) {
    const Attribute* own = find(element, "childclass");
    return own != nullptr && defaults_.knows(*own) ? own : outer;
  }

  // With `fromto`, the origin is the middle of the segment, and z points from the second point to the first.
  Pose site_pose(const Element& site) {
    const Attribute* type = find(site, "type");
    const std::optional<Segment> segment = read_segment(site, type == nullptr ? "sphere" : type->value, diagnostics_);
    if (segment) return {segment->middle, smallest_rotation_to_axis(segment->along)};
    return pose_of(site, settings_, diagnostics_);
  }

  void read_body(const Element& e, const OpenBody& parent, const Pose& frame, const Attribute* outer_class) {
    const Attribute* childclass = class_of_content(e, outer_class);
    OpenBody body;
    body.index = document_.bodies.size();
    body.moves = parent.moves || has_joint(e);
    Body own;
    own.name = name_of(e);
    own.parent = static_cast<int>(parent.index);
    own.pose = frame * pose_of(e, settings_, diagnostics_);
    document_.bodies.push_back(std::move(own));
    if (const Attribute* compensation = find(e, "gravcomp");
        compensation != nullptr && !Values(diagnostics_).scalar(e, "gravcomp").is_zero()) {
      diagnostics_.warning(
          "gravity-compensation", compensation->place, "the gravity compensation of this body is ignored");
    }
    read_content(e, body, {}, childclass);
    const Name name = document_.bodies[body.index].name;
    if (body.moves || settings_.scales_masses()) {
      document_.bodies[body.index].parts =
          read_parts(name, body.has_inertial ? &body.inertial : nullptr, body.geoms, context(childclass));
    }
    const bool has_mass_of_geoms = !body.has_inertial || settings_.inertia_from_geoms == InertiaFromGeoms::always;
    const std::size_t used = has_mass_of_geoms ? document_.bodies[body.index].parts.size() : 0;
    document_.ignored["geom"] += static_cast<int>(body.geoms.size() - std::min(used, body.geoms.size()));
  }

  void read_inertial(const Element& e, const Element& parent, OpenBody& body) {
    if (parent.name == "frame" || body.index == 0) {
      diagnostics_.error("misplaced-element", e.place, "an 'inertial' belongs to a body, not to this element");
    } else if (body.has_inertial) {
      diagnostics_.error("repeated-element", e.place, "this body has a second 'inertial'")
          .notes.push_back({body.inertial.place, "the first one is here"});
    } else {
      body.inertial = e;
      body.has_inertial = true;
    }
  }

  void read_joint_of(const Element& e, OpenBody& body, const Pose& frame, const Attribute* childclass) {
    if (body.index == 0) {
      diagnostics_.error("misplaced-element", e.place, "a joint belongs to a body, not to the world");
      return;
    }
    Body& own = document_.bodies[body.index];
    const bool is_freejoint = e.name == "freejoint";
    const Element joint = is_freejoint ? e : defaults_.resolved(e, childclass);
    const Attribute* type = find(joint, "type");
    const bool is_free = is_freejoint || (type != nullptr && type->value == "free");
    if (own.floats || (is_free && (own.parent != 0 || !own.joints.empty()))) {
      diagnostics_
          .error(
              "free-joint-inside", e.place, "a free joint must be the only joint of a body whose parent is the world")
          .hint = "a free-floating body is a separate robot: write it to a separate file";
    } else if (is_free) {
      own.floats = true;
      own.free_joint = e.place;
      if (!is_freejoint) check_free_joint(joint);
    } else if (std::optional<Joint> read = read_joint(joint, context(childclass))) {
      check_turns(own, *read);
      read->frame = frame;
      own.joints.push_back(std::move(*read));
    }
  }

  // In MuJoCo, the axes of a ball joint are those of its body, so a joint that turns cannot follow it in the same body.
  void check_turns(const Body& body, const Joint& next) {
    const auto is_ball = [](const Joint& joint) { return joint.type == model::JointType::spherical; };
    if (next.type == model::JointType::prismatic || std::none_of(body.joints.begin(), body.joints.end(), is_ball))
      return;
    diagnostics_
        .error("turn-behind-ball", next.name.place, "a hinge or ball joint follows a ball joint in the same body")
        .hint = "put it before the ball joint, or into a separate body";
  }

  void check_free_joint(const Element& joint) {
    for (const char* attribute : {"damping", "frictionloss", "armature", "stiffness"}) {
      const Attribute* found = find(joint, attribute);
      if (found == nullptr || !has_nonzero(*found, diagnostics_)) continue;
      diagnostics_
          .warning("free-joint-drive", found->place, fmt::format("the {} of a free joint is left out", attribute))
          .hint = "<freejoint/> takes no defaults of joints";
    }
  }

  void read_other(const Element& e) {
    static const std::vector<std::string> kKnown = {"body",  "joint",  "freejoint", "inertial", "site", "geom",
                                                    "frame", "camera", "light",     "plugin",   "user"};
    static const std::vector<std::string> kUnsupported = {"composite", "flexcomp", "replicate", "attach"};
    if (std::find(kUnsupported.begin(), kUnsupported.end(), e.name) != kUnsupported.end()) {
      diagnostics_
          .error(
              "unsupported-element", e.place, fmt::format("element '{}' is not supported: it generates bodies", e.name))
          .hint = "write these bodies, or let mj_saveLastXML of MuJoCo write them";
    } else if (e.name == "camera" || e.name == "light" || e.name == "plugin") {
      ++document_.ignored[e.name];
    } else {
      report_unknown(e, kKnown, diagnostics_);
    }
  }

  const Settings& settings_;
  const Defaults& defaults_;
  Document& document_;
  Diagnostics& diagnostics_;
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
