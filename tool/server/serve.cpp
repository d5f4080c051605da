#include "server/serve.h"

#include <array>

#include "server/framing.h"
#include "server/session.h"

namespace robcogen::server {

bool serve(const ReadBytes& read, const WriteBytes& write, const std::vector<std::filesystem::path>& import_folders) {
  Session session(import_folders);
  FrameReader frames;
  std::array<char, 65536> bytes;
  while (!session.is_over()) {
    const std::size_t count = read(bytes.data(), bytes.size());
    if (count == 0) break;
    frames.feed({bytes.data(), count});
    while (!session.is_over()) {
      const std::optional<Frame> frame = frames.next();
      if (!frame) break;
      if (!frame->fault.empty()) {
        write(framed(text_of(Session::fault(frame->fault))));
        continue;
      }
      bool is_message = true;
      for (const Json& message : session.receive(frame->content, is_message)) write(framed(text_of(message)));
      if (!is_message) frames.reread(frame->content);
    }
  }
  return session.was_shut_down();
}

}  // namespace robcogen::server
