// Unix sockets of packets (SOCK_SEQPACKET), each with one file descriptor beside it where the sender passes one
// (SCM_RIGHTS). The simulator's local link and the fd keeper speak over them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// What ReceivePacket returned.
struct Packet {
  std::size_t bytes = 0;  // How much of the caller's buffer was filled.
  UniqueFd descriptor;    // Valid where the sender passed one.
};

// All sockets are close-on-exec and no call blocks. Several threads may send on one socket.

// Listens at `path`, and replaces what lies there in one step: a peer finds the old socket or the new one. Binds at
// `path`.new first. Errors: filename_too_long (sun_path holds 107 bytes), those of bind(2) and rename(2).
Result<UniqueFd> ListenForPackets(const std::string& path);

// Accepts the next connection. Errors: resource_unavailable_try_again (none waits), those of accept4(2).
Result<UniqueFd> AcceptPeer(int listener);

// Connects to a listening socket. Errors: no_such_file_or_directory, connection_refused (its owner died), resource_unavailable_try_again (its
// owner is busy), permission_denied, filename_too_long.
Result<UniqueFd> ConnectToPeer(const std::string& path);

// Sends one packet, and a copy of `descriptor` where it is valid; borrows both. Errors: resource_unavailable_try_again
// (the peer reads too slowly), no_such_device (it is gone).
Result<void> SendPacket(int socket, std::span<const std::uint8_t> bytes, int descriptor = -1);

// Receives one packet into `into`. Errors: resource_unavailable_try_again (nothing waits), no_such_device (the peer is gone), message_size
// (the packet was longer than `into` and is lost).
Result<Packet> ReceivePacket(int socket, std::span<std::uint8_t> into);

}  // namespace kaori
