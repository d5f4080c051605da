// Which robot a list of desired transforms is about.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server/documents.h"

namespace robcogen::server {

// The name of the robot, or of the model of motions or transforms, that a text declares; empty where there is none.
std::string declared_name(driver::Language language, const std::shared_ptr<const Source>& source);

// Files with a suffix of our languages in the folder and below, in order. Hidden folders are left out, and so is what
// follows the first 20,000 entries.
std::vector<std::filesystem::path> documents_below(const std::filesystem::path& folder);

class RobotFinder {
 public:
  explicit RobotFinder(const Documents& documents) : documents_(documents) {}

  void set_folders(std::vector<std::filesystem::path> folders);
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  // Files may have changed.
  void forget_files() { names_.reset(); }

  // The document of the list's stem beside it; else the one that declares the name: one beside the list, or the only
  // one among the open documents and those in the folders of the workspace. Of several, the only open one, if the list
  // is open too.
  std::optional<std::filesystem::path> find(const OpenDocument& list, const std::string& name);

 private:
  const Documents& documents_;
  std::vector<std::filesystem::path> folders_;
  std::optional<std::map<std::string, std::set<std::filesystem::path>>> names_;  // that files of the workspace declare

  void read_names();
  bool exists(const std::filesystem::path& path) const;
  std::optional<std::filesystem::path> find_by_name(const OpenDocument& list, const std::string& name);
};

}  // namespace robcogen::server
