#include "appliance/programs/shows/protocol/protocol.h"

#include "drivers/base/number.h"

namespace kaori::shows {
namespace {

constexpr std::string_view kTake = "take ", kBackup = "backup", kRestore = "restore ",
                           kSettings = "settings\n";

}  // namespace

// A number is digits and nothing else, so that a request has one form only.
std::optional<Request> ParseRequest(std::string_view packet) {
  if (packet.size() > kLongestRequest_bytes) return std::nullopt;
  if (packet.starts_with(kSettings))
    return Request{.kind = Request::Kind::kSettings, .text = std::string(packet.substr(kSettings.size()))};
  if (packet == kBackup) return Request{.kind = Request::Kind::kBackup};
  if (packet.starts_with(kRestore) && packet.size() > kRestore.size())
    return Request{.kind = Request::Kind::kRestore, .text = std::string(packet.substr(kRestore.size()))};
  if (!packet.starts_with(kTake)) return std::nullopt;
  packet.remove_prefix(kTake.size());
  const std::size_t space = packet.find(' ');
  if (space == packet.npos) return std::nullopt;
  const auto line = ParseNumber<std::uint32_t>(packet.substr(0, space)),
             list = ParseNumber<std::uint32_t>(packet.substr(space + 1));
  if (!line || !list) return std::nullopt;
  return Request{.kind = Request::Kind::kTake, .line = *line, .list = *list};
}

}  // namespace kaori::shows
