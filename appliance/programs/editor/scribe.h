// Writes what the needles want kept, on a thread of its own: no frame waits for a disk.
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "appliance/programs/editor/journal.h"
#include "appliance/programs/editor/store.h"

namespace kaori::editor {

// What became of what was to be kept.
struct News {
  enum class Kind : std::uint8_t { kSaved, kRemoved, kFailing, kWorking } kind{};
  Work work{};         // kSaved, kRemoved: which.
  std::string text{};  // kFailing: the reason. kWorking: all is on the disk again.
};

// Called by one thread. Its own thread writes the journal at most every half second, and waits for the disk;
// files are written at once. What cannot be written stays in memory and is tried again every half second.
class Scribe {
 public:
  // Without a journal nothing is noted.
  Scribe(std::optional<Journal> journal, std::filesystem::path folder, Points points);
  // Writes what is left, as far as the disk takes it.
  ~Scribe();
  Scribe(const Scribe&) = delete;
  Scribe& operator=(const Scribe&) = delete;

  void Note(Change change, const Work& work);
  void Save(const Work& work);  // To its place.
  void Remove(const Work& work);

  bool has_news() const { return has_news_.load(std::memory_order_acquire); }
  std::vector<News> DrainNews();

  // Waits until all that was asked for has been tried once. For tests, and for an orderly end.
  void Finish();

 private:
  struct Errand {
    Work work;
    bool remove = false;
  };
  struct Duties {
    std::vector<Record> records;
    std::array<std::optional<Errand>, kPlaces> errands;
    bool any() const;
  };

  void Run();
  void Attempt(Duties& duties);
  Result<void> WriteRecords(std::vector<Record>& records);
  Result<void> DoErrands(Duties& duties);
  void GiveBack(Duties& duties);
  void Tell(News news);
  void TellOutcome(const Result<void>& outcome);
  void Demand(Errand errand);

  std::optional<Journal> journal_;
  std::filesystem::path folder_;
  Points points_;

  std::mutex mutex_;
  std::condition_variable changed_;
  Duties asked_;
  std::vector<News> news_;
  std::atomic<bool> has_news_ = false;
  bool urgent_ = false;  // A file, or the end: not to wait for the half second.
  bool busy_ = false;
  bool ending_ = false;
  bool failing_ = false;  // Of the thread alone.
  std::thread thread_;    // Last: it uses all the others.
};

}  // namespace kaori::editor
