// Writes a copy of a source in which mutants are switched at run time: each expression of the table becomes
// `(is(17) ? (mutated) : (original))`, each statement `if (is(17)) { mutated } else { original }`.
//
//     mutate TABLE TOOL_DIR FILE OUTPUT
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>

#include "table.h"

namespace robcogen::mutants {
namespace {

// A part of the source, and the mutants that change it.
struct Place {
  std::size_t size = 0;
  std::string replacement;
};

std::string label(const Mutant& m) {
  return m.file + ", mutant " + std::to_string(m.number) + ": '" + m.context + "'";
}

std::size_t position(const std::string& source, const Mutant& m) {
  const std::size_t first = source.find(m.context);
  if (first == std::string::npos) throw std::runtime_error(label(m) + " does not stand there any more");
  if (source.find(m.context, first + 1) != std::string::npos)
    throw std::runtime_error(label(m) + " stands there twice");
  return first + m.offset;
}

// `rest`: the original, or the result of other mutants of it.
std::string switched(const Mutant& m, const std::string& rest) {
  const std::string condition = "robcogen::mutants::is(" + std::to_string(m.number) + ")";
  if (m.is_statement) return "if (" + condition + ") { " + m.mutated + " } else { " + rest + " }";
  return "(" + condition + " ? (" + m.mutated + ") : (" + rest + "))";
}

std::string rewritten(const std::string& source, const std::vector<Mutant>& mutants, const std::string& file) {
  std::map<std::size_t, Place> places;
  for (const Mutant& m : mutants) {
    if (m.file != file) continue;
    const auto [place, is_new] = places.try_emplace(position(source, m), Place{m.original.size(), m.original});
    if (place->second.size != m.original.size()) throw std::runtime_error(label(m) + " overlaps another mutant");
    place->second.replacement = switched(m, place->second.replacement);
  }
  std::string result;
  std::size_t end = 0;
  for (const auto& [begin, place] : places) {
    if (begin < end) throw std::runtime_error(file + ": two mutants overlap at '" + place.replacement + "'");
    result += source.substr(end, begin - end) + place.replacement;
    end = begin + place.size;
  }
  return result + source.substr(end);
}

}  // namespace
}  // namespace robcogen::mutants

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: mutate TABLE TOOL_DIR FILE OUTPUT\n";
    return 2;
  }
  try {
    const std::string file = argv[3], path = std::string(argv[2]) + "/" + file;
    const std::string source = robcogen::mutants::read_file(path);
    const std::string text = robcogen::mutants::rewritten(source, robcogen::mutants::read_table(argv[1]), file);
    std::ofstream output(argv[4], std::ios::binary);
    output << "#include \"active.h\"\n#line 1 \"" << path << "\"\n" << text;
    return output.flush() ? 0 : 2;
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
