#include "drivers/base/fd_keeper.h"

#include <poll.h>

#include <algorithm>
#include <array>

#include "drivers/base/packet_socket.h"

namespace kaori::service {
namespace {

using Request = std::array<std::uint8_t, 1>;
constexpr Request kHold{'h'};  // With the descriptor.
constexpr Request kGive{'g'};
constexpr Request kHere{'y'};  // With the descriptor.
constexpr Request kNone{'n'};

// Far more than a keeper takes to answer, and less than the service
// manager allows the stage for its start.
constexpr int kLongestWait_ms = 5000;
// Each sends one request: a second stage, or a person with a debugger, is the most that is ever there.
constexpr std::size_t kMostClients = 16;

}  // namespace

Result<void> GiveToKeeper(int fd, const std::string& socket) {
  if (socket.empty()) return {};
  const auto keeper = ConnectToPeer(socket);
  if (!keeper) return tl::unexpected(keeper.error());
  return SendPacket(keeper->get(), kHold, fd);
}

// Blocks for the answer, as programs call it once while they start; a keeper that does not answer in time is
// an error of its own.
Result<UniqueFd> RetrieveFromKeeper(const std::string& socket) {
  const std::string attempt = "retrieve what the fd keeper holds";
  if (socket.empty()) return Fail(std::errc::no_such_device, attempt);
  const auto keeper = ConnectToPeer(socket);
  if (!keeper) return tl::unexpected(keeper.error());
  if (auto asked = SendPacket(keeper->get(), kGive); !asked) return tl::unexpected(asked.error());
  // The socket does not block, so the wait is a poll. A keeper that
  // dies closes it, which ends the wait too.
  pollfd readable{keeper->get(), POLLIN, 0};
  if (::poll(&readable, 1, kLongestWait_ms) != 1) return Fail(std::errc::timed_out, attempt);
  Request request{};
  auto answer = ReceivePacket(keeper->get(), request);
  if (!answer) return tl::unexpected(answer.error());
  if (request != kHere || !answer->descriptor.valid()) return Fail(std::errc::no_such_device, attempt);
  return std::move(answer->descriptor);
}

Result<void> FdKeeper::Open() {
  return loop_.Watch(listener_.get(), [this] { Accept(); });
}

void FdKeeper::Accept() {
  auto client = AcceptPeer(listener_.get());
  if (!client) return;
  if (clients_.size() >= kMostClients) {  // It has been silent for longest.
    loop_.Forget(clients_.front().get());
    clients_.erase(clients_.begin());
  }
  const int fd = client->get();
  clients_.push_back(std::move(*client));
  if (!loop_.Watch(fd, [this, fd] { Answer(fd); })) clients_.pop_back();
}

// The connection ends after one request. An unknown one is not
// answered: the client finds a closed connection.
void FdKeeper::Answer(int client) {
  Request request{};
  auto packet = ReceivePacket(client, request);
  if (packet && request == kHold && packet->descriptor.valid()) {
    // The move closes what was held before: that card's file was the last
    // copy, so the kernel gives its master rights back.
    held_ = std::move(packet->descriptor);
    received_(held_->get());
  } else if (packet && request == kGive) {
    // A client that did not wait for the answer is gone: nothing is lost.
    [[maybe_unused]] const auto given =
        held_ ? SendPacket(client, kHere, held_->get()) : SendPacket(client, kNone);
  }
  loop_.Forget(client);
  std::erase_if(clients_, [client](const UniqueFd& fd) { return fd.get() == client; });
}

}  // namespace kaori::service
