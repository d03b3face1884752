// The board: shared memory in which every input stands as it is now, one writer for each section. Programs
// meet nowhere else, and none ever waits for another.
//
//   auto board = Board::Create("/dev/shm/kaori-board");
//   auto surface = board->AcquireWriter<Surface>();    // One writer at a time, on the whole machine.
//   surface->Write(value, clock.now(), SourceState::kLive);
//   Stamped<Stick> right = board->Read<Stick>(1);      // Any process, any time.
//
// A value is never torn: slots.h gives a reader one whole value or none, and valid.h throws out those that no
// working writer could have written. A value can be old: its stamp says when it became true, and its
// SourceState whether the device behind it still answers. What an old value means is said at each section in
// sections.h. A writer that died leaves its last value with the state kLive, so readers of a program that
// must be alive (the stage, a calibration) compare the stamp with their own clock, or ask HasWriter.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/board/layout.h"
#include "appliance/core/board/mapping.h"
#include "appliance/core/board/sections.h"
#include "appliance/core/board/valid.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::board {

namespace internal {

// The right to write one section: its lock, its pages, and what was published last. board.cpp has it.
class OwnSection;

// The sections that this process writes by one board object; the board moves them with itself. The board owns
// this list by a pointer, so that a Board that is moved keeps it at one address for its writers.
struct OwnSections {
  OwnSections() = default;
  OwnSections(const OwnSections&) = delete;
  OwnSections& operator=(const OwnSections&) = delete;
  // Tells each writer that is still there that its board is gone.
  ~OwnSections();
  std::vector<OwnSection*> members;
};

template <class T>
using ValueArray = std::array<std::uint32_t, ValueWords<T>()>;

// A value as it lies in a slot: the stamp in nanoseconds of CLOCK_MONOTONIC (two words, in the machine's byte
// order), the SourceState, one word that is zero, then the bytes of T. Processes that share a board run on
// one machine, so no byte order needs to be agreed on.
template <class T>
ValueArray<T> ToWords(const T& value, Time at, SourceState source) {
  ValueArray<T> words{};
  const std::int64_t at_ns = at.time_since_epoch().count();
  std::memcpy(words.data(), &at_ns, sizeof(at_ns));
  words[2] = static_cast<std::uint32_t>(source);
  std::memcpy(words.data() + kStampWords, &value, sizeof(T));
  return words;
}

// The inverse of ToWords. It accepts any words: what it gives may hold impossible values, which Board::Read
// checks.
template <class T>
Stamped<T> FromWords(const ValueArray<T>& words) {
  Stamped<T> stamped;
  std::int64_t at_ns = 0;
  std::memcpy(&at_ns, words.data(), sizeof(at_ns));
  stamped.at = Time{} + Duration(at_ns);
  stamped.source = static_cast<SourceState>(words[2]);
  std::memcpy(static_cast<void*>(&stamped.value), words.data() + kStampWords, sizeof(T));
  return stamped;
}

}  // namespace internal

// The right to write one section, held until it is destroyed or its process ends in whatever way. Untyped;
// see Writer<T>. One thread, that of its board.
class SectionWriter {
 public:
  // Made by Board::AcquireWriter alone.
  explicit SectionWriter(std::unique_ptr<internal::OwnSection> section);
  SectionWriter(SectionWriter&&) noexcept;
  SectionWriter& operator=(SectionWriter&&) noexcept;
  ~SectionWriter();
  // Writes the words of one value (ToWords) and returns without waiting. `value` has exactly the words of the
  // section; it is copied, and kept for a board that takes this one's place.
  void Publish(std::span<const std::uint32_t> value);

 private:
  std::unique_ptr<internal::OwnSection> section_;
};

// The typed right to write the section of T. Movable; the section is free for another writer when it is
// destroyed. Used by the thread of its board, since Board::Heal moves the pages that it writes to.
template <class T>
class Writer {
 public:
  explicit Writer(SectionWriter writer) : writer_(std::move(writer)) {}

  // `at` is when the value became true, not when it is written. Never waits. The board refuses nothing: a
  // value that is not Valid is passed over by every reader.
  void Write(const T& value, Time at, SourceState source) {
    writer_.Publish(internal::ToWords(value, at, source));
  }

 private:
  SectionWriter writer_;
};

