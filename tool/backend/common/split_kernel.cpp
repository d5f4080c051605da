#include "backend/common/split_kernel.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace robcogen::backend {
namespace {

// The cost of a call, expressed as a number of values passed on.
constexpr std::size_t kCall = 8;

// The lines of one section, or of several consecutive ones.
struct Segment {
  std::size_t begin = 0, end = 0;
};

bool is_definition(const Line& line) {
  using Kind = Line::Kind;
  return line.kind == Kind::definition || line.kind == Kind::sincos || line.kind == Kind::sincos_of ||
         line.kind == Kind::pick;
}

// Numbers the names. The map is never iterated, so that it decides no order.
class Vocabulary {
 public:
  static constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

  std::size_t add(std::string_view name) { return numbers_.try_emplace(name, numbers_.size()).first->second; }
  std::size_t find(std::string_view name) const {
    const auto found = numbers_.find(name);
    return found == numbers_.end() ? kUnknown : found->second;
  }
  std::size_t size() const { return numbers_.size(); }

 private:
  std::unordered_map<std::string_view, std::size_t> numbers_;
};

// A line of the kernel, and the numbers of the names that it refers to.
struct NumberedLine {
  const Line* line = nullptr;
  std::vector<std::size_t> names = {};
};

NumberedLine numbered(const Line& line, Vocabulary& vocabulary) {
  NumberedLine result{&line};
  for (const std::string& name : line.names) result.names.push_back(vocabulary.add(name));
  return result;
}

std::vector<Segment> sections(const std::vector<NumberedLine>& lines) {
  std::vector<Segment> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (result.empty() || lines[i].line->kind == Line::Kind::section) result.push_back({i, i});
    result.back().end = i + 1;
  }
  return result;
}

// A value that a line defines.
struct Value {
  std::string name;
  int width = 1;
  std::string element = {};  // the array element that holds it between parts, if it is live there
};

// Ascending indices of values.
using Values = std::vector<std::size_t>;

class KernelSplitter {
 public:
  KernelSplitter(const Kernel& kernel, std::size_t longest, const Dialect& dialect)
      : kernel_(kernel), longest_(longest), dialect_(dialect) {
    for (const Line& line : kernel.lines) {
      using Kind = Line::Kind;
      (line.kind == Kind::binding      ? bindings_
       : line.kind == Kind::load_block ? blocks_
                                       : lines_)
          .push_back(numbered(line, vocabulary_));
    }
    for (const NumberedLine& l : lines_) {
      first_value_.push_back(values_.size());
      if (!is_definition(*l.line)) continue;
      for (const std::string& name : l.line->targets) values_.push_back({name, l.line->width});
    }
    first_value_.push_back(values_.size());
    value_of_name_.resize(vocabulary_.size(), values_.size());
    for (std::size_t v = 0; v < values_.size(); ++v)
      if (const std::size_t number = vocabulary_.find(values_[v].name); number != Vocabulary::kUnknown)
        value_of_name_[number] = v;
  }

  SplitKernel run() {
    const std::vector<Segment> segments = cut();
    std::vector<Values> read;  // by part: values defined in parts before it
    for (const Segment& s : segments) read.push_back(read_from_before(s));
    choose_elements(segments, read);
    SplitKernel result;
    for (const auto& [width, size] : sizes_) result.live.push_back({array(width), size});
    for (std::size_t k = 0; k < segments.size(); ++k) {
      result.parts.push_back(part(segments[k], read[k], result.live));
      result.parts.back().name = kernel_.name + "_" + std::to_string(k + 1);
    }
    return result;
  }

 private:
  const Kernel& kernel_;
  std::size_t longest_;
  const Dialect& dialect_;
  Vocabulary vocabulary_;
  std::vector<NumberedLine> bindings_, blocks_;  // of inputs: repeated in each part that reads them
  std::vector<NumberedLine> lines_;              // all others
  std::vector<Value> values_;                    // in the order of the lines
  std::vector<std::size_t> first_value_;         // by line, and one past the last: how many values are defined before
  std::vector<std::size_t> value_of_name_;       // by name; values_.size(): none
  std::map<int, std::size_t> sizes_;             // of the arrays, by width

  static KernelArray array(int width) {
    KernelArray p{width == 1 ? "kept" : "kept_" + std::to_string(width), true};
    p.width = width;
    return p;
  }

