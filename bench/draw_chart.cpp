// Draws the measurements on a page of documentation.
//
//     draw_chart PAGE.md CHART.svg
//
// The chart has the panels of inverse and forward dynamics. Exit status: 0 success, 1 the page cannot be read, 2 usage
// or output.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "chart.h"
#include "comparison.h"
#include "page.h"

int main(int argc, char** argv) {
  using namespace robcogen::bench;
  if (argc != 3) {
    std::fputs("usage: draw_chart PAGE.md CHART.svg\n", stderr);
    return 2;
  }
  std::ifstream page(argv[1]);
  std::string drawing;
  try {
    std::vector<ChartPanel> panels = chart_panels(read_page(std::string(std::istreambuf_iterator<char>(page), {})));
    std::erase_if(panels, [](const ChartPanel& panel) { return panel.title == title("inertia_matrix"); });
    drawing = svg(panels);
  } catch (const std::runtime_error& fault) {
    std::fprintf(stderr, "draw_chart: %s: %s\n", argv[1], fault.what());
    return 1;
  }
  std::ofstream file(argv[2]);
  file << drawing;
  file.close();
  if (!file) {
    std::fprintf(stderr, "draw_chart: cannot write %s\n", argv[2]);
    return 2;
  }
}
