#include "appliance/programs/desk/box_connection.h"

#include <fcntl.h>

#include <utility>
#include <vector>

#include "appliance/programs/shows/protocol/protocol.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"

namespace kaori::desk {
namespace {

// A stick's list is there sooner than its reader looks up.
constexpr Duration kBoxRetry = std::chrono::milliseconds(500);
// So that one that sends without end does not keep the browsers waiting.
constexpr int kStatesAtOnce = 16;

}  // namespace

void BoxConnection::Step(Time now) {
  if (!socket_.valid() && now >= retry_at_) Connect(now);
  if (socket_.valid()) Receive();
}

// That nobody listens is expected: kaori-shows may start later than the desk.
void BoxConnection::Connect(Time now) {
  retry_at_ = now + kBoxRetry;
  if (path_.empty()) return;
  if (auto socket = ConnectToPeer(path_)) socket_ = std::move(*socket);
}

void BoxConnection::Receive() {
  std::vector<std::uint8_t> bytes(shows::kLongestState_bytes);
  for (int n = 0; n < kStatesAtOnce; ++n) {
    auto packet = ReceivePacket(socket_.get(), bytes);
    if (!packet && packet.error().cause == std::errc::resource_unavailable_try_again) return;
    if (!packet) return Disconnect();
    std::string text(reinterpret_cast<const char*>(bytes.data()), packet->bytes);
    if (packet->descriptor.valid()) {
      backup_ = std::move(packet->descriptor);
      backup_name_ = std::move(text);
    } else {
      state_ = std::move(text);
    }
  }
}

// The list of a program that is gone is nobody's.
void BoxConnection::Disconnect() {
  socket_.reset();
  state_.reset();
  backup_.reset();
}

// Its place in the file is read by nobody: each reader says where it reads.
Result<UniqueFd> BoxConnection::OpenBackup() const {
  if (!backup_.valid()) return Fail(std::errc::no_such_file_or_directory, "open the backup");
  UniqueFd copy(::fcntl(backup_.get(), F_DUPFD_CLOEXEC, 0));
  if (!copy.valid()) return FailErrno("open the backup");
  return copy;
}

Result<void> BoxConnection::Send(std::string_view request, int file) {
  if (!socket_.valid()) return Fail(std::errc::no_such_device, "ask kaori-shows");
  return SendPacket(socket_.get(), AsBytes(request), file);
}

}  // namespace kaori::desk
