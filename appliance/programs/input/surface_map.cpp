#include "appliance/programs/input/surface_map.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/toml/section.h"
#include "appliance/programs/input/settings.h"
#include "drivers/base/folder.h"

namespace kaori::input {
namespace {

namespace fs = std::filesystem;

// MIDI 1.0: a data byte has seven bits, and four bits of a status byte name the channel, which people count
// from 1.
constexpr int kMostMidi = 127;
constexpr int kMidiChannels = 16;
// The most that repaint_s may be: for so long a lamp may stay wrong on a surface that forgets what it was
// told.
constexpr double kLongestRepaint_s = 60;

// Hexadecimal digits, all of them.
std::optional<unsigned> Hex(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Four digits on each side of the colon, as lsusb prints them: "77d:410" is a fault, and no number is guessed
// for it.
std::vector<SurfaceMap::UsbId> ReadUsb(toml::Section& file) {
  constexpr std::size_t kDigits = 4;
  std::vector<SurfaceMap::UsbId> ids;
  for (const std::string& text : file.Texts("usb")) {
    const auto vendor =
        text.size() == 2 * kDigits + 1 ? Hex(std::string_view(text).substr(0, kDigits)) : std::nullopt;
    const auto product =
        vendor && text[kDigits] == ':' ? Hex(std::string_view(text).substr(kDigits + 1)) : std::nullopt;
    if (product)
      ids.push_back({static_cast<std::uint16_t>(*vendor), static_cast<std::uint16_t>(*product)});
    else
      file.Fault("usb", fmt::format("\"{}\" is no id such as 077d:0410", text));
  }
  if (ids.empty()) file.Fault("usb", "names no device");
  return ids;
}

// Which of the board's own each of the device's is, counted from 1; what the list does not have is none.
template <std::size_t kCount>
void ReadTargets(toml::Section& file, std::string_view key,
                 std::array<std::optional<std::uint8_t>, kCount>& targets) {
  if (!file.Has(key)) return;
  const auto numbers = file.Numbers(key);
  if (numbers.size() > kCount) return file.Fault(key, fmt::format("has more than {} numbers", kCount));
  targets.fill(std::nullopt);
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const double number = numbers[n];
    if (number != std::floor(number) || number < 0 || number > static_cast<double>(kCount))
      return file.Fault(key, fmt::format("{} is not one of 0 (none) to {}", number, kCount));
    if (number > 0) targets[n] = static_cast<std::uint8_t>(number - 1);
  }
}

// Bytes as the manuals of MIDI devices print them, one blank between two; two blanks together are a fault.
// After a fault there are no bytes at all, since half a message could set the device otherwise.
std::vector<std::uint8_t> ReadBytes(toml::Section& section, std::string_view key) {
  std::vector<std::uint8_t> bytes;
  const std::string text = section.TextOr(key, "");
  for (std::string_view rest = text; !rest.empty();) {
    const auto blank = std::min(rest.find(' '), rest.size());
    const auto value = Hex(rest.substr(0, blank));
    if (!value || *value > 0xFF) {
      section.Fault(key, "must be bytes in hexadecimal digits, such as \"F0 00 01 F7\"");
      return {};
    }
    bytes.push_back(static_cast<std::uint8_t>(*value));
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  return bytes;
}

// One [[midi.dial]] stands for `count` dials of one mode, whose controls follow one another on one channel.
// They are numbered on from the table before. A mode that does not exist adds none of them.
void ReadDials(toml::Section dial, decode::MidiMap& map) {
  dial.AllowOnly({"channel", "control", "count", "mode"});
  const int channel = dial.WholeOr("channel", 1, 1, kMidiChannels);
  const int first = dial.WholeOr("control", -1, 0, kMostMidi);
  const int count = dial.WholeOr("count", 1, 1, kMostMidi + 1 - first);
  const std::string mode = dial.Text("mode");
  const auto* const found = std::ranges::find(decode::kMidiDialModeNames, mode);
  if (found == decode::kMidiDialModeNames.end())
    return dial.Fault("mode",
                      fmt::format("\"{}\" is none of {}", mode, fmt::join(decode::kMidiDialModeNames, ", ")));
  for (int n = 0; n < count; ++n)
    map.dials.push_back(
        {.channel = channel,
         .control = static_cast<std::uint8_t>(first + n),
         .mode = static_cast<decode::MidiDialMode>(found - decode::kMidiDialModeNames.begin())});
}

// The same for [[midi.button]], by notes or by controls. A lamp has the number of its button
// (decode::MidiButton).
void ReadButtons(toml::Section button, decode::MidiMap& map) {
  button.AllowOnly({"channel", "note", "control", "count", "lamp"});
  const bool is_control = button.Has("control");
  if (is_control == button.Has("note")) return button.Fault("note", "either a note or a control is needed");
  const int channel = button.WholeOr("channel", 1, 1, kMidiChannels);
  const int first = button.WholeOr(is_control ? "control" : "note", -1, 0, kMostMidi);
  const int count = button.WholeOr("count", 1, 1, kMostMidi + 1 - first);
  const toml::Value* lamp = button.Find("lamp");
  if (lamp != nullptr && lamp->kind != toml::Value::Kind::kSwitch)
    button.Fault("lamp", "must be true or false");
  for (int n = 0; n < count; ++n)
    map.buttons.push_back({.channel = channel,
                           .number = static_cast<std::uint8_t>(first + n),
                           .is_control = is_control,
                           .has_lamp = lamp != nullptr && lamp->on});
}

// Dials and buttons are counted over all tables, since what is beyond the board's own would move nothing.
decode::MidiMap ReadMidi(toml::Section midi) {
  midi.AllowOnly({"start", "repaint_s", "dial", "button"});
  decode::MidiMap map;
  map.start = ReadBytes(midi, "start");
  const double repaint_s = midi.NumberOr("repaint_s", 0);
  if (!(repaint_s >= 0 && repaint_s <= kLongestRepaint_s))
    midi.Fault("repaint_s", fmt::format("is not within 0 to {}", kLongestRepaint_s));
  else
    map.repaint = FromSeconds(repaint_s);
  for (const toml::Section& dial : midi.Parts("dial")) ReadDials(dial, map);
  for (const toml::Section& button : midi.Parts("button")) ReadButtons(button, map);
  const SurfaceMap own;
  if (map.dials.size() > own.dials.size())
    midi.Fault("dial",
               fmt::format("are {} in all, and the board has {}", map.dials.size(), own.dials.size()));
  if (map.buttons.size() > own.buttons.size())
    midi.Fault("button",
               fmt::format("are {} in all, and the board has {}", map.buttons.size(), own.buttons.size()));
  return map;
}

// A folder of pictures that is no absolute path begins where the file lies.
SurfaceMap ReadMap(toml::Section file, const fs::path& folder) {
  file.AllowOnly({"name", "usb", "counts_per_turn", "dials", "buttons", "pictures", "midi"});
  SurfaceMap map;
  map.name = file.Text("name");
  map.usb = ReadUsb(file);
  map.counts_per_turn = file.WholeOr("counts_per_turn", 0, 0, kMostCountsOfATurn);
  ReadTargets(file, "dials", map.dials);
  ReadTargets(file, "buttons", map.buttons);
  const std::string pictures = file.TextOr("pictures", "");
  if (!pictures.empty()) map.pictures = folder / pictures;
  if (file.Has("midi")) map.midi = ReadMidi(file.Part("midi"));
  return map;
}

}  // namespace

// Until a file lists others each button of the device is the board's button of the same number.
SurfaceMap::SurfaceMap() {
  for (std::size_t n = 0; n < buttons.size(); ++n) buttons[n] = static_cast<std::uint8_t>(n);
}

// By name, so that of two files for one device it is always the same that is refused. A folder that cannot be
// read is the only fault then.
std::vector<std::string> ReadSurfaceMaps(const fs::path& folder, std::vector<SurfaceMap>& maps) {
  const auto files = ListFolder(folder);
  if (!files) return {files.error().message()};
  std::vector<std::string> wrong;
  for (const fs::path& path : *files) {
    if (path.extension() != ".toml") continue;
    const auto value = toml::ReadToml(path);
    if (!value) {
      wrong.push_back(value.error().message());
      continue;
    }
    toml::Faults faults(path.string());
    toml::Section file(*value, "", faults);
    SurfaceMap map = ReadMap(file, folder);
    for (const SurfaceMap::UsbId& id : map.usb)
      if (const SurfaceMap* other = MapFor(maps, id.vendor, id.product))
        file.Fault("usb", fmt::format("{:04x}:{:04x} is the {} already", id.vendor, id.product, other->name));
    wrong.insert(wrong.end(), faults.lines().begin(), faults.lines().end());
    if (!faults.any()) maps.push_back(std::move(map));
  }
  return wrong;
}

// A walk over all ids: it is asked when a device is found and plugged in, not for each report.
const SurfaceMap* MapFor(const std::vector<SurfaceMap>& maps, std::uint16_t vendor, std::uint16_t product) {
  const SurfaceMap::UsbId id{vendor, product};
  const auto found = std::ranges::find_if(
      maps, [&](const SurfaceMap& map) { return std::ranges::find(map.usb, id) != map.usb.end(); });
  return found == maps.end() ? nullptr : &*found;
}

}  // namespace kaori::input