// One thread for each object; any number of objects on one file, in any number of processes.
class Board {
 public:
  // Opens the board at `path`, and makes it first where there is none or a spoilt one, so that programs may
  // start in any order. Blocks for the file system. Errors: as OpenOrMakeFile and Mapping::Map.
  static Result<Board> Create(const std::string& path);

  // Opens a board that exists and makes nothing: for programs that only look. It needs no more than the right
  // to read the file. Errors: as OpenFile and Mapping::Map.
  static Result<Board> Open(const std::string& path);

  // Looks whether the file at the path is still this board, whole and sound, and moves to the one that is
  // there, made anew where it is missing or spoilt. Writers move too, and what each wrote last is on the new
  // board at once. True: the board is another one than before. To be called every kHealPeriod, by the loop's
  // thread; takes three system calls where all is well, and two for each writer. Errors:
  //   as OpenOrMakeFile and Mapping::Map   the board stays as it was, for the next try
  //                                        (of permission_denied: one who may make files there makes it)
  //   device_or_resource_busy   the board has moved, but another process writes a section of ours
  Result<bool> Heal();
  // Two seconds are promised for all programs to be on one good board again. A loss is noticed within one
  // period by whoever looks first, and by the others within one more; the rest is for programs that are busy
  // or starting.
  static constexpr Duration kHealPeriod = std::chrono::milliseconds(250);

  // False: the file was cut short beneath us, and everything reads as absent until Heal.
  bool intact() const;
  // How often Heal has moved to another board since this object was made. A reader that compares counters
  // looks at it, since the counters of another board begin elsewhere.
  std::uint32_t moves() const { return moves_; }

  // Acquires the right to write the section of T (of the two sticks, number `which`). The writer may outlive
  // the board object, and does not move any more then. Errors:
  //   device_or_resource_busy    another writer holds it; names the section and the other's process
  //   no_such_file_or_directory  the board's file was removed or replaced meanwhile
  //   permission_denied
  template <class T>
  Result<Writer<T>> AcquireWriter(int which = 0) const {
    return AcquireSection(SectionOf<T>(which)).map([](SectionWriter&& w) { return Writer<T>(std::move(w)); });
  }

  // The newest valid value, else an older valid one that still stands on the board, else T{} with kAbsent.
  // Never waits, whatever the writer does: tries a bounded number of times. An older value of up to three
  // writes ago stands in where the newest one was written by a faulty program, or was overwritten while it
  // was copied. The stamp is that of the value which is given.
  template <class T>
  Stamped<T> Read(int which = 0) const {
    internal::ValueArray<T> words;
    for (std::uint32_t age = 0; age < kSlots; ++age) {
      if (!Fetch(SectionOf<T>(which), age, words)) continue;
      const Stamped<T> read = internal::FromWords<T>(words);
      if (Valid(read.at) && Valid(read.source) && Valid(read.value)) return read;
    }
    return {};
  }

  // Whether anybody, in whatever process, has the right to write the section of T now. Whoever ended has let go of it, in
  // whatever way it ended; one that hangs has not. Asked of the file that this object reads: of one that was replaced
  // meanwhile it tells of who has not moved yet. False where the file cannot be asked. One system call, which needs no
  // more than the right to read.
  template <class T>
  bool HasWriter(int which = 0) const {
    return HasWriter(SectionOf<T>(which));
  }

  // Where the board lies, as it was opened; other files of the programs lie beside it.
  const std::string& path() const { return path_; }

 private:
  Board(std::string path, UniqueFd file, Mapping mapping)
      : path_(std::move(path)), file_(std::move(file)), mapping_(std::move(mapping)) {}
  // Maps an opened and checked file.
  static Result<Board> Over(const std::string& path, UniqueFd file);
  // The untyped half of AcquireWriter.
  Result<SectionWriter> AcquireSection(Section section) const;
  // The untyped half of Read: `value` has the words of the section; false where that generation cannot be
  // had.
  bool Fetch(Section section, std::uint32_t age, std::span<std::uint32_t> value) const;
  // The untyped half of HasWriter.
  bool HasWriter(Section section) const;

  std::string path_;
  // The file that is mapped now. Its inode is compared with the one at the path, to see whether it was
  // replaced.
  UniqueFd file_;
  Mapping mapping_;  // Read only: a reader cannot spoil the board.
  std::uint32_t moves_ = 0;
  std::unique_ptr<internal::OwnSections> own_ = std::make_unique<internal::OwnSections>();
};

}  // namespace kaori::board