  Values read_from_before(const Segment& s) const {
    Values result;
    for (std::size_t i = s.begin; i < s.end; ++i)
      for (const std::size_t name : lines_[i].names)
        if (value_of_name_[name] < first_value_[s.begin]) result.push_back(value_of_name_[name]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // The runs of sections that pass on the fewest values in total, by dynamic programming over their ends.
  std::vector<Segment> cut() const {
    const std::vector<Segment> all = sections(lines_);
    std::vector<Values> read;
    for (const Segment& s : all) read.push_back(read_from_before(s));
    std::vector<std::size_t> cost(all.size() + 1, std::numeric_limits<std::size_t>::max()), from(all.size() + 1, 0);
    cost[0] = 0;
    for (std::size_t end = 1; end <= all.size(); ++end) {
      std::vector<bool> is_read(values_.size(), false);  // values that the run reads from before it
      std::size_t count = 0;
      const auto set = [&](std::size_t value, bool to) {
        if (is_read[value] == to) return;
        is_read[value] = to;
        count = to ? count + 1 : count - 1;
      };
      for (std::size_t begin = end; begin-- > 0;) {
        if (begin + 1 < end && all[end - 1].end - all[begin].begin > longest_) break;
        for (std::size_t v = first_value_[all[begin].begin]; v < first_value_[all[begin].end]; ++v) set(v, false);
        for (const std::size_t v : read[begin]) set(v, true);
        const std::size_t sum = cost[begin] + count + kCall;
        if (sum >= cost[end]) continue;
        cost[end] = sum;
        from[end] = begin;
      }
    }
    std::vector<Segment> result;
    for (std::size_t end = all.size(); end > 0; end = from[end])
      result.push_back({all[from[end]].begin, all[end - 1].end});
    std::reverse(result.begin(), result.end());
    return result;
  }

  // An element becomes free for another value after the last part that reads its value.
  void choose_elements(const std::vector<Segment>& segments, const std::vector<Values>& read) {
    constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> last(values_.size(), kNever);  // part that reads the value
    for (std::size_t k = 0; k < read.size(); ++k)
      for (const std::size_t v : read[k]) last[v] = k;
    std::map<int, std::vector<std::size_t>> free;                             // by width
    std::vector<std::vector<std::pair<int, std::size_t>>> ends(read.size());  // by part
    for (std::size_t k = 0; k < segments.size(); ++k) {
      for (std::size_t v = first_value_[segments[k].begin]; v < first_value_[segments[k].end]; ++v) {
        if (last[v] == kNever) continue;
        const int width = values_[v].width;
        std::vector<std::size_t>& unused = free[width];
        if (unused.empty()) unused.push_back(sizes_[width]++);
        values_[v].element = dialect_.element(array(width).name, unused.back());
        ends[last[v]].emplace_back(width, unused.back());
        unused.pop_back();
      }
      for (const auto& [width, element] : ends[k]) free[width].push_back(element);
    }
  }

  Kernel part(const Segment& s, const Values& read, const std::vector<LiveValues>& live) const {
    Kernel part;
    std::vector<bool> is_read(vocabulary_.size(), false);  // by name
    std::set<int> live_widths;
    const auto note = [&](const NumberedLine& line) {
      for (const std::size_t name : line.names) is_read[name] = true;
    };
    const auto is_used = [&](const std::string& name) {
      const std::size_t number = vocabulary_.find(name);
      return number != Vocabulary::kUnknown && is_read[number];
    };
    for (const std::size_t v : read) {
      const Value& value = values_[v];
      part.lines.push_back({Line::Kind::binding, {value.name}, value.element, 0, value.width});
      live_widths.insert(value.width);
    }
    std::vector<const NumberedLine*> blocks;
    for (const NumberedLine& block : blocks_) blocks.push_back(&block);
    for (std::size_t i = s.begin; i < s.end; ++i) {
      note(lines_[i]);
      std::erase_if(blocks, [&](const NumberedLine* block) {
        if (!is_used(block->line->targets.front())) return false;
        note(*block);
        part.lines.push_back(*block->line);
        return true;
      });
      part.lines.push_back(*lines_[i].line);
      for (std::size_t v = first_value_[i]; v < first_value_[i + 1]; ++v) {
        const Value& value = values_[v];
        if (value.element.empty()) continue;
        part.lines.push_back({Line::Kind::store, {value.element}, value.name});
        live_widths.insert(value.width);
      }
    }
    std::vector<Line> elements;
    for (const NumberedLine& binding : bindings_) {
      if (!is_used(binding.line->targets.front())) continue;
      elements.push_back(*binding.line);
      note(binding);
    }
    part.lines.insert(part.lines.begin(), elements.begin(), elements.end());
    for (const KernelArray& p : kernel_.parameters)
      if (is_used(p.name)) part.parameters.push_back(p);
    for (const LiveValues& values : live)
      if (live_widths.count(values.array.width) > 0) part.parameters.push_back(values.array);
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

bool is_long(const Kernel& kernel, const Dialect& dialect) {
  const KernelLengths& lengths = dialect.lengths;
  return kernel.lines.size() > (kernel.widths.empty() ? lengths.longest : lengths.longest_in_lanes);
}

SplitKernel split_kernel(const Kernel& kernel, const Dialect& dialect) {
  const KernelLengths& lengths = dialect.lengths;
  const bool is_short = !kernel.widths.empty() || kernel.lines.size() > lengths.cached;
  return split_kernel(kernel, is_short ? lengths.short_part : lengths.part, dialect);
}

SplitKernel split_kernel(const Kernel& kernel, std::size_t longest, const Dialect& dialect) {
  return KernelSplitter(kernel, longest, dialect).run();
}

}  // namespace robcogen::backend
