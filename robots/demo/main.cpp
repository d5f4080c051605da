// Simulates the HyL leg as it drops and hops, and writes a picture of it.
//
//   hop FILE.svg
#include <algorithm>
#include <fstream>
#include <iostream>

#include "hop.h"
#include "picture.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: hop FILE.svg\n";
    return 2;
  }
  const std::vector<demo::Instant> instants = demo::hop(2.28);

  std::ofstream file(argv[1]);
  file << demo::picture(instants);
  file.close();
  if (!file) {
    std::cerr << "hop: cannot write " << argv[1] << '\n';
    return 2;
  }

  const auto touchdown =
      std::find_if(instants.begin(), instants.end(), [](const demo::Instant& i) { return i.ground_force > 0; });
  double highest = 0;
  for (auto i = touchdown; i != instants.end(); ++i) highest = std::max(highest, i->foot.y());
  std::cout << "The HyL leg falls from " << instants.front().foot.y() << " m and hops up to " << highest
            << " m. Picture: " << argv[1] << '\n';
}
