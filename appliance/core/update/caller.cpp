#include "appliance/core/update/caller.h"

#include <algorithm>
#include <array>
#include <span>

#include "drivers/base/number.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

// The number up to the next space, which is taken off.
std::optional<std::uint32_t> NextNumber(std::string_view& text) {
  const std::size_t end = text.find(' ');
  if (end == text.npos) return std::nullopt;
  const auto number = ParseNumber<std::uint32_t>(text.substr(0, end));
  text.remove_prefix(end + 1);
  return number;
}

}  // namespace

std::string Format(const Answer& answer) {
  const std::string text = std::to_string(static_cast<unsigned>(answer.message)) + " " +
                           std::to_string(answer.version) + " " + std::to_string(answer.done) + " " +
                           answer.detail;
  return text.substr(0, kLongestPacket_bytes);
}

std::optional<Answer> ParseAnswer(std::string_view packet) {
  const auto message = NextNumber(packet), version = NextNumber(packet), done = NextNumber(packet);
  if (!message || *message >= kMessageCount || !version || !done) return std::nullopt;
  return Answer{static_cast<Message>(*message), *version, *done, std::string(packet)};
}

Result<Caller> Caller::Ask(const std::string& socket, std::string_view request, int file) {
  auto connection = ConnectToPeer(socket);
  if (!connection) return tl::unexpected(connection.error());
  if (auto ok = SendPacket(connection->get(), AsBytes(request), file); !ok) return tl::unexpected(ok.error());
  return Caller(std::move(*connection));
}

// The last answer is not passed over by what comes behind it: nothing does.
Result<Answer> Caller::Read() {
  std::array<std::uint8_t, kLongestPacket_bytes> bytes{};
  std::optional<Answer> newest;
  while (true) {
    const auto packet = ReceivePacket(connection_.get(), bytes);
    if (!packet && newest) return *newest;
    if (!packet) return tl::unexpected(packet.error());
    newest = ParseAnswer({reinterpret_cast<const char*>(bytes.data()), packet->bytes});
    if (!newest) return Fail(std::errc::bad_message, "understand kaori-update");
  }
}

}  // namespace kaori::update
