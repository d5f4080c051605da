// Writes the parts of golden files (golden.h) to a folder, one file each, as seeds of libFuzzer.
//
// seeds target folders…
#include <algorithm>

#include "../golden.h"

int main(int count, char** arguments) {
  namespace fs = std::filesystem;
  if (count < 3) return 1;
  const fs::path target = arguments[1];
  fs::create_directories(target);
  int written = 0;
  for (int i = 2; i < count; ++i) {
    for (const auto& entry : fs::recursive_directory_iterator(arguments[i])) {
      if (!entry.is_regular_file()) continue;
      for (const std::string& part : robcogen::test::parts_of(robcogen::test::golden_at(entry.path())))
        std::ofstream(target / std::to_string(written++), std::ios::binary) << part;
    }
  }
  return 0;
}
