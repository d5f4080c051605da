// The documents of tests/<room>/bad with the messages that the command line writes about them. They are unpacked to a
// folder of their own, as files that an editor opens: see ../golden.h.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "../golden.h"

namespace robcogen::test {

struct GoldenDocument {
  std::filesystem::path file;  // unpacked; a list of desired transforms lies beside its robot
  std::string room, messages;
};

class UnpackedGoldens {
 public:
  explicit UnpackedGoldens(const std::vector<std::string>& rooms) {
    namespace fs = std::filesystem;
    std::string name = (fs::temp_directory_path() / "robcogen-goldens-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    folder_ = name;
    for (const std::string& room : rooms) {
      const fs::path bad = fs::path(TEST_SOURCE_DIR).parent_path() / room / "bad";
      unpack_goldens(bad, folder_ / room);
      for (const auto& entry : fs::directory_iterator(bad)) {
        if (!entry.is_regular_file()) continue;
        const Golden golden = golden_at(entry.path());
        fs::path file = folder_ / room / entry.path().filename();
        documents.push_back({file, room, golden.messages.value_or("")});
        if (golden.list) documents.push_back({file.replace_extension(".dtdsl"), room, golden.messages.value_or("")});
      }
    }
    std::sort(documents.begin(), documents.end(), [](const GoldenDocument& a, const GoldenDocument& b) {
      return a.file < b.file;
    });
  }
  UnpackedGoldens(const UnpackedGoldens&) = delete;
  UnpackedGoldens& operator=(const UnpackedGoldens&) = delete;
  ~UnpackedGoldens() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::vector<GoldenDocument> documents;

 private:
  std::filesystem::path folder_;
};

}  // namespace robcogen::test
