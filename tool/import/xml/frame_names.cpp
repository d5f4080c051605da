#include "import/xml/frame_names.h"

#include <fmt/format.h>

#include <map>
#include <string>

#include "support/unique_names.h"

namespace robcogen::import {
namespace {

// The owner of each frame that the model makes, as in "link 'hip'".
std::map<std::string, std::string> implicit_frames(const model::Description& description) {
  std::map<std::string, std::string> owners;
  const auto add = [&](const char* kind, const std::string& name) {
    owners.emplace(model::implicit_frame_name(name), fmt::format("{} '{}'", kind, name));
  };
  add("link", description.base.name);
  for (const model::DescribedLink& link : description.links) add("link", link.name);
  for (const model::DescribedJoint& joint : description.joints) add("joint", joint.name);
  return owners;
}

}  // namespace

void rename_hidden_frames(model::Description& description, Diagnostics& diagnostics) {
  const std::map<std::string, std::string> owners = implicit_frames(description);
  const auto for_each_frame = [&](const auto& visit) {
    for (model::DescribedFrame& frame : description.base.frames) visit(frame);
    for (model::DescribedLink& link : description.links)
      for (model::DescribedFrame& frame : link.frames) visit(frame);
  };
  UniqueNames taken;
  for (const auto& [name, owner] : owners) taken.reserve(name);
  for_each_frame([&](const model::DescribedFrame& frame) { taken.reserve(frame.name); });
  std::map<std::string, std::string> renamed;
  for_each_frame([&](model::DescribedFrame& frame) {
    const auto owner = owners.find(frame.name);
    if (owner == owners.end()) return;
    const std::string name = taken.add(frame.name + "_frame");
    diagnostics.note(
        "frame-renamed", frame.place,
        fmt::format("frame '{}' becomes '{}': '{}' is the frame of {}", frame.name, name, frame.name, owner->second));
    renamed.emplace(frame.name, name);
    frame.name = name;
  });
  const auto rename_ends = [&](auto& elements) {
    for (auto& element : elements)
      for (std::string& frame : element.frames)
        if (const auto found = renamed.find(frame); found != renamed.end()) frame = found->second;
  };
  rename_ends(description.loops);
  rename_ends(description.actuators);
}

}  // namespace robcogen::import
