#include "backend/common/parts.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace robcogen::backend {
namespace {

using Names = std::set<std::string>;

// What a part costs beside its lines, in values handed on: the call.
constexpr std::size_t kCall = 8;

// The lines of one section, or of several.
struct Stretch {
  std::size_t begin = 0, end = 0;

  std::size_t size() const { return end - begin; }
};

bool is_definition(const Line& line) {
  using Kind = Line::Kind;
  return line.kind == Kind::definition || line.kind == Kind::sincos || line.kind == Kind::sincos_of ||
         line.kind == Kind::pick;
}

void add_words(std::string_view text, Names& words) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end > begin) words.emplace(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

// The words of a line: what it reads, calls and stores to.
void add_words(const Line& line, Names& words) {
  if (line.kind == Line::Kind::section) return;
  add_words(line.expression, words);
  for (const std::string& value : line.values) add_words(value, words);
  if (is_definition(line) || line.kind == Line::Kind::binding || line.kind == Line::Kind::load_block) return;
  for (const std::string& target : line.targets) add_words(target, words);
}

std::vector<Stretch> sections(const std::vector<Line>& lines) {
  std::vector<Stretch> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (result.empty() || lines[i].kind == Line::Kind::section) result.push_back({i, i});
    result.back().end = i + 1;
  }
  return result;
}

class Cutting {
 public:
  Cutting(const Kernel& kernel, std::size_t longest, const Dialect& dialect)
      : kernel_(kernel), longest_(longest), dialect_(dialect) {
    for (const Line& line : kernel.lines) {
      using Kind = Line::Kind;
      (line.kind == Kind::binding ? bindings_ : line.kind == Kind::load_block ? blocks_ : lines_).push_back(line);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (is_definition(lines_[i]))
        for (const std::string& name : lines_[i].targets) defined_.emplace(name, i);
  }

  Parts run() {
    const std::vector<Stretch> stretches = cut();
    std::vector<Names> read;  // by part: values of other parts
    for (const Stretch& s : stretches) read.push_back(read_from_before(s));
    choose_elements(stretches, read);
    Parts result;
    for (const auto& [width, size] : sizes_) result.handed.push_back({array(width), size});
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      result.kernels.push_back(part(stretches[k], read[k], result.handed));
      result.kernels.back().name = kernel_.name + "_" + std::to_string(k + 1);
    }
    return result;
  }

 private:
  const Kernel& kernel_;
  std::size_t longest_;
  const Dialect& dialect_;
  std::vector<Line> bindings_, blocks_;         // of inputs: in each part that reads them
  std::vector<Line> lines_;                     // all others
  std::map<std::string, std::size_t> defined_;  // where in lines_ a name is
  std::map<std::string, std::string> element_;  // where a value that is handed on stands
  std::map<int, std::size_t> sizes_;            // of the arrays, by width

  static Parameter array(int width) {
    Parameter p{width == 1 ? "kept" : "kept_" + std::to_string(width), true};
    p.width = width;
    return p;
  }

  Names read_from_before(const Stretch& s) const {
    Names result;
    for (std::size_t i = s.begin; i < s.end; ++i) add_words(lines_[i], result);
    std::erase_if(result, [&](const std::string& word) {
      const auto place = defined_.find(word);
      return place == defined_.end() || place->second >= s.begin;
    });
    return result;
  }

  // The stretches that hand on least in sum, by dynamic programming over their ends.
  std::vector<Stretch> cut() const {
    const std::vector<Stretch> all = sections(lines_);
    std::vector<Names> read;
    for (const Stretch& s : all) read.push_back(read_from_before(s));
    std::vector<std::size_t> cost(all.size() + 1, std::numeric_limits<std::size_t>::max()), from(all.size() + 1, 0);
    cost[0] = 0;
    for (std::size_t end = 1; end <= all.size(); ++end) {
      Names values;
      for (std::size_t begin = end; begin-- > 0;) {
        if (begin + 1 < end && all[end - 1].end - all[begin].begin > longest_) break;
        values.insert(read[begin].begin(), read[begin].end());
        std::erase_if(values, [&](const std::string& name) { return defined_.at(name) >= all[begin].begin; });
        const std::size_t sum = cost[begin] + values.size() + kCall;
        if (sum >= cost[end]) continue;
        cost[end] = sum;
        from[end] = begin;
      }
    }
    std::vector<Stretch> result;
    for (std::size_t end = all.size(); end > 0; end = from[end])
      result.push_back({all[from[end]].begin, all[end - 1].end});
    std::reverse(result.begin(), result.end());
    return result;
  }

