// A PC with UEFI whose disk and whose firmware's variables are copies that it writes: for updates, and for cuts of its power.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {

// From power on until a face moves: the firmware reads a kernel of 24 MiB with an emulated processor, and the loader
// and the kernel come before the first frame, which the processor draws.
inline constexpr Duration kLongestUpdateStart = std::chrono::minutes(10);

// Its files are in a folder of its own below the bench's, and go with it. One thread.
class UpdatedPc {
 public:
  // A copy of the image's disk, and variables of a PC that was never switched on. Errors: as CopyDisk;
  // no_such_file_or_directory, OVMF is not installed.
  static Result<UpdatedPc> Make(Scene& scene);
  // The one that an update waits in and that was restarted to try it, as it stood then: bringing it in once more would
  // take as long again. A copy, which may be tried in any way, with the VariablesLog of the start in which it was brought in. Nothing where
  // none was kept.
  static std::optional<UpdatedPc> Restarted(Scene& scene);
  // Keeps it so. Where it cannot be kept whoever wants it brings the update in anew.
  void KeepRestarted(Scene& scene) const;

  UpdatedPc(UpdatedPc&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}
  UpdatedPc& operator=(UpdatedPc&&) = delete;
  ~UpdatedPc();

  // Gives it power, without its devices: some firmware plays with what it finds. Errors: as Scene::SwitchOn.
  Result<void> Start(Scene& scene) const;
  // The same; what it writes to its disk and its variables is noted in DiskLog and VariablesLog, anew at each start.
  Result<void> StartNoted(Scene& scene) const;

  // Read on the host while the machine runs or is off: QEMU writes the copy itself, and what the guest has flushed is in
  // the file. The partition is read whole, since the host has no loader that knows where the file lies.
  // The slot that starts by itself, 'a' or 'b'; '?' where loader.conf says something else.
  char Default() const;
  // The sector that has this slot's name in loader.conf: one write into it is all that a confirmation is. Errors: invalid_argument,
  // there is no such line.
  Result<DiskSpan> DecidingSector() const;
  // Has loader.conf name this slot, as whoever confirms it does. Errors: invalid_argument, there is no such line.
  Result<void> NameDefault(char slot) const;
  // A file of the data partition as a start would find it: of a copy, whose journal is played. The machine may be writing
  // meanwhile: a copy that was caught in the middle gives another answer at the next look. Nothing where it has more than `most_bytes`.
  std::string Kept(const std::string& name, std::size_t most_bytes = ReadLimits{}.most_bytes) const;
  // Removes such a file while the machine is off. Errors: invalid_argument, there is none; those of debugfs.
  Result<void> Remove(const std::string& name) const;
  // As a worn disk does it after the slot was written and read back well: one bit of the superblock, which is the first
  // thing that is read of a root. The kernel of slot B then refuses it. Errors: io_error.
  Result<void> SpoilSlotB() const;
  // One bit of a file in the root of slot A, in its second page: of a show, and of a program, a stage reads it before its first
  // picture. `file`: as the image's root was made of it. Errors: io_error; invalid_argument, the root has no such page.
  Result<void> SpoilFile(const std::string& file) const;

  std::string Disk() const { return folder_ + "/pc.disk"; }
  std::string Variables() const { return folder_ + "/variables.fd"; }
  std::string DiskLog() const { return folder_ + "/disk.log"; }
  std::string VariablesLog() const { return folder_ + "/variables.log"; }
  // Variables of a PC that was never switched on, in place of those it has. Errors: io_error.
  Result<void> ForgetVariables() const;

 private:
  // Errors: io_error.
  Result<void> FlipBit(std::uint64_t at_bytes) const;
  // Where on the disk loader.conf has the slot's letter. Errors: invalid_argument.
  Result<std::uint64_t> LetterAt() const;
  explicit UpdatedPc(std::string folder) : folder_(std::move(folder)) {}
  // Empty: moved away.
  std::string folder_;
};

// The face is there when the screen is near the image's still, and moves when a later picture differs from the first such
// one: a splash that stands for ever is no face. Errors: timed_out.
Result<void> AwaitUpdateFace(Scene& scene, const char* when, Duration longest = kLongestUpdateStart);

}  // namespace kaori::hil
