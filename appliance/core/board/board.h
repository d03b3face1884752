// The board: shared memory in which every input stands as it is now, one writer for each section.
//
//   auto board = Board::Create("/dev/shm/kaori-board");
//   auto surface = board->AcquireWriter<Surface>();            // One writer at a time, on the whole machine.
//   surface->Write(value, clock.now(), SourceState::kLive);
//   Stamped<Stick> right = board->Read<Stick>(1);      // Any process, any time.
#pragma once

#include <array>
#include <cstring>
#include <span>
#include <string>

#include "appliance/core/board/layout.h"
#include "appliance/core/board/sections.h"
#include "appliance/core/board/valid.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::board {

// Shared pages of the board's file; unmapped when the owner goes.
class Mapping {
 public:
  static Result<Mapping> Map(int fd, bool writable, const std::string& path);
  Mapping(Mapping&& other) noexcept : words_(std::exchange(other.words_, nullptr)) {}
  Mapping& operator=(Mapping&& other) noexcept {
    std::swap(words_, other.words_);
    return *this;
  }
  ~Mapping();
  Word* words() const { return words_; }

 private:
  explicit Mapping(Word* words) : words_(words) {}
  Word* words_ = nullptr;
};

// The right to write one section, held until it is destroyed or its process ends in whatever way. Untyped;
// see Writer<T>. One thread.
class SectionWriter {
 public:
  SectionWriter(Section section, UniqueFd lock, Mapping mapping);
  void Publish(std::span<const std::uint32_t> value);

 private:
  Section section_;
  UniqueFd lock_;  // An open file description of its own, which owns the byte-range lock.
  Mapping mapping_;
};

namespace internal {

template <class T>
using ValueArray = std::array<std::uint32_t, ValueWords<T>()>;

template <class T>
ValueArray<T> ToWords(const T& value, Time at, SourceState source) {
  ValueArray<T> words{};
  const std::int64_t at_ns = at.time_since_epoch().count();
  std::memcpy(words.data(), &at_ns, sizeof(at_ns));
  words[2] = static_cast<std::uint32_t>(source);
  std::memcpy(words.data() + kStampWords, &value, sizeof(T));
  return words;
}

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
  // Opens the board at `path`, and makes it first where there is none, so that programs may start in any
  // order. The file appears whole or not at all. Errors: as Open, and those of the file system.
  static Result<Board> Create(const std::string& path);

  // Errors:
  //   no_such_file_or_directory  there is no board
  //   invalid_argument           not a board, or one of another version, layout or size: the attempt says
  //   which permission_denied
  static Result<Board> Open(const std::string& path);

  // Takes the section of T (of the two sticks, number `which`). The writer may outlive the board. Errors:
  //   device_or_resource_busy    another writer holds it; names the section and the holder's process
  //   no_such_file_or_directory  the board's file was removed or replaced meanwhile
  //   permission_denied
  template <class T>
  Result<Writer<T>> AcquireWriter(int which = 0) const {
    return AcquireSection(SectionOf<T>(which)).map([](SectionWriter&& w) { return Writer<T>(std::move(w)); });
  }

  // The newest valid value, else an older valid one that still stands on the board, else T{} with kAbsent.
  // Never waits, whatever the writer does: tries a bounded number of times.
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

  const std::string& path() const { return path_; }

 private:
  Board(std::string path, UniqueFd file, Mapping mapping)
      : path_(std::move(path)), file_(std::move(file)), mapping_(std::move(mapping)) {}
  Result<SectionWriter> AcquireSection(Section section) const;
  bool Fetch(Section section, std::uint32_t age, std::span<std::uint32_t> value) const;

  std::string path_;
  UniqueFd file_;
  Mapping mapping_;  // Read only: a reader cannot spoil the board.
};

}  // namespace kaori::board
