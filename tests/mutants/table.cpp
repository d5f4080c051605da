#include "table.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace robcogen::mutants {
namespace {

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  std::vector<Mutant> read() {
    std::istringstream lines(read_file(path_));
    for (std::string line; std::getline(lines, line);) {
      ++number_;
      read(line);
    }
    if (is_open_) fail("a mutant without what it changes to");
    return std::move(mutants_);
  }

 private:
  std::string path_;
  int number_ = 0;
  std::string file_;
  std::vector<Killer> killers_;
  bool killers_end_ = true;  // the next `killed by` begins another list
  bool is_open_ = false;     // the last mutant has an original only
  std::vector<Mutant> mutants_;

  [[noreturn]] void fail(const std::string& message) const {
    throw std::runtime_error(path_ + ":" + std::to_string(number_) + ": " + message);
  }

  static bool take(std::string& line, const std::string& head) {
    if (line.rfind(head, 0) != 0) return false;
    line.erase(0, head.size());
    return true;
  }

  void read(std::string line) {
    if (line.empty() || line[0] == '#') return;
    const bool is_statement = line.rfind("-s ", 0) == 0 || line.rfind("+s ", 0) == 0;
    if (take(line, "file ")) {
      file_ = line;
    } else if (take(line, "killed by ")) {
      if (killers_end_) killers_.clear();
      killers_end_ = false;
      const std::size_t blank = line.find(' ');
      if (blank == std::string::npos) fail("`killed by` names a program and its tests");
      killers_.push_back({line.substr(0, blank), line.substr(blank + 1)});
    } else if (take(line, "- ") || take(line, "-s ")) {
      open(line, is_statement);
    } else if (take(line, "+ ") || take(line, "+s ")) {
      if (!is_open_ || mutants_.back().is_statement != is_statement) fail("what is changed should stand before this");
      mutants_.back().mutated = line;
      is_open_ = false;
    } else {
      fail("neither file, killed by, - nor +");
    }
  }

  void open(const std::string& line, bool is_statement) {
    if (is_open_) fail("a mutant without what it changes to");
    if (file_.empty() || killers_.empty()) fail("a mutant needs a file and tests that kill it");
    killers_end_ = true;
    is_open_ = true;
    Mutant& m = mutants_.emplace_back();
    m.number = static_cast<int>(mutants_.size());
    m.file = file_;
    m.killers = killers_;
    m.is_statement = is_statement;
    m.context = m.original = line;
    const std::size_t begin = line.find('@'), end = line.rfind('@');
    if (begin == std::string::npos) return;
    if (begin == end) fail("one mark: @ stands before and after the expression");
    m.original = line.substr(begin + 1, end - begin - 1);
    m.offset = begin;
    m.context = line.substr(0, begin) + m.original + line.substr(end + 1);
  }
};

}  // namespace

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Mutant> read_table(const std::string& path) {
  return Reader(path).read();
}

}  // namespace robcogen::mutants
