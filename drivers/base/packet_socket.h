// Unix sockets that keep the borders of packets, and hand over a descriptor with one: the local link's cable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

struct Packet {
  std::size_t bytes = 0;
  UniqueFd descriptor;  // Valid where one came along.
};

// All sockets are close-on-exec and none ever blocks.

// Listens at `path`, and replaces what lies there in one step: a peer finds the old socket or the new one.
// Errors: filename_too_long (sun_path holds 107 bytes), those of bind.
Result<UniqueFd> ListenForPackets(const std::string& path);

// Errors: resource_unavailable_try_again (nobody calls), those of accept.
Result<UniqueFd> AcceptPeer(int listener);

// Errors: no_such_file_or_directory, connection_refused (its owner died), resource_unavailable_try_again (its
// owner is busy), permission_denied, filename_too_long.
Result<UniqueFd> ConnectToPeer(const std::string& path);

// Errors: resource_unavailable_try_again (the peer reads too slowly), no_such_device (it is gone).
Result<void> SendPacket(int socket, std::span<const std::uint8_t> bytes, int descriptor = -1);

// Errors: resource_unavailable_try_again (nothing waits), no_such_device (the peer is gone), message_size
// (the packet was longer than `into` and is lost).
Result<Packet> ReceivePacket(int socket, std::span<std::uint8_t> into);

}  // namespace kaori
