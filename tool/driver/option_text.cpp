#include "driver/option_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <memory>

namespace robcogen::driver {

std::vector<Place> places_of(const std::string& option, const std::vector<std::string>& words) {
  const auto source = std::make_shared<const Source>(option, fmt::format("{}", fmt::join(words, " ")));
  std::vector<Place> places;
  std::size_t begin = 0;
  for (const std::string& word : words) {
    places.push_back({source, {begin, begin + word.size()}});
    begin += word.size() + 1;
  }
  return places;
}

}  // namespace robcogen::driver
