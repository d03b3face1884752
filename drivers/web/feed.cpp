#include "drivers/web/feed.h"

#include <microhttpd.h>
#include <sys/socket.h>

#include <algorithm>

#include <fmt/format.h>

namespace kaori::web {
namespace {

// The boundary of multipart/x-mixed-replace (RFC 2046, 5.1.1). Every part ends with it.
constexpr std::string_view kBoundary = "--kaori\r\n";
// The most that MHD asks for at a time.
constexpr std::size_t kBlockBytes = 32768;
// What the kernel buffers for one listener: about one picture, so that a slow one sees recent pictures.
constexpr int kSendBufferBytes = 65536;

// Without it the kernel would buffer megabytes, and a slow browser would show the past.
void KeepSendBufferShort(MHD_Connection* connection) {
  const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
  if (info == nullptr) return;
  ::setsockopt(info->connect_fd, SOL_SOCKET, SO_SNDBUF, &kSendBufferBytes, sizeof(kSendBufferBytes));
}

}  // namespace

// `sending` is a copy of the message that this listener receives;
// `sent_bytes` of it have been given to MHD.
struct Feed::Listener {
  Feed* feed;
  MHD_Connection* connection;
  std::string sending;
  std::size_t sent_bytes = 0;
  std::uint64_t number = 0;  // Of the message in `sending`.
  bool asleep = false;       // Suspended until the next message.
  bool dismissed = false;
};

Feed::Feed(std::string content_type, std::string opening)
    : content_type_(std::move(content_type)), opening_(std::move(opening)) {}

Feed::~Feed() = default;

void Feed::Publish(std::string message) {
  newest_ = std::move(message);
  ++number_;
  for (auto& listener : listeners_) Wake(*listener);
}

bool Feed::awaited() const {
  return std::ranges::any_of(listeners_, [](const auto& l) { return l->sent_bytes == l->sending.size(); });
}

MHD_Response* Feed::Listen(MHD_Connection* connection) {
  auto listener = std::make_unique<Listener>(Listener{this, connection, opening_});
  MHD_Response* response =
      MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kBlockBytes, &Read, listener.get(), &Leave);
  if (response == nullptr) return nullptr;
  // The first listener waits for a new message: nothing may have been published while nobody listened.
  if (listeners_.empty()) listener->number = number_;
  KeepSendBufferShort(connection);
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, content_type_.c_str());
  listeners_.push_back(std::move(listener));
  return response;
}

void Feed::End() {
  ended_ = true;
  for (auto& listener : listeners_) Wake(*listener);
}

void Feed::Dismiss() {
  for (auto& listener : listeners_) {
    listener->dismissed = true;
    Wake(*listener);
  }
}

void Feed::Wake(Listener& listener) {
  if (!listener.asleep) return;
  listener.asleep = false;
  MHD_resume_connection(listener.connection);
}

// MHD's content reader: the next bytes for one listener; 0 after its connection was suspended.
std::ptrdiff_t Feed::Read(void* context, std::uint64_t, char* into, std::size_t most) {
  auto& listener = *static_cast<Listener*>(context);
  Feed& feed = *listener.feed;
  if (feed.ended_ || listener.dismissed) return MHD_CONTENT_READER_END_OF_STREAM;
  if (listener.sent_bytes == listener.sending.size()) {
    // Everything was sent: MHD is to ask again only after the next message.
    if (listener.number == feed.number_) {
      listener.asleep = true;
      MHD_suspend_connection(listener.connection);
      return 0;
    }
    // A copy: the feed may get a newer message while this one is being sent.
    listener.sending = feed.newest_;
    listener.number = feed.number_;
    listener.sent_bytes = 0;
  }
  const std::size_t bytes = std::min(most, listener.sending.size() - listener.sent_bytes);
  std::copy_n(listener.sending.data() + listener.sent_bytes, bytes, into);
  listener.sent_bytes += bytes;
  return static_cast<std::ptrdiff_t>(bytes);
}

void Feed::Leave(void* context) {
  const auto* leaving = static_cast<Listener*>(context);
  std::erase_if(leaving->feed->listeners_, [&](const auto& l) { return l.get() == leaving; });
}

PictureFeed::PictureFeed() : Feed("multipart/x-mixed-replace; boundary=kaori", std::string(kBoundary)) {}

// A part ends with the next boundary, since browsers show one when that arrives.
void PictureFeed::PublishPicture(std::string_view jpeg) {
  Publish(fmt::format("Content-Type: image/jpeg\r\nContent-Length: {}\r\n\r\n{}\r\n{}", jpeg.size(), jpeg,
                      kBoundary));
}

}  // namespace kaori::web
