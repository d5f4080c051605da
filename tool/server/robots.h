// Finds the robot that a list of desired transforms is about.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server/documents.h"

namespace robcogen::server {

// Returns the name of the robot, or of the model of motions or transforms, that a text declares; empty if there is
// none.
std::string declared_name(driver::Language language, const std::shared_ptr<const Source>& source);

// Returns the files with a suffix of our languages in the folder and below, sorted. Skips hidden folders, and
// everything after the first 20,000 entries.
std::vector<std::filesystem::path> documents_below(const std::filesystem::path& folder);

class RobotFinder {
 public:
  explicit RobotFinder(const Documents& documents) : documents_(documents) {}

  void set_folders(std::vector<std::filesystem::path> folders);
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  // To be called when files may have changed.
  void forget_files() { names_.reset(); }

  // Returns the document with the list's stem in the same folder. If there is none, returns the document that declares
  // the name: one in the list's folder, or the only one among the open documents and those in the workspace folders. If
  // there are several and the list is open, returns the only open one.
  std::optional<std::filesystem::path> find(const OpenDocument& list, const std::string& name);

 private:
  const Documents& documents_;
  std::vector<std::filesystem::path> folders_;
  std::optional<std::map<std::string, std::set<std::filesystem::path>>> names_;  // declared by workspace files

  void read_names();
  bool exists(const std::filesystem::path& path) const;
  std::optional<std::filesystem::path> find_by_name(const OpenDocument& list, const std::string& name);
};

}  // namespace robcogen::server
