// Checks the document with urdfdom, the reader that most programs use: they cannot read what urdfdom refuses.
#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <utility>

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

namespace {

// During its lifetime, collects the messages of urdfdom instead of writing them to the console.
class Listener : public console_bridge::OutputHandler {
 public:
  Listener() { console_bridge::useOutputHandler(this); }
  ~Listener() override { console_bridge::restorePreviousOutputHandler(); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) errors.push_back(text);
  }

  std::vector<std::string> errors;
};

std::string quoted(const std::string& text) {
  std::string escaped;
  TiXmlBase::EncodeString(text, &escaped);
  return fmt::format("\"{}\"", escaped);
}

std::string quoted(const std::array<Number, 3>& v) {
  return fmt::format(
      "\"{} {} {}\"", print_double(v[0].value()), print_double(v[1].value()), print_double(v[2].value()));
}

std::string quoted(const Number& n) {
  return fmt::format("\"{}\"", print_double(n.value()));
}

std::string text_of(const Origin& origin) {
  return fmt::format("<origin xyz={} rpy={}/>", quoted(origin.xyz), quoted(origin.rpy));
}

std::string text_of(const Link& link) {
  if (!link.inertial) return fmt::format("<link name={}/>\n", quoted(link.name.text));
  const Inertial& i = *link.inertial;
  return fmt::format(
      "<link name={}><inertial>{}<mass value={}/><inertia ixx={} ixy={} ixz={} iyy={} iyz={} "
      "izz={}/></inertial></link>\n",
      quoted(link.name.text), text_of(i.origin), quoted(i.mass), quoted(i.ixx), quoted(i.ixy), quoted(i.ixz),
      quoted(i.iyy), quoted(i.iyz), quoted(i.izz));
}

// urdfdom requires a limit with effort and velocity.
std::string text_of(const Limit& limit) {
  std::string text = "<limit";
  if (limit.lower) text += fmt::format(" lower={}", quoted(*limit.lower));
  if (limit.upper) text += fmt::format(" upper={}", quoted(*limit.upper));
  return text + fmt::format(
                    " effort={} velocity={}/>", quoted(limit.effort.value_or(Number())),
                    quoted(limit.velocity.value_or(Number())));
}

std::string text_of(const Joint& joint) {
  std::string text = fmt::format(
      "<joint name={} type={}><parent link={}/><child link={}/>{}", quoted(joint.name.text),
      quoted(std::string(name_of(joint.type))), quoted(joint.parent.text), quoted(joint.child.text),
      text_of(joint.origin));
  if (is_movable(joint))
    text += fmt::format("<axis xyz={}/>{}", quoted(joint.axis), text_of(joint.limit.value_or(Limit())));
  if (joint.mimic) text += fmt::format("<mimic joint={}/>", quoted(joint.mimic->joint.text));
  return text + "</joint>\n";
}

// Contains only the elements that are read, so that a broken mesh does not prevent the generation of dynamics.
std::string text_of(const Document& document) {
  std::string text = fmt::format("<robot name={}>\n", quoted(document.name.text));
  for (const Link& link : document.links) text += text_of(link);
  for (const Joint& joint : document.joints) text += text_of(joint);
  return text + "</robot>\n";
}

// Returns the place of the element that the message names, or else of the robot.
Place place_of(const std::string& message, const Document& document) {
  const auto names = [&](const Name& name) {
    return message.find(fmt::format("'{}'", name.text)) != std::string::npos ||
           message.find(fmt::format("[{}]", name.text)) != std::string::npos;
  };
  for (const Joint& joint : document.joints)
    if (names(joint.name)) return joint.name.place;
  for (const Link& link : document.links)
    if (names(link.name)) return link.name.place;
  return document.name.place;
}

model::JointLimits limits_of(const Joint& joint, const urdf::JointLimits& read) {
  using model::bounded;
  model::JointLimits limits;
  if (!joint.limit) return limits;
  if (joint.type != JointType::continuous) limits.lower = bounded(read.lower), limits.upper = bounded(read.upper);
  if (joint.limit->effort) limits.effort = bounded(read.effort);
  if (joint.limit->velocity) limits.velocity = bounded(read.velocity);
  return limits;
}

}  // namespace

std::vector<model::JointLimits> read_limits(const Document& document, Diagnostics& diagnostics) {
  std::vector<std::string> errors;
  urdf::ModelInterfaceSharedPtr read;
  {
    Listener listener;
    read = urdf::parseURDF(text_of(document));
    errors = std::move(listener.errors);
  }
  if (!read && errors.empty()) errors.emplace_back("no reason given");
  for (const std::string& error : errors) {
    diagnostics.error("urdfdom", place_of(error, document), fmt::format("urdfdom rejects this robot: {}", error));
  }
  if (!errors.empty()) return {};

  std::vector<model::JointLimits> limits;
  for (const Joint& joint : document.joints) {
    const urdf::JointConstSharedPtr found = read->getJoint(joint.name.text);
    limits.push_back(found && found->limits ? limits_of(joint, *found->limits) : model::JointLimits());
  }
  // A link owns its children: without this, freeing a long chain would recurse as deep as the chain is long.
  for (const auto& [name, link] : read->links_) {
    link->child_links.clear();
    link->child_joints.clear();
  }
  return limits;
}

}  // namespace robcogen::import::from_urdf
