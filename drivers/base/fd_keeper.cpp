#include "drivers/base/fd_keeper.h"

#include <poll.h>

#include <algorithm>
#include <array>

#include "drivers/base/packet_socket.h"

namespace kaori::service {
namespace {

// A packet is one byte: what its sender wants or brings.
using Word = std::array<std::uint8_t, 1>;
constexpr Word kHold{'h'};  // With the descriptor.
constexpr Word kGive{'g'};
constexpr Word kHere{'y'};  // With the descriptor.
constexpr Word kNone{'n'};

constexpr int kLongestWait_ms = 5000;
constexpr std::size_t kMostCallers = 16;  // Of whom each has one thing to say.

}  // namespace

Result<void> GiveToKeeper(int fd, const std::string& socket) {
  if (socket.empty()) return {};
  const auto holder = ConnectToPeer(socket);
  if (!holder) return tl::unexpected(holder.error());
  return SendPacket(holder->get(), kHold, fd);
}

Result<UniqueFd> RetrieveFromKeeper(const std::string& socket) {
  const std::string attempt = "take what is held";
  if (socket.empty()) return Fail(std::errc::no_such_device, attempt);
  const auto holder = ConnectToPeer(socket);
  if (!holder) return tl::unexpected(holder.error());
  if (auto asked = SendPacket(holder->get(), kGive); !asked) return tl::unexpected(asked.error());
  pollfd look{holder->get(), POLLIN, 0};
  if (::poll(&look, 1, kLongestWait_ms) != 1) return Fail(std::errc::timed_out, attempt);
  Word word{};
  auto answer = ReceivePacket(holder->get(), word);
  if (!answer) return tl::unexpected(answer.error());
  if (word != kHere || !answer->descriptor.valid()) return Fail(std::errc::no_such_device, attempt);
  return std::move(answer->descriptor);
}

Result<void> FdKeeper::Open() {
  return loop_.Watch(listener_.get(), [this] { Accept(); });
}

void FdKeeper::Accept() {
  auto caller = AcceptPeer(listener_.get());
  if (!caller) return;
  if (callers_.size() >= kMostCallers) {  // The one that has been silent for longest.
    loop_.Forget(callers_.front().get());
    callers_.erase(callers_.begin());
  }
  const int fd = caller->get();
  callers_.push_back(std::move(*caller));
  if (!loop_.Watch(fd, [this, fd] { Answer(fd); })) callers_.pop_back();
}

// Then the call is over.
void FdKeeper::Answer(int caller) {
  Word word{};
  auto packet = ReceivePacket(caller, word);
  if (packet && word == kHold && packet->descriptor.valid()) {
    held_ = std::move(packet->descriptor);
    taken_(held_->get());
  } else if (packet && word == kGive) {
    // A caller that did not wait for it is gone: nothing is lost.
    [[maybe_unused]] const auto given =
        held_ ? SendPacket(caller, kHere, held_->get()) : SendPacket(caller, kNone);
  }
  loop_.Forget(caller);
  std::erase_if(callers_, [caller](const UniqueFd& fd) { return fd.get() == caller; });
}

}  // namespace kaori::service
