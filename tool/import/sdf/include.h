// Files that `include` names.
#pragma once

#include <memory>
#include <set>

#include "import/sdf/read.h"

namespace robcogen::import::from_sdf {

// A file that was included, with its only model.
struct IncludedFile {
  Element root;
  const Element* model = nullptr;  // in `root`; nullptr if the file has lights or actors only
  FileContext context;
  std::filesystem::path path;
};

class Includer {
 public:
  Includer(
      const std::filesystem::path& file,
      const std::vector<std::filesystem::path>& folders,
      std::vector<std::filesystem::path>& included,
      Diagnostics& diagnostics);

  // Returns the file of an `include` in a file in this folder: the path of its `uri`, or what `model.config` or
  // `model.sdf` of that folder is. nullptr for a file that cannot be read, which is an error or, with `may_fail`, a
  // warning. The file stays open, so that it cannot include itself, until `close`.
  std::shared_ptr<const IncludedFile> open(
      const Element& include,
      const std::filesystem::path& folder,
      bool may_fail,
      ElementReader& reader);
  void close() { open_.pop_back(); }
  void reopen(const IncludedFile& file);

 private:
  std::vector<std::filesystem::path> open_;  // the outermost first
  const std::vector<std::filesystem::path>& folders_;
  std::vector<std::filesystem::path>& included_;
  Diagnostics& diagnostics_;
  std::size_t count_ = 0;
  std::set<std::filesystem::path> checked_;  // files whose unknown names were reported

  std::optional<std::filesystem::path> path_of(const Attribute& uri, const std::filesystem::path& folder);
  std::shared_ptr<const IncludedFile> read(const std::filesystem::path& path, const Attribute& uri, bool may_fail);
};

}  // namespace robcogen::import::from_sdf
