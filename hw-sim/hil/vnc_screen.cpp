#include "hw-sim/hil/vnc_screen.h"

#include <cstdint>
#include <initializer_list>

namespace kaori::hil {
namespace {

// The bound is for an emulated machine on a busy computer; an answer usually takes milliseconds.
constexpr Duration kVncLongest = std::chrono::seconds(60);
// Security type 1 is "None" (RFC 6143, 7.2.1); a shared client does not throw out others (7.3.1).
constexpr char kNoPassword = 1, kShared = 1;
// Message types of the client: 2 is of the RFC, 251 of the community's extension for desktop sizes.
constexpr char kSetEncodings = 2;
constexpr std::uint8_t kSetDesktopSize = 251;
// Encodings below 0 are pseudo-encodings: with them the client says that it understands a changed size.
constexpr std::int32_t kRaw = 0, kExtendedDesktopSize = -308, kDesktopSize = -223;

// Numbers are big-endian.
// Only the lower 16 bits are sent.
std::string Big16(int number) {
  return {static_cast<char>(number >> 8), static_cast<char>(number)};
}

std::string Big32(std::int32_t number) {
  return Big16(number >> 16) + Big16(number);
}

// The four bytes must be there: Next has read them.
std::uint32_t Number32(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t n = at; n < at + 4; ++n) number = number << 8 | static_cast<std::uint8_t>(bytes[n]);
  return number;
}

}  // namespace

Result<VncScreen> VncScreen::Connect(const std::string& path, Waiter& waiter) {
  auto stream = Stream::Call(path, waiter, kVncLongest);
  if (!stream) return tl::unexpected(stream.error());
  VncScreen screen(std::move(*stream), waiter);
  if (auto ok = screen.Greet(); !ok) return tl::unexpected(ok.error());
  return screen;
}

// Exactly so many bytes; what comes behind them stays for the next call.
Result<std::string> VncScreen::Next(std::size_t bytes) {
  bool there = true;
  const auto whole = [&] {
    there = stream_.Read();
    return !there || stream_.waiting().size() >= bytes;
  };
  if (!waiter_->Until(whole, kVncLongest, stream_.pollable()))
    return Fail(std::errc::timed_out, "hear from QEMU's VNC server");
  if (stream_.waiting().size() < bytes) return Fail(std::errc::no_such_device, "hear from QEMU's VNC server");
  std::string next = stream_.waiting().substr(0, bytes);
  stream_.Drop(bytes);
  return next;
}

// RFC 6143, 7.1 to 7.3: what is read in each step, and what is then said. The list of security types and the
// server's name follow their lengths.
Result<void> VncScreen::Greet() {
  constexpr std::size_t kVersionBytes = 12, kResultBytes = 4, kInitBytes = 24, kNameLengthAt = 20;
  const auto step = [&](std::size_t bytes, const std::string& reply) -> Result<std::string> {
    auto read = Next(bytes);
    if (!read || reply.empty()) return read;
    if (auto ok = stream_.Say(reply); !ok) return tl::unexpected(ok.error());
    return read;
  };
  if (auto version = step(kVersionBytes, "RFB 003.008\n"); !version) return tl::unexpected(version.error());
  const auto types = step(1, "");
  if (!types) return tl::unexpected(types.error());
  if (auto ok = step(static_cast<std::uint8_t>(types->front()), {kNoPassword}); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = step(kResultBytes, {kShared}); !ok) return tl::unexpected(ok.error());
  const auto init = step(kInitBytes, "");
  if (!init) return tl::unexpected(init.error());
  const std::string encodings = std::string{kSetEncodings, 0} + Big16(3) + Big32(kRaw) +
                                Big32(kExtendedDesktopSize) + Big32(kDesktopSize);
  if (auto ok = step(Number32(*init, kNameLengthAt), encodings); !ok) return tl::unexpected(ok.error());
  return {};
}

// The answer of the server is not waited for: a check sees in the guest whether the size has changed.
Result<void> VncScreen::Resize(int width_px, int height_px) {
  if (!stream_.Read()) return Fail(std::errc::no_such_device, "plug in a screen");
  stream_.Drop(stream_.waiting().size());  // What the server says of the picture is not looked at.
  const std::string size = Big16(width_px) + Big16(height_px);
  // One screen that fills all: its number, where it begins, its size and its flags.
  return stream_.Say(std::string{static_cast<char>(kSetDesktopSize), 0} + size + std::string{1, 0} +
                     Big32(0) + Big32(0) + size + Big32(0));
}

}  // namespace kaori::hil
