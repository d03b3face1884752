#include "drivers/midi/midi_bus.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "drivers/base/folder.h"
#include "drivers/base/log.h"
#include "drivers/base/open_cause.h"
#include "drivers/base/read_file.h"
#include "drivers/base/timer.h"
#include "drivers/midi/midi_channel.h"
#include "firmware/wire/dial_box.h"

namespace kaori::midi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostIdBytes = 16;
constexpr int kReadsAtOnce = 16;

const decode::MidiMap kAnyMap{.dials = {}, .buttons = {}, .start = {}, .any = true};

// "1397\n" of idVendor or idProduct; 0 where it cannot be read.
std::uint16_t IdIn(const fs::path& file) {
  const auto text = ReadBeginning(file, kMostIdBytes);
  unsigned value = 0;
  if (text) std::from_chars(text->data(), text->data() + text->size(), value, 16);
  return static_cast<std::uint16_t>(value);
}

// The USB device above a sound device; empty where it is none.
fs::path UsbDeviceAbove(fs::path folder) {
  std::error_code error;
  for (; folder.has_relative_path(); folder = folder.parent_path())
    if (fs::exists(folder / "idVendor", error)) return folder;
  return {};
}

// ENXIO: it has no way back, for lamps.
UniqueFd OpenNode(const fs::path& path) {
  UniqueFd fd(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!fd.valid() && errno == ENXIO) fd = UniqueFd(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  return fd;
}

// What plays nothing, since its device is only listened to.
ports::MidiHeard Unmeant(const decode::MidiMessage& message, std::uint16_t vendor, std::uint16_t product,
                         Time at) {
  return {.at = at,
          .vendor = vendor,
          .product = product,
          .status = message.status,
          .number = message.number,
          .value = message.value};
}

}  // namespace

Result<std::unique_ptr<MidiBus>> MidiBus::Open(MidiFolders folders, const std::vector<KnownSurface>& surfaces,
                                               const Clock& clock, ports::MidiTap* tap) {
  auto timer = OpenTimer(folders.look_every, folders.look_every, "look for MIDI devices now and then");
  if (!timer) return tl::unexpected(timer.error());
  return std::unique_ptr<MidiBus>(new MidiBus(std::move(folders), surfaces, clock, tap, std::move(*timer)));
}

// A machine without sound has no such folder, which is no fault.
Result<std::vector<std::string>> MidiBus::Ports() {
  std::uint64_t expirations = 0;
  (void)!::read(timer_.get(), &expirations, sizeof expirations);
  nodes_.clear();
  std::error_code error;
  for (const fs::path& path : ListFolder(folders_.classes).value_or(std::vector<fs::path>{})) {
    const std::string name = path.filename().string();
    if (!name.starts_with("midiC") || !name.ends_with("D0")) continue;
    const fs::path usb = UsbDeviceAbove(fs::canonical(path, error));
    if (error || usb.empty()) continue;
    nodes_[usb.filename().string()] = {
        .path = folders_.nodes / name, .vendor = IdIn(usb / "idVendor"), .product = IdIn(usb / "idProduct")};
  }
  std::erase_if(listened_, [this](const auto& one) { return !nodes_.contains(one.first); });
  std::vector<std::string> ports;
  for (const auto& [port, node] : nodes_)
    if (MapFor(node) != nullptr || Listen(listened_[port], node)) ports.push_back(port);
  return ports;
}

const KnownSurface* MidiBus::MapFor(const Node& node) const {
  const auto known = std::ranges::find_if(surfaces_, [&](const KnownSurface& surface) {
    return surface.vendor == node.vendor && surface.product == node.product;
  });
  return known == surfaces_.end() ? nullptr : &*known;
}

// One that cannot be opened or read now is tried at the next look. The rest of what was said is the
// channel's.
bool MidiBus::Listen(Listened& listened, const Node& node) const {
  if (listened.has_spoken) return true;
  if (!listened.node.valid()) listened.node = OpenNode(node.path);
  std::array<std::uint8_t, 64> bytes{};
  for (int reads = 0; reads < kReadsAtOnce && listened.node.valid(); ++reads) {
    const ssize_t got = ::read(listened.node.get(), bytes.data(), bytes.size());
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) break;
    if (got <= 0) listened.node.reset();
    for (ssize_t n = 0; n < got; ++n) {
      const auto message = listened.parser.Accept(bytes[static_cast<std::size_t>(n)]);
      if (message && tap_ != nullptr) tap_->Note(Unmeant(*message, node.vendor, node.product, clock_.now()));
      listened.has_spoken =
          listened.has_spoken || (message && (decode::AnyDial(*message) || decode::AnyButton(*message)));
    }
  }
  return listened.has_spoken;
}

// Each surface is presented as a dial box, with the descriptor of ours: whoever reads it need not know
// MIDI.
Result<std::unique_ptr<ports::HidChannel>> MidiBus::Open(const std::string& port) {
  const auto found = nodes_.find(port);
  if (found == nodes_.end()) return Fail(std::errc::no_such_device, "open the MIDI device at " + port);
  const Node& node = found->second;
  const KnownSurface* const known = MapFor(node);
  UniqueFd fd = known == nullptr ? std::move(listened_[port].node) : UniqueFd();
  if (!fd.valid()) fd = OpenNode(node.path);
  if (!fd.valid()) return Fail(CauseOfOpen(errno), "open " + node.path.string() + " at " + port);
  if (known == nullptr)
    Log("the MIDI device {:04x}:{:04x} at {} has no file of its own: its controls are dials and its notes "
        "buttons, "
        "each by its number",
        node.vendor, node.product, port);
  const ports::HidIdentity identity{
      .port = port,
      .vendor = node.vendor,
      .product = node.product,
      .name = known == nullptr ? fmt::format("MIDI {:04x}:{:04x}", node.vendor, node.product) : known->name,
      .descriptor = {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}};
  return std::make_unique<MidiChannel>(std::move(fd), identity, known == nullptr ? kAnyMap : known->map,
                                       clock_, tap_);
}

}  // namespace kaori::midi
