// An HTTP reply that never ends: each listener gets the
// newest message, and misses those that it was too slow for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct MHD_Connection;
struct MHD_Response;

namespace kaori::web {

// Sends live pictures and states to browsers (multipart pictures, or events). One thread, that of
// the event loop. Must outlive the HttpServer that serves it. No call blocks: what a slow browser
// cannot receive waits in its own listener.
class Feed {
 public:
  // `content_type` is the reply's; `opening` is sent once to each listener, before its first message.
  Feed(std::string content_type, std::string opening);
  ~Feed();

  // Makes `message` the newest. A listener that still receives an older one receives that to its end first;
  // nothing else is queued. Not to be called from a handler of the HttpServer.
  void Publish(std::string message);

  // How many connections listen now.
  std::size_t listeners() const { return listeners_.size(); }
  // Whether a listener has received everything: a new message would be sent to it at once.
  bool awaited() const;

  // Ends the replies of all present listeners; they may connect
  // again. Not to be called from a handler of the HttpServer.
  void Dismiss();

  // For HttpServer: a reply that sends this feed to `connection`; null when memory is short.
  MHD_Response* Listen(MHD_Connection* connection);
  // For HttpServer: ends every reply. Nothing is sent afterwards.
  void End();

 private:
  // A connection that listens, and what was sent to it.
  struct Listener;
  // MHD's call-backs: more bytes for a listener, and its end. Fills `into` with at most `most` bytes and
  // returns how many; MHD's codes for the end, and 0 with a suspended connection, as
  // MHD_ContentReaderCallback says. `position` is MHD's count, which is not needed.
  static std::ptrdiff_t Read(void* listener, std::uint64_t position, char* into, std::size_t most);
  // Forgets a listener whose connection has ended.
  static void Leave(void* listener);
  // Resumes a connection that waits for a message; does nothing for one that is still receiving.
  void Wake(Listener& listener);

  // Of the answer's head.
  std::string content_type_;
  // Sent to each listener before its first message.
  std::string opening_;
  // Only this message is kept: late listeners miss the ones before.
  std::string newest_;
  std::uint64_t number_ = 0;  // Of the newest message; 0 before the first.
  // No listener gets anything any more.
  bool ended_ = false;
  // Owned here; MHD knows them by their address.
  std::vector<std::unique_ptr<Listener>> listeners_;
};

// Pictures that a browser shows in place of each other, in an <img> (multipart/x-mixed-replace).
class PictureFeed : public Feed {
 public:
  PictureFeed();
  // As Publish.
  void PublishPicture(std::string_view jpeg);
};

}  // namespace kaori::web
