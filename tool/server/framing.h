// The frames of the protocol: `Content-Length: N`, an empty line, N bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace robcogen::server {

// Larger contents are refused: their length is taken as broken.
inline constexpr std::size_t kMaxContentSize = std::size_t{256} << 20;  // bytes

// What a reader found: the content of a frame, or what is wrong with its header.
struct Frame {
  std::string content;
  std::string fault;  // empty for a sound frame
};

// Cuts a stream of bytes, which may arrive in pieces of any size, into frames. After a broken header it goes on at the
// next `Content-Length:`.
class FrameReader {
 public:
  void feed(std::string_view bytes);
  // nullopt until more bytes arrive.
  std::optional<Frame> next();
  // The content of the frame before was not a message, perhaps because its length was too large: what looks like the
  // header of another frame in it is read again.
  void reread(std::string_view content);

 private:
  std::string buffer_;
  std::size_t at_ = 0;        // the bytes before were used
  std::size_t searched_ = 0;  // no end of the header before
  bool is_lost_ = false;      // after a broken header, before the next one

  std::optional<Frame> lose(std::size_t used, std::string fault);
  bool find_header();
  void drop(std::size_t count);
};

// The frame around a content.
std::string framed(std::string_view content);

}  // namespace robcogen::server
