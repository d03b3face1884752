#include "appliance/programs/input/learnt_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "appliance/core/toml/value.h"
#include "appliance/programs/input/settings.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::input {
namespace {

// Of knobs with detents, of optical encoders, and of the boxes of 1993.
constexpr std::array kUsualCounts{24,  32,  36,  48,  64,   72,   96,   100, 128,
                                  200, 256, 400, 512, 1000, 1024, 2048, 4096};
constexpr int kPercentOff = 4;

const toml::Value* ValueOf(const toml::Value& table, std::string_view key, toml::Value::Kind kind) {
  const toml::Value* const value = toml::Find(table, key);
  return value != nullptr && value->kind == kind ? value : nullptr;
}

// A name is the device's own: what would end a text of TOML, or be no text at all, is left out.
std::string Written(std::string name) {
  std::erase_if(name,
                [](char letter) { return letter < ' ' || letter == 127 || letter == '"' || letter == '\\'; });
  return name;
}

}  // namespace

// The nearest by counts, and then its share: between 96 and 100 the nearer one is taken, whichever it is, since the difference
// is less than a hand's own.
int UsualCounts(int counts) {
  const auto off = [counts](int usual) { return std::abs(usual - counts); };
  const int nearest = *std::ranges::min_element(kUsualCounts, {}, off);
  return 100 * off(nearest) <= kPercentOff * nearest ? nearest : counts;
}

// A file that a person has edited is read like one of ours. Whatever is wrong in it, operators can play: the counts of the settings and
// of the surface's file count then, as before anything was learnt.
LearntTurns::LearntTurns(std::filesystem::path file) : file_(std::move(file)) {
  if (file_.empty() || !std::filesystem::exists(file_)) return;
  const auto read = toml::ReadToml(file_);
  if (!read) {
    LogWarning("{}; what was learnt of turns does not count", read.error().message());
    return;
  }
  const toml::Value* const list = ValueOf(*read, "device", toml::Value::Kind::kList);
  for (const toml::Value& one : list != nullptr ? list->list : std::vector<toml::Value>{}) {
    const toml::Value* const usb = ValueOf(one, "usb", toml::Value::Kind::kText);
    const toml::Value* const name = ValueOf(one, "name", toml::Value::Kind::kText);
    const toml::Value* const counts = ValueOf(one, "counts_per_turn", toml::Value::Kind::kNumber);
    const bool is_whole = usb != nullptr && name != nullptr && counts != nullptr && counts->number >= 1 &&
                          counts->number <= kMostCountsOfATurn &&
                          counts->number == std::floor(counts->number);
    if (is_whole)
      devices_.push_back({usb->text, name->text, static_cast<int>(counts->number)});
    else
      LogWarning("{}:{}: is no device with its counts of a turn", file_.string(), one.line);
  }
}

// The name as it is written, so that what is read back is found again.
LearntTurns::Device LearntTurns::DeviceOf(const ports::HidIdentity& identity) {
  return {.usb = fmt::format("{:04x}:{:04x}", identity.vendor, identity.product),
          .name = Written(identity.name)};
}

// A handful of devices at most: they are looked through at each plug alone.
int LearntTurns::CountsOf(const ports::HidIdentity& identity) const {
  const Device device = DeviceOf(identity);
  for (const Device& one : devices_)
    if (one.usb == device.usb && one.name == device.name) return one.counts;
  return 0;
}

// The file is written before anything changes, so that what plays is what a start would play.
Result<void> LearntTurns::Keep(const ports::HidIdentity& identity, int counts) {
  if (file_.empty())
    return Fail(std::errc::operation_not_supported, "keep what one turn of a dial has, without --turns");
  Device device = DeviceOf(identity);
  device.counts = counts;
  std::vector<Device> devices = devices_;
  std::erase_if(devices, [&](const Device& one) { return one.usb == device.usb && one.name == device.name; });
  devices.push_back(std::move(device));
  std::string text = "# Written by kaori-input, from turns that somebody made in learn mode.\n";
  for (const Device& one : devices)
    text += fmt::format("\n[[device]]\nusb = \"{}\"\nname = \"{}\"\ncounts_per_turn = {}\n", one.usb,
                        one.name, one.counts);
  ExpectLongCall();  // A worn card may take seconds for what is to be safe on it.
  if (auto written = WriteWholeFile(file_, {AsBytes(text)}); !written) return written;
  devices_ = std::move(devices);
  return {};
}

}  // namespace kaori::input
