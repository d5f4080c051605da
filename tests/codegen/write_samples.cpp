// write_samples DIR: the generated code of all samples.
#include <iostream>

#include "backend/cpp/cpp.h"
#include "samples.h"
#include "support/files.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_samples DIR\n";
    return 2;
  }
  for (const robcogen::backend::Library& library : robcogen::test::samples()) {
    std::string error;
    if (!robcogen::write_files_if_changed(argv[1], robcogen::backend::cpp::print(library), error)) {
      std::cerr << error << '\n';
      return 2;
    }
  }
}
