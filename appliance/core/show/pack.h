// The show pack: one file, verified when it is opened, copied out of it into a Show, but for textures: they
// stay in the file's memory, and the show keeps that. pack_container.h has the header, pack.fbs the content.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "appliance/core/show/pack_key.h"
#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::show {

// What is asked of a pack, besides that it is whole. A value; it may be used for any number of packs.
struct LoadOptions {
  // Refuse every pack that none of these keys has signed, so all packs where the list is empty; without a
  // list a signature is checked where there is one, and any signer will do.
  std::optional<PublicKeys> signed_by{};
  // The file lies on a read-only file system whose every block the kernel checks, as the box's root: its
  // checksum is not made again, and it is read where it lies: textures when they are first looked at.
  bool on_verified_root = false;
};

// What the options --trust (a file with a public key, or a folder of such files; empty: anybody may sign, or
// nobody) and --verified ask for. Errors: those of ReadPublicKeys.
Result<LoadOptions> LoadOptionsOf(const std::filesystem::path& trust, bool verified);

// Reads and checks a pack; blocks for the file. The file is read once into memory of our own before anything
// in it is believed, so that nobody can change or shorten it between the check and the use. A damaged,
// truncated or foreign file, one of another version, one that is not signed as asked, and a show that
// CheckShow faults are refused with one line that names the file and the reason. Errors:
//   as open(2) and read(2)  the file cannot be read
//   kNoPack ... kForeignPack of pack_container.h, file_too_large
//   invalid_argument        it is damaged, or no sound show
// Any thread; it takes in the order of a millisecond for each megabyte, most of it for the checksum.
Result<Show> LoadPack(const std::filesystem::path& file, const LoadOptions& options = {});

// The sounds of its motions, in their order, an empty one for a motion without; of a show on a verified root
// nothing else is read. Errors: as LoadPack, but for what CheckShow faults elsewhere. For the lip program,
// which plays sounds and draws nothing.
Result<std::vector<Sound>> LoadSounds(const std::filesystem::path& file, const LoadOptions& options = {});

// Who signed a pack, if anybody; reads its header alone. Errors: as LoadPack. The content is not checked: a
// signer is told even of a pack that is damaged behind its header.
Result<std::optional<PublicKey>> ReadSigner(const std::filesystem::path& file);

// The bytes of a pack, signed where a key is given. The show must be sound: LoadPack of the bytes gives the
// same show. The same show and key give the same bytes. `signer` is borrowed for the call.
std::vector<std::uint8_t> EncodePack(const Show& show, const SecretKey* signer = nullptr);

// Writes the file whole or not at all; what stood there is kept until then. Blocks for the disk. The show must be
// sound; `signer` is borrowed for the call. Any thread, but one for each file. Errors: those of WriteWholeFile.
Result<void> SavePack(const Show& show, const std::filesystem::path& file, const SecretKey* signer = nullptr);

// Signs a pack that is there, whoever signed it before, and writes it to `into`, which may be the same file.
// The content is checked as a whole, since whoever signs it answers for it. Errors: as LoadPack, and those of
// WriteWholeFile.
Result<void> SignPack(const std::filesystem::path& file, const std::filesystem::path& into,
                      const SecretKey& signer);

}  // namespace kaori::show
