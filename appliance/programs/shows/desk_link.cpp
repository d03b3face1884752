#include "appliance/programs/shows/desk_link.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "appliance/programs/shows/settings_check.h"
#include "drivers/base/log.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {

static_assert(kLongestRequest_bytes > kMostSettings_bytes, "the longest settings fit into a request");

// Reading and writing are both needed to connect (unix(7)). Between the socket and its rights nobody but this program's own user
// can; the desk tries again.
Result<DeskLink> DeskLink::Open(const std::string& path, std::uint32_t desk) {
  auto listener = ListenForPackets(path);
  if (!listener) return tl::unexpected(listener.error());
  using std::filesystem::perms;
  std::error_code failed;
  std::filesystem::permissions(
      path, perms::owner_read | perms::owner_write | perms::group_read | perms::group_write, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "let the desk use " + path);
  return DeskLink(std::move(*listener), desk);
}

// Others of the group have no business here: the desk alone asks its visitors for a code.
void DeskLink::Accept() {
  auto peer = AcceptPeer(listener_.get());
  if (!peer) return;
  const auto user = PeerUser(peer->get());
  if (!user || *user != user_)
    return LogWarning("a program that is not kaori-desk connected to its socket; the connection was closed");
  HangUp();
  desk_ = std::move(*peer);
}

void DeskLink::HangUp() {
  desk_.reset();
  told_.clear();
  given_.clear();
}

// A request of any length up to the longest; what is longer is no desk's.
std::optional<Request> DeskLink::Hear() {
  Accept();
  if (!connected()) return std::nullopt;
  std::vector<std::uint8_t> bytes(kLongestRequest_bytes);
  auto packet = ReceivePacket(desk_.get(), bytes);
  if (!packet) {
    if (packet.error().cause != std::errc::resource_unavailable_try_again) HangUp();
    return std::nullopt;
  }
  auto request = ParseRequest({reinterpret_cast<const char*>(bytes.data()), packet->bytes});
  const bool wants_file = request && request->kind == Request::Kind::kRestore;
  if (wants_file) request->file = std::move(packet->descriptor);
  if (!request || (wants_file && !request->file.valid())) {
    LogWarning("kaori-desk sent a request that it may not send; the connection was closed");
    HangUp();
    return std::nullopt;
  }
  return request;
}

Result<void> DeskLink::Give(const std::string& name, UniqueFd backup) {
  auto sent = SendPacket(desk_.get(), AsBytes(name), backup.get());
  if (sent) given_ = name;
  return sent;
}

void DeskLink::Tell(const std::string& state) {
  if (!connected() || state == told_ || state.size() > kLongestState_bytes) return;
  const auto sent = SendPacket(desk_.get(), AsBytes(state));
  if (sent)
    told_ = state;
  else if (sent.error().cause != std::errc::resource_unavailable_try_again)
    HangUp();
}

}  // namespace kaori::shows
