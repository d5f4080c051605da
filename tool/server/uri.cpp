#include "server/uri.h"

#include <fmt/format.h>

#include <cctype>
#include <optional>

namespace robcogen::server {
namespace {

constexpr std::string_view kScheme = "file://";

std::optional<int> digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

// A '%' without two digits stands for itself.
std::string decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) && digit(text[i + 2]);
    if (!is_escape) {
      result += text[i];
      continue;
    }
    result += static_cast<char>(*digit(text[i + 1]) * 16 + *digit(text[i + 2]));
    i += 2;
  }
  return result;
}

bool stands_for_itself(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos);
}

}  // namespace

std::filesystem::path path_of(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return std::string(uri);
  const std::string_view rest = uri.substr(kScheme.size());
  const std::size_t path = rest.find('/');  // after the host, which is empty
  if (path == std::string_view::npos) return std::string(uri);
  return std::filesystem::path(decoded(rest.substr(path))).lexically_normal();
}

std::string uri_of(const std::filesystem::path& path) {
  if (!path.is_absolute()) return path.string();
  std::string result(kScheme);
  for (const char c : path.string())
    result += stands_for_itself(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return result;
}

}  // namespace robcogen::server
