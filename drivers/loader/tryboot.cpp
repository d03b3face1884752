#include "drivers/loader/tryboot.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "drivers/loader/boot_partition.h"

namespace kaori::loader {
namespace {

using Sector = std::array<std::uint8_t, kSettings_bytes>;

// Partition 0 is the one that the firmware takes by itself, which is what autoboot.txt then says.
constexpr std::string_view kTry = "0 tryboot\n";

// rootfs/image/pi_boot.py writes this text. With tryboot_a_b the firmware reads config.txt in a try too, and not tryboot.txt.
std::string TextFor(ports::Slot by_itself) {
  const auto partition_of = [](ports::Slot slot) {
    return slot == ports::Slot::kA ? kPartitionOfA : kPartitionOfB;
  };
  return std::string("[all]\ntryboot_a_b=1\nboot_partition=") + partition_of(by_itself) +
         "\n[tryboot]\nboot_partition=" + partition_of(ports::Other(by_itself)) + "\n";
}

// autoboot.txt: where it lies, the sector that it is in, and the slot that it has start by itself.
struct Autoboot {
  std::uint64_t at_bytes = 0;
  Sector content{};
  ports::Slot by_itself = ports::Slot::kA;
};

// A file that anybody has changed by hand is not written: what the firmware makes of it nobody here knows.
Result<Autoboot> ReadAutoboot(ports::BlockDevice& partition) {
  const auto place = FindAutoboot(partition);
  if (!place) return tl::unexpected(place.error());
  Autoboot autoboot{.at_bytes = place->at_bytes};
  if (auto ok = partition.Read(place->at_bytes, autoboot.content); !ok) return tl::unexpected(ok.error());
  const std::string_view text(reinterpret_cast<const char*>(autoboot.content.data()),
                              static_cast<std::size_t>(place->bytes));
  for (const auto slot : {ports::Slot::kA, ports::Slot::kB}) {
    autoboot.by_itself = slot;
    if (text == TextFor(slot)) return autoboot;
  }
  return Fail(std::errc::bad_message, "read which slot autoboot.txt names");
}

// Into the file that is there: whoever may write this one need not be let into its folder, which is systemd's.
Result<void> WriteArgument(const std::filesystem::path& file, std::string_view text) {
  const std::string attempt = "write the argument of a restart, " + file.string();
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (!fd.valid() && (errno == EACCES || errno == EPERM || errno == EROFS))
    return Fail(std::errc::permission_denied, attempt);
  if (!fd.valid() || ::write(fd.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    return Fail(std::errc::not_supported, attempt);
  return {};
}

}  // namespace

Result<ports::Slot> Tryboot::Default() {
  return ReadAutoboot(*partition_).map([](const Autoboot& autoboot) { return autoboot.by_itself; });
}

// The firmware knows no slots, only whether it is to try: what is tried is the slot that is not the default.
Result<void> Tryboot::TryOnce(ports::Slot slot) {
  const auto by_itself = Default();
  if (!by_itself) return tl::unexpected(by_itself.error());
  return WriteArgument(argument_, slot == *by_itself ? std::string_view() : kTry);
}

// A sector is on a disk as a whole or not at all, so that this one step is the whole change. A try that was asked for meant the
// slot that is the default from now on, and would have the firmware take the other one.
Result<void> Tryboot::Confirm(ports::Slot slot) {
  auto autoboot = ReadAutoboot(*partition_);
  if (!autoboot) return tl::unexpected(autoboot.error());
  if (autoboot->by_itself == slot) return {};
  if (!ReadFile(argument_).value_or("").empty())
    if (auto ok = WriteArgument(argument_, {}); !ok) return ok;
  std::ranges::copy(TextFor(slot), autoboot->content.begin());
  if (auto ok = partition_->Write(autoboot->at_bytes, autoboot->content); !ok) return ok;
  if (auto ok = partition_->Flush(); !ok) return ok;
  Sector read{};
  if (auto ok = partition_->Read(autoboot->at_bytes, read); !ok) return ok;
  return read == autoboot->content ? Result<void>{} : Fail(std::errc::io_error, "read autoboot.txt back");
}

}  // namespace kaori::loader
