#include "drivers/web/connections.h"

#include <sys/socket.h>

#include <algorithm>

namespace kaori::web {
namespace {

void Close(Connection& connection) {
  ::shutdown(connection.fd, SHUT_RDWR);
  connection.is_closed = true;
}

}  // namespace

// One that waits for its handshake would give way to the next of a crowd, were the oldest of all closed.
Connection& Connections::Add(int fd, std::uint32_t address, Duration limit) {
  Connection& newest =
      all_.emplace_back(Connection{.fd = fd, .address = address, .limit = limit, .since = clock_.now()});
  if (CountOf(address) <= most_of_one_address_ && CountOf(std::nullopt) <= most_) return newest;
  const auto crowd = Crowd();
  auto found = std::ranges::find_if(crowd, [&](auto* each) { return each->is_idle && each != &newest; });
  if (found == crowd.end())
    found =
        std::ranges::find_if(crowd, [](auto* each) { return !each->is_idle && each->limit > Duration{}; });
  Close(found == crowd.end() ? *crowd.back() : **found);
  return newest;
}

void Connections::Remove(const Connection* connection) {
  std::erase_if(all_, [&](const Connection& each) { return &each == connection; });
}

void Connections::CloseSlow() {
  const Time now = clock_.now();
  for (Connection& each : all_)
    if (!each.is_closed && each.limit > Duration{} && now - each.since >= each.limit) Close(each);
}

std::size_t Connections::CountOf(std::optional<std::uint32_t> address) const {
  return static_cast<std::size_t>(std::ranges::count_if(all_, [&](const Connection& each) {
    return !each.is_closed && (!address || each.address == *address);
  }));
}

// An address with too many has the most: all others have no more than they may.
std::vector<Connection*> Connections::Crowd() {
  std::vector<Connection*> crowd;
  std::size_t most = 0;
  for (Connection& each : all_) {
    if (each.is_closed) continue;
    const std::size_t count = CountOf(each.address);
    if (count > most) crowd.clear();
    most = std::max(most, count);
    if (count == most) crowd.push_back(&each);
  }
  return crowd;
}

}  // namespace kaori::web
