#include "drivers/midi/midi_bus.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "drivers/base/folder.h"
#include "drivers/base/open_cause.h"
#include "drivers/base/read_file.h"
#include "drivers/base/timer.h"
#include "drivers/midi/midi_channel.h"
#include "firmware/wire/dial_box.h"

namespace kaori::midi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostIdBytes = 16;

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

}  // namespace

Result<std::unique_ptr<MidiBus>> MidiBus::Open(MidiFolders folders, const std::vector<KnownSurface>& surfaces,
                                               const Clock& clock) {
  auto timer = OpenTimer(folders.look_every, folders.look_every, "look for MIDI devices now and then");
  if (!timer) return tl::unexpected(timer.error());
  return std::unique_ptr<MidiBus>(new MidiBus(std::move(folders), surfaces, clock, std::move(*timer)));
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
  std::vector<std::string> ports;
  for (const auto& [port, node] : nodes_) ports.push_back(port);
  return ports;
}

// Each known surface is presented as a dial box, with the descriptor of ours: whoever reads it need not know
// MIDI.
Result<std::unique_ptr<ports::HidChannel>> MidiBus::Open(const std::string& port) {
  const auto found = nodes_.find(port);
  if (found == nodes_.end()) return Fail(std::errc::no_such_device, "open the MIDI device at " + port);
  const Node& node = found->second;
  const auto known = std::ranges::find_if(surfaces_, [&](const KnownSurface& surface) {
    return surface.vendor == node.vendor && surface.product == node.product;
  });
  if (known == surfaces_.end())
    return Fail(std::errc::not_supported,
                fmt::format("use the MIDI device {:04x}:{:04x} at {}, for which there is no map", node.vendor,
                            node.product, port));
  UniqueFd fd(::open(node.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  // ENXIO: it has no way back, for lamps.
  if (!fd.valid() && errno == ENXIO)
    fd = UniqueFd(::open(node.path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!fd.valid()) return Fail(CauseOfOpen(errno), "open " + node.path.string() + " at " + port);
  const ports::HidIdentity identity{
      .port = port,
      .vendor = node.vendor,
      .product = node.product,
      .name = known->name,
      .descriptor = {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}};
  return std::make_unique<MidiChannel>(std::move(fd), identity, known->map, clock_);
}

}  // namespace kaori::midi
