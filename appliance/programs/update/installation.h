// Brings an update into the slot that does not run: reads and checks the whole file first, then writes root, hash tree
// and kernel of that slot and nothing else, reads each back, and only then notes that it waits. At each moment,
// whatever fails, the slot that runs is untouched and starts by itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "appliance/core/update/bundle.h"
#include "appliance/core/update/compression.h"
#include "appliance/core/update/messages.h"
#include "appliance/programs/update/notes.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/block_device.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::update {

// The file of an update. Nothing of it is believed, and it may go at any moment.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t bytes() const = 0;
  // Fills `into` from `at` on. Blocks for the stick. Errors: those of pread(2); io_error (it ends before).
  virtual Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) = 0;
};

// Of a file that was opened to be read. Errors: those of fstat(2); executable_format_error (kInput) for what is no
// regular file.
Result<std::unique_ptr<Source>> SourceOf(UniqueFd file);

// The system that runs.
struct Running {
  std::uint32_t version = 0;
  // No version below this is ever taken: an older one has a hole that is known.
  std::uint32_t least = 0;
  ports::Slot slot = ports::Slot::kA;
  // What kind of machine it is made for: an update for another kind would never start here.
  std::string product{kProduct};
};

// Where the other slot lies. The partitions must outlive the installation. Nothing else of a disk is written.
struct OtherSlot {
  ports::BlockDevice& root;
  ports::BlockDevice& verity;
  // The partition of both kernels, and where this slot's begins and how long it is.
  ports::BlockDevice& boot;
  std::uint64_t kernel_at = 0;
  std::uint64_t kernel_bytes = 0;
};

// Whether an update may be taken on this box: kFits, or why not. Pure.
Message Judge(const Manifest& manifest, const Running& running, const show::PublicKeys& keys);

// Reads the header of an update. Errors: those of ReadHeader and of the source.
Result<Manifest> ReadManifest(Source& source);

// What an error of ReadManifest means to a person.
Message MessageOf(const Error& error);

// How it stands. `detail` is the reason in the words of the log, English.
struct Progress {
  Message message = Message::kReading;
  std::uint32_t version = 0;
  std::string detail{};
  // Of all the work, 0..1.
  float done = 0;
};

// One thread; all that it borrows must outlive it.
class Installation {
 public:
  Installation(std::unique_ptr<Source> source, show::PublicKeys keys, Running running, OtherSlot slot,
               Notes& notes);

  // Does the next piece, kPiece_bytes at most, and says how it stands. To be called until ended().
  const Progress& Step();
  bool ended() const { return stage_ == Stage::kEnded; }
  const Progress& progress() const { return progress_; }

  // Twenty pieces a second leave a stick and a disk time for others.
  static constexpr std::size_t kPiece_bytes = std::size_t{1} << 20U;

 private:
  // In this order, and none twice but the pair of writing and reading back, once for each part:
  //   kHeader    signature, trust, product, versions and lengths; nothing else of the file is read before
  //   kRead      all of the payload, for its checksum; still nothing was written
  //   kBegin     what waited in the slot before is forgotten: from here on it is half written
  //   kUnpack    of the kernel alone: all of it is unpacked into memory, since a file that is another one at its second
  //              reading is found by the checksum at the end, and a foreign kernel on the disk would start
  //   kWrite     a part is unpacked into its place, or the kernel put there, and flushed at its end
  //   kReadBack  the disk gives the part's checksum, or the update is refused
  //   kNote      the note that it waits is the last thing that is written
  enum class Stage : std::uint8_t { kHeader, kRead, kBegin, kUnpack, kWrite, kReadBack, kNote, kEnded };
  // A part of the update and the place where it goes.
  struct Area {
    Part part;
    ports::BlockDevice* device;
    std::uint64_t at;
    std::uint64_t room_bytes;
  };

  // One for each stage. Each ends in the next one, or in Refuse.
  void AcceptHeader();
  void ReadPiece();
  void Begin();
  void UnpackKernelPiece();
  void WritePiece();
  void ReadPieceBack();
  void Note();
  // Unpacks all of `piece`, or refuses: false.
  bool UnpackPiece(std::span<std::uint8_t> piece);
  // Of the part that is written, where its packed bytes were used up.
  bool RefillPacked();
  void BeginPart();
  bool IsKernel() const { return area_ + 1 == areas_.size(); }
  // Ends it. Where a part of the other slot was written, nothing says that an update waits there.
  void Refuse(Message message, std::string detail = {});
  void RefuseDisk(const Error& error);
  // A note could not be kept.
  void RefuseNote(const Error& error);
  void CountDone(std::uint64_t bytes);
  const Area& area() const { return areas_[area_]; }
  const PackedPart& part() const { return manifest_.part(area().part); }

  // It stands first: its state is aligned to 64 bytes.
  show::Checksummer sum_;
  std::unique_ptr<Source> source_;
  show::PublicKeys keys_;
  Running running_;
  std::array<Area, 3> areas_;
  Notes& notes_;
  Stage stage_ = Stage::kHeader;
  Progress progress_;
  Manifest manifest_;
  // How far the source was read:
  // Of the payload, in the first reading; of the part, afterwards.
  std::uint64_t read_bytes_ = 0;
  // Which of the areas is being written or read back.
  std::size_t area_ = 0;
  std::uint64_t written_bytes_ = 0;
  Unpacker unpacker_;
  // As far as it was unpacked; its checksum fits once all of it is there.
  std::vector<std::uint8_t> kernel_;
  // Read from the source and not unpacked yet: packed_ is what is left of it.
  std::vector<std::uint8_t> buffer_;
  std::span<const std::uint8_t> packed_;
  std::uint64_t done_bytes_ = 0, all_bytes_ = 1;
};

}  // namespace kaori::update
