// Slot B of a disk as a bad version would be: a system whose root is whole, by its tree of hashes, and whose programs are not.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori::hil {

// Machine code of x86-64, to be put where a program begins.
//
// ud2: the kernel ends the program by SIGILL.
inline constexpr std::string_view kInvalidInstruction = "\x0F\x0B";
// A jump to itself: the program runs and does nothing.
inline constexpr std::string_view kTurnsForEver{"\xEB\xFE", 2};
// exit(0), by the kernel's call itself.
inline constexpr std::string_view kEndsAtOnce{"\xB8\x3C\x00\x00\x00\x31\xFF\x0F\x05", 9};

// The root of slot B, in memory while it is changed. The machine is off. One thread.
class BadSlot {
 public:
  // `image` is the image's folder, by whose files programs are found in the root: a root is not packed. The disk's slot B must hold that
  // image's system. Work files go into `folder`. Errors: those of the files; invalid_argument, the image or the disk is not as expected.
  static Result<BadSlot> Open(std::string disk, std::string image, std::string folder);

  // `code` in place of what a program of /usr/bin does first. Errors: invalid_argument, it is not in the root, or no program.
  Result<void> Begin(const std::string& program, std::string_view code);
  // The one `text` of a program becomes `other`, which is as long. Errors: invalid_argument, it has no such text or two of them, or as above.
  Result<void> Replace(const std::string& program, std::string_view text, std::string_view other);
  // Writes the root, a new tree of hashes, and the root of that tree into the kernel's command line. Errors: those of the files and of
  // veritysetup; invalid_argument, the kernel of slot B has no such line.
  Result<void> Write() const;

 private:
  // How the kernel is told of the root: words of dm-verity's table, as cmdline-b has them.
  struct Verity {
    std::string tree, blocks, digest, hash, salt;
  };
  BadSlot(std::string disk, std::string image, std::string folder, Verity verity, std::string root)
      : disk_(std::move(disk)),
        image_(std::move(image)),
        folder_(std::move(folder)),
        verity_(std::move(verity)),
        root_(std::move(root)) {}
  static Result<Verity> ReadVerity(const std::string& image);
  // The bytes of a program, as the image's build left them.
  Result<std::string> BytesOf(const std::string& program) const;
  // Puts `bytes` into the root, where it has this place of a file. Errors: invalid_argument, it has it nowhere, or twice.
  Result<void> Put(const std::string& file, std::uint64_t at, std::string_view bytes);

  // The disk's file, the image's folder, and that of work files.
  std::string disk_, image_, folder_;
  // Of the image, before anything was changed.
  Verity verity_;
  // The bytes of the whole root, some hundred megabytes.
  std::string root_;
};

// Each `text` on the boot partition becomes `other`, which is as long: the command line of a kernel that is not signed. Errors:
// those of the file; invalid_argument, there is no such text.
Result<void> ReplaceOnBoot(const std::string& disk, std::string_view text, std::string_view other);

}  // namespace kaori::hil
