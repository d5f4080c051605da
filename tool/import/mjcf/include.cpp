#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "import/mjcf/element.h"
#include "import/xml/xml.h"
#include "support/files.h"

namespace robcogen::import::from_mjcf {

namespace {

namespace fs = std::filesystem;

// Replaces the prefix of a message such as `path: error: cannot read the file`.
std::string without_prefix(const std::string& fault, const fs::path& path) {
  const std::string marker = ": error: ";
  const std::size_t at = fault.find(marker);
  return fmt::format(
      "file '{}': {}", path.string(), at == std::string::npos ? fault : fault.substr(at + marker.size()));
}

class IncludeReader {
 public:
  IncludeReader(fs::path folder, std::vector<fs::path>& included, Diagnostics& diagnostics)
      : folder_(std::move(folder)), included_(included), diagnostics_(diagnostics) {}

  std::optional<Element> read(const std::shared_ptr<const Source>& source) {
    const std::optional<xml::Element> root = xml::read(source, diagnostics_);
    if (!root) return std::nullopt;
    Element result;
    return copy(*root, source, result) ? std::optional(std::move(result)) : std::nullopt;
  }

  // Marks `path` as open.
  void enter(const fs::path& path, const Place& place) {
    files_.push_back({path.lexically_normal(), target_of(path), place, true});
  }

 private:
  struct File {
    fs::path name;
    fs::path target;  // without symbolic links
    Place place;      // of the file name in the element that includes it
    bool is_open = false;
  };

  static fs::path target_of(const fs::path& path) {
    std::error_code fault;
    const fs::path canonical = fs::weakly_canonical(path, fault);
    return fault ? path : canonical;
  }

  // Returns a file that this path would repeat; nullptr if there is none. As in MuJoCo, several symbolic links to one
  // file are different files. An open file, however, cannot contain itself by any name.
  const File* repeated_by(const fs::path& path) const {
    const fs::path target = target_of(path);
    const auto found = std::find_if(files_.begin(), files_.end(), [&](const File& file) {
      return file.name == path || (file.is_open && file.target == target);
    });
    return found == files_.end() ? nullptr : &*found;
  }

  // Copies an element. Returns whether everything that it includes could be read.
  bool copy(const xml::Element& from, const std::shared_ptr<const Source>& source, Element& to) {
    to = xml::located_tag(from, source);
    for (const xml::Element& child : from.children) {
      Element copied;
      if (!copy(child, source, copied)) return false;
      if (child.name != "include") {
        to.children.push_back(std::move(copied));
      } else if (!include(copied, to)) {
        return false;
      }
    }
    return true;
  }

  bool refuse(const std::string& code, const Place& place, const std::string& message) {
    diagnostics_.error(code, place, message);
    return false;
  }

  // Returns the path in the folder of the model, or else in that of the file that includes it, as MuJoCo does.
  fs::path path_of(const std::string& name) const {
    const fs::path path = (folder_ / name).lexically_normal();
    std::error_code fault;
    if (including_.empty() || fs::exists(path, fault)) return path;
    const fs::path beside = (including_.back().parent_path() / name).lexically_normal();
    return fs::exists(beside, fault) ? beside : path;
  }

  bool include(const Element& element, Element& parent) {
    const Attribute* name = find(element, "file");
    if (name == nullptr) return refuse("missing-attribute", element.place, "this 'include' has no attribute 'file'");
    const fs::path path = path_of(name->value);
    if (const File* known = repeated_by(path)) {
      const std::string what = known->is_open ? "includes itself" : "is included twice";
      Diagnostic& error = diagnostics_.error(
          known->is_open ? "include-cycle" : "included-twice", name->place,
          fmt::format("file '{}' {}", name->value, what));
      if (known->place.source) error.notes.push_back({known->place, "first included here"});
      return false;
    }
    std::string fault;
    std::optional<std::string> text = read_file(path, fault);
    if (!text) return refuse("unreadable-include", name->place, without_prefix(fault, path));
    const std::size_t index = files_.size();
    enter(path, name->place);
    included_.push_back(path);
    including_.push_back(path);
    std::optional<Element> root = read(std::make_shared<Source>(path.string(), std::move(*text)));
    including_.pop_back();
    files_[index].is_open = false;
    if (!root) return false;
    if (root->name != "mujocoinclude" && root->name != "mujoco") {
      return refuse(
          "not-mjcf", root->place,
          fmt::format("the root element of an included file is 'mujocoinclude' or 'mujoco', not '{}'", root->name));
    }
    for (Element& child : root->children) parent.children.push_back(std::move(child));
    return true;
  }

  fs::path folder_;
  std::vector<fs::path> including_;  // included files that are open, the outermost first
  std::vector<fs::path>& included_;
  Diagnostics& diagnostics_;
  std::vector<File> files_;
};

}  // namespace

std::optional<Element> read_with_includes(
    const std::shared_ptr<const Source>& source,
    const fs::path& file,
    std::vector<fs::path>& included,
    Diagnostics& diagnostics) {
  IncludeReader reader(file.parent_path(), included, diagnostics);
  reader.enter(file, {});
  return reader.read(source);
}

}  // namespace robcogen::import::from_mjcf