  // An element is free for another value after the part that reads it last.
  void choose_elements(const std::vector<Stretch>& stretches, const std::vector<Names>& read) {
    std::map<std::string, std::size_t> last;
    for (std::size_t k = 0; k < read.size(); ++k)
      for (const std::string& name : read[k]) last[name] = k;
    std::map<int, std::vector<std::size_t>> free;                             // by width
    std::vector<std::vector<std::pair<int, std::size_t>>> ends(read.size());  // by part
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      for (std::size_t i = stretches[k].begin; i < stretches[k].end; ++i) {
        if (!is_definition(lines_[i])) continue;
        const int width = lines_[i].width;
        for (const std::string& name : lines_[i].targets) {
          const auto end = last.find(name);
          if (end == last.end()) continue;
          std::vector<std::size_t>& unused = free[width];
          if (unused.empty()) unused.push_back(sizes_[width]++);
          element_[name] = dialect_.element(array(width).name, unused.back());
          ends[end->second].emplace_back(width, unused.back());
          unused.pop_back();
        }
      }
      for (const auto& [width, element] : ends[k]) free[width].push_back(element);
    }
  }

  // The values in the order in which they were defined, by their names.
  std::vector<Line> bindings(const Names& values) const {
    std::map<std::size_t, Line> result;
    for (const std::string& value : values) {
      const std::size_t place = defined_.at(value);
      result[place * 2 + (lines_[place].targets.front() == value ? 0 : 1)] = {
          Line::Kind::binding, {value}, element_.at(value), 0, lines_[place].width};
    }
    std::vector<Line> lines;
    for (auto& [place, line] : result) lines.push_back(std::move(line));
    return lines;
  }

  Kernel part(const Stretch& s, const Names& read, const std::vector<Handed>& handed) const {
    Kernel part;
    part.lines = bindings(read);
    std::vector<Line> blocks = blocks_;
    for (std::size_t i = s.begin; i < s.end; ++i) {
      Names words;
      add_words(lines_[i], words);
      std::erase_if(blocks, [&](const Line& block) {
        const bool is_read = words.count(block.targets.front()) > 0;
        if (is_read) part.lines.push_back(block);
        return is_read;
      });
      part.lines.push_back(lines_[i]);
      if (!is_definition(lines_[i])) continue;
      for (const std::string& value : lines_[i].targets)
        if (const auto element = element_.find(value); element != element_.end())
          part.lines.push_back({Line::Kind::store, {element->second}, value});
    }
    Names words;
    for (const Line& line : part.lines) add_words(line, words);
    const auto is_used = [&](const std::string& word) { return words.count(word) > 0; };
    std::vector<Line> elements;
    for (const Line& binding : bindings_) {
      if (!is_used(binding.targets.front())) continue;
      elements.push_back(binding);
      add_words(binding, words);
    }
    part.lines.insert(part.lines.begin(), elements.begin(), elements.end());
    for (const Parameter& p : kernel_.parameters)
      if (is_used(p.name)) part.parameters.push_back(p);
    for (const Handed& h : handed)
      if (is_used(h.array.name)) part.parameters.push_back(h.array);
    std::copy_if(kernel_.functions.begin(), kernel_.functions.end(), std::back_inserter(part.functions), is_used);
    for (const int width : kernel_.widths) {
      const auto says_width = [&](const Line& line) {
        using Kind = Line::Kind;
        return line.width == width &&
               (line.kind == Kind::definition || line.kind == Kind::binding || line.kind == Kind::sincos_of);
      };
      if (is_used(dialect_.type(width)) || std::any_of(part.lines.begin(), part.lines.end(), says_width))
        part.widths.push_back(width);
    }
    return part;
  }
};

}  // namespace

Parts in_parts(const Kernel& kernel, std::size_t longest, const Dialect& dialect) {
  return Cutting(kernel, longest, dialect).run();
}

}  // namespace robcogen::backend
