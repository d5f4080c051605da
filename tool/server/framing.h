// The message frames of the protocol: `Content-Length: N`, an empty line, N bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace robcogen::server {

// Larger contents are refused, because their length is probably corrupt.
inline constexpr std::size_t kMaxContentSize = std::size_t{256} << 20;  // bytes

// The content of a frame, or what is wrong with its header.
struct Frame {
  std::string content;
  std::string fault;  // empty for a valid frame
};

// Splits a stream of bytes, which may arrive in pieces of any size, into frames. After a broken header it resumes at
// the next `Content-Length:`.
class FrameReader {
 public:
  void feed(std::string_view bytes);
  // Returns nullopt if the next frame is not complete yet.
  std::optional<Frame> next();
  // To be called if the content of the last frame was not a message, perhaps because its length was too large: a
  // possible header of another frame within it is then read again.
  void reread(std::string_view content);

 private:
  std::string buffer_;
  std::size_t at_ = 0;        // bytes before this were consumed
  std::size_t searched_ = 0;  // the header does not end before this
  bool is_lost_ = false;      // between a broken header and the next header

  std::optional<Frame> lose(std::size_t used, std::string fault);
  bool find_header();
  void drop(std::size_t count);
};

// Returns the frame with this content.
std::string framed(std::string_view content);

}  // namespace robcogen::server
