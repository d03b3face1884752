// A reply that never ends: each listener gets the newest message, and misses those it was too slow for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct MHD_Connection;
struct MHD_Response;

namespace kaori::web {

// One thread, the event loop's. Must outlive the HttpServer that serves it.
class Feed {
 public:
  // `content_type` of the reply; `opening` comes once, before a listener's first message.
  Feed(std::string content_type, std::string opening);
  ~Feed();

  // Makes `message` the newest. A listener that still reads an older one reads that to its end first: nothing
  // is queued but one message for each. Not from within an HttpServer's handler.
  void Publish(std::string message);

  std::size_t listeners() const { return listeners_.size(); }
  // Somebody has read everything: a new message would leave at once.
  bool awaited() const;

  // Ends the replies of all who listen now; they may come again. Not from within an HttpServer's handler.
  void Dismiss();

  // For HttpServer: a reply that feeds `connection`; nullptr when memory is short.
  MHD_Response* Listen(MHD_Connection* connection);
  // For HttpServer: ends every reply. Nothing can be published afterwards.
  void End();

 private:
  struct Listener;
  static std::ptrdiff_t Read(void* listener, std::uint64_t position, char* into, std::size_t most);
  static void Leave(void* listener);
  void Wake(Listener& listener);

  std::string content_type_;
  std::string opening_;
  std::string newest_;
  std::uint64_t number_ = 0;  // Of the newest message; 0 before the first.
  bool ended_ = false;
  std::vector<std::unique_ptr<Listener>> listeners_;
};

}  // namespace kaori::web
