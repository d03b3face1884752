// The connections of a web server: which of them are closed so that nobody waits for those who are slow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::web {

// One client's.
struct Connection {
  // Borrowed: whoever accepted it closes it, once it finds it shut down.
  int fd;
  // The client's, IPv4.
  std::uint32_t address;
  // For what has been under way since `since`; zero: none.
  Duration limit;
  Time since;
  // Its request is not whole yet, or there is none.
  bool is_idle = true;
  // By us; whoever accepted it has not noticed yet.
  bool is_closed = false;
};

// Those that are open, of all clients and of each address. One thread.
class Connections {
 public:
  // The most of all clients and of one address; the first one is more than the second. The clock must outlive this.
  Connections(std::size_t most, std::size_t most_of_one_address, const Clock& clock)
      : most_(most), most_of_one_address_(most_of_one_address), clock_(clock) {}

  // Adds a connection that has just been accepted, and has `limit` for its first request. Where it is one too many, one is closed of the
  // address that has too many, or else of the one that has the most: the oldest whose request is not whole yet, or else whose reply
  // has a limit and is still on its way. Where there is none the newest is closed, which may be this one. It stays where it is until
  // Remove.
  Connection& Add(int fd, std::uint32_t address, Duration limit);
  void Remove(const Connection* connection);
  // Closes those whose limit is over.
  void CloseSlow();
  // Those that are open, of one address or of all (none).
  std::size_t CountOf(std::optional<std::uint32_t> address) const;

 private:
  // Those of the address that has the most, or of all such addresses, the oldest first.
  std::vector<Connection*> Crowd();

  std::size_t most_, most_of_one_address_;
  const Clock& clock_;
  // In the order in which they came.
  std::list<Connection> all_;
};

}  // namespace kaori::web
