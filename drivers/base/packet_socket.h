// Unix sockets of packets (SOCK_SEQPACKET), each with one file descriptor beside it where the sender passes
// one (SCM_RIGHTS). The simulator's local link and the fd keeper speak over them.
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
  // How much of the caller's buffer was filled. What lies beyond is as it was before.
  std::size_t bytes = 0;
  UniqueFd descriptor;  // Valid where the sender passed one.
};

// All sockets are close-on-exec and no call blocks. Several threads may send on one socket: a packet is
// never mixed with another. Both ends must be of this kind: a stream socket would glue packets together.

// Listens at `path`, and replaces what lies there in one step: a peer finds the old socket or the new one.
// Binds at `path`.new first, in place of a file or a socket that a killed owner left there; nothing stays
// there in any case. Errors: filename_too_long (sun_path holds 107 bytes, 4 of them for ".new"), those of
// bind(2) and rename(2).
Result<UniqueFd> ListenForPackets(const std::string& path);

// Accepts the next connection. Nothing is known of the peer; who may connect is decided by the rights of
// the socket's folder. Errors: resource_unavailable_try_again (none waits), those of accept4(2).
Result<UniqueFd> AcceptPeer(int listener);

// The user id of the program at the other end, as it was when that connected (SO_PEERCRED of unix(7)). Errors: those of
// getsockopt(2).
Result<std::uint32_t> PeerUser(int socket);

// Connects to a listening socket. Errors:
//   no_such_file_or_directory       nobody listens at `path`
//   connection_refused              its owner died and left the socket behind
//   resource_unavailable_try_again  its owner has not accepted the connections that wait already
//   permission_denied               the socket may not be written to
//   filename_too_long               sun_path holds 107 bytes
Result<UniqueFd> ConnectToPeer(const std::string& path);

// Sends one packet, and a copy of `descriptor` where it is valid; borrows both.
// The packet is queued whole or not at all. Errors:
//   resource_unavailable_try_again  the peer reads too slowly: its queue is full
//   no_such_device                  the peer is gone
//   message_size                    the packet is longer than the socket's send buffer
Result<void> SendPacket(int socket, std::span<const std::uint8_t> bytes, int descriptor = -1);

// Receives one packet into `into`. Errors:
//   resource_unavailable_try_again  nothing waits
//   no_such_device                  the peer is gone; an empty packet reads the same, so nobody sends one
//   message_size                    the packet was longer than `into`; it and its descriptor are lost
Result<Packet> ReceivePacket(int socket, std::span<std::uint8_t> into);

}  // namespace kaori
