// Writes what the editor wants kept, on a thread of its own: no frame waits for a disk. The stage's thread
// hands over values and asks for outcomes; the lock between the two threads is never held while a disk is
// waited for.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/editor/journal.h"
#include "appliance/programs/editor/store.h"
#include "drivers/base/background_writer.h"

namespace kaori::editor {

// What became of what was to be kept.
struct Outcome {
  enum class Kind : std::uint8_t { kSaved, kRemoved, kFailing, kWorking } kind{};
  Work work{};         // kSaved, kRemoved: which.
  std::string text{};  // kFailing: the reason. kWorking: all is on the disk again.
};

// Called by one thread. Its own thread writes the journal at most every half second, and waits for the disk;
// files are written at once. What cannot be written stays in memory and is tried again every half second. It
// ends by trying once more to write what is left, whether that succeeds or not.
class WorkWriter {
 public:
  // Without a journal nothing is noted.
  WorkWriter(std::optional<Journal> journal, std::filesystem::path folder, Points points);
  WorkWriter(const WorkWriter&) = delete;
  WorkWriter& operator=(const WorkWriter&) = delete;

  // For the journal: `change` led to `work`. Changes of one gesture that were not written yet become one
  // record.
  void Note(Change change, const Work& work);

  // Writes the file of work.slot, or removes it. A later request for the same slot replaces one that was not
  // done yet.
  void Save(const Work& work);
  // Both return at once; an outcome tells what became of it.
  void Remove(const Work& work);

  // What became of requests since the last call; never waits for the disk.
  bool has_outcomes() const { return has_outcomes_.load(std::memory_order_acquire); }
  // Gives each outcome once, the oldest first.
  std::vector<Outcome> DrainOutcomes();

  // Waits until all that was asked for has been tried once. For tests, and for an orderly end.
  void Finish() { writer_.Finish(); }

 private:
  struct FileRequest {
    Work work;
    bool remove = false;
  };
  // What was asked for and is not on the disk yet: records in order, and at most one file for each slot.
  struct Requests {
    std::vector<Record> records;
    std::array<std::optional<FileRequest>, kSlots> files;
    bool any() const;
  };

  // The writer's function, on its own thread: tries everything once, and gives whether nothing is left.
  bool WriteAll();
  // Each writes what it can and takes that out of what it was given.
  void Attempt(Requests& requests);
  Result<void> WriteRecords(std::vector<Record>& records);
  Result<void> WriteFiles(Requests& requests);
  // Puts what could not be written in front of what has been asked for since.
  void PutBack(Requests& requests);
  // Adds an outcome; TellWhetherItWorks only where the disk has begun to fail, or to work again.
  void Tell(Outcome outcome);
  void TellWhetherItWorks(const Result<void>& outcome);
  void Request(FileRequest file);

  std::optional<Journal> journal_;
  std::filesystem::path folder_;
  Points points_;

  std::mutex mutex_;  // Of what follows, but for has_outcomes_.
  // Shared by both threads, under the mutex.
  Requests asked_;
  std::vector<Outcome> outcomes_;
  std::atomic<bool> has_outcomes_ = false;
  bool failing_ = false;  // Of the thread alone.
  // Last: it uses all the others, and tries once more to write what is left before it ends.
  BackgroundWriter writer_;
};

}  // namespace kaori::editor
