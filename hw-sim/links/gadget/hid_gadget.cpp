#include "hw-sim/links/gadget/hid_gadget.h"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/usb_hid.h"

namespace kaori::sim {
namespace {

// Folders of the one function, of the one configuration, and of texts in English.
constexpr std::string_view kFunction = "/functions/hid.0";
constexpr std::string_view kConfiguration = "/configs/c.1";
constexpr std::string_view kEnglish = "/strings/0x409";
constexpr std::size_t kReportLength_bytes = 64;

// An attribute of configfs takes its value in one write; a second write would be a second value.
Result<void> Set(const std::string& path, std::string_view value) {
  const UniqueFd fd(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!fd.valid() || ::write(fd.get(), value.data(), value.size()) != static_cast<ssize_t>(value.size()))
    return FailErrno("set " + path);
  return {};
}

Result<void> MakeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make " + path);
  return {};
}

std::string Hex(std::uint16_t value) {
  return fmt::format("{:#06x}", value);
}

}  // namespace

// A folder that an earlier simulator left is used again. Errors are those of configfs, by its file.
Result<HidGadget> HidGadget::Make(GadgetRoom room, const std::string& name, const HidDeviceName& identity) {
  const std::string path = room.gadgets + "/" + name;
  // The kernel makes the files of a folder as it is made, in this order: the gadget, its
  // strings, its function, its configuration.
  for (const std::string_view folder : {std::string_view(), kEnglish, kFunction, kConfiguration})
    if (auto ok = MakeFolder(path + std::string(folder)); !ok) return tl::unexpected(ok.error());
  HidGadget gadget(std::move(room), path);
  // What a killed simulator left may still be bound, and a bound gadget's values cannot be changed.
  gadget.Unbind();
  if (auto ok = gadget.Describe(identity); !ok) return tl::unexpected(ok.error());
  return gadget;
}

Result<void> HidGadget::Describe(const HidDeviceName& identity) const {
  const std::string function = path_ + std::string(kFunction);
  const std::string english = path_ + std::string(kEnglish);
  const std::string_view descriptor(reinterpret_cast<const char*>(identity.descriptor.data()),
                                    identity.descriptor.size());
  const std::pair<std::string, std::string> values[] = {
      {path_ + "/idVendor", Hex(identity.vendor)},
      {path_ + "/idProduct", Hex(identity.product)},
      {english + "/manufacturer", "Kaori"},
      {english + "/product", identity.name},
      // No boot protocol: a BIOS does not read these devices.
      {function + "/protocol", "0"},
      {function + "/subclass", "0"},
      {function + "/report_length", std::to_string(kReportLength_bytes)},
      {function + "/report_desc", std::string(descriptor)}};
  for (const auto& [file, value] : values)
    if (auto ok = Set(file, value); !ok) return ok;
  std::error_code error;
  const std::string link = path_ + std::string(kConfiguration) + "/hid.0";
  // A function belongs to a configuration by a symbolic link.
  if (!std::filesystem::is_symlink(link, error)) std::filesystem::create_symlink(function, link, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "link " + link);
  return {};
}

// From the inside out, as configfs wants it: a folder that something refers to cannot be
// removed. What is not there needs no going.
HidGadget::~HidGadget() {
  if (path_.empty()) return;
  Unbind();
  ::unlink((path_ + std::string(kConfiguration) + "/hid.0").c_str());
  for (const std::string_view folder : {kConfiguration, kFunction, kEnglish, std::string_view()})
    ::rmdir((path_ + std::string(folder)).c_str());
}

Result<void> HidGadget::Bind(const std::string& controller) {
  return Set(path_ + "/UDC", controller);
}

void HidGadget::Unbind() {
  static_cast<void>(Set(path_ + "/UDC", "\n"));  // Fails where it was not bound.
}

// "237:0": the second number counts the files.
Result<std::string> HidGadget::DeviceFile() const {
  const std::string path = path_ + std::string(kFunction) + "/dev";
  const auto numbers = ReadFile(path);
  if (!numbers) return tl::unexpected(numbers.error());
  const auto colon = numbers->find(':'), end = numbers->find('\n');
  if (colon == numbers->npos || end == numbers->npos || end <= colon + 1)
    return FailInput(path + ": expected two numbers, as 237:0");
  return room_.devices + "/hidg" + numbers->substr(colon + 1, end - colon - 1);
}

}  // namespace kaori::sim
