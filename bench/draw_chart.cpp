// Draws the measurements on a page of documentation.
//
//     draw_chart FIGURES.md CHART.svg                 run-time libraries
//     draw_chart --generators README.md CHART.svg     other generators of code
//
// The chart has the panels of inverse and forward dynamics. Exit status: 0 success, 1 the page cannot be read, 2 usage
// or output.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "chart.h"
#include "comparison.h"
#include "page.h"

int main(int argc, char** argv) {
  using namespace robcogen::bench;
  const bool of_generators = argc == 4 && std::strcmp(argv[1], "--generators") == 0;
  if (argc != 3 && !of_generators) {
    std::fputs("usage: draw_chart [--generators] PAGE.md CHART.svg\n", stderr);
    return 2;
  }
  const char* const input = argv[argc - 2];
  const char* const output = argv[argc - 1];
  std::ifstream page(input);
  std::string drawing;
  try {
    const std::string text(std::istreambuf_iterator<char>(page), {});
    std::vector<ChartPanel> panels = chart_panels(
        of_generators ? read_generators(text, {"RobCoGen 5.0.1", "Pinocchio with CppADCodeGen"}) : read_page(text));
    std::erase_if(panels, [](const ChartPanel& panel) { return panel.title == title("inertia_matrix"); });
    drawing = svg(panels);
  } catch (const std::runtime_error& fault) {
    std::fprintf(stderr, "draw_chart: %s: %s\n", input, fault.what());
    return 1;
  }
  std::ofstream file(output);
  file << drawing;
  file.close();
  if (!file) {
    std::fprintf(stderr, "draw_chart: cannot write %s\n", output);
    return 2;
  }
}
