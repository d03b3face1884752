#include "appliance/programs/editor/work_writer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kaori::editor {
namespace {

constexpr std::chrono::milliseconds kWriterPause{500};  // Between two writes of the journal.

}  // namespace

bool WorkWriter::Requests::any() const {
  return !records.empty() || std::ranges::any_of(files, [](const auto& file) { return file.has_value(); });
}

// WriteAll runs on the writer's thread and nowhere else: journal, folder and points are its own from here on.
WorkWriter::WorkWriter(std::optional<Journal> journal, std::filesystem::path folder, Points points)
    : journal_(std::move(journal)),
      folder_(std::move(folder)),
      points_(std::move(points)),
      writer_(kWriterPause, [this] { return WriteAll(); }) {}

// A drag gives a change each frame; only where it ended matters, so that its changes are one record as long
// as they were not written yet.
void WorkWriter::Note(Change change, const Work& work) {
  if (change == Change::kNone || !journal_) return;
  std::unique_lock lock(mutex_);
  auto& records = asked_.records;
  const bool goes_on =
      change == Change::kReplaced && !records.empty() &&
      (records.back().change == Change::kReplaced || records.back().change == Change::kPushed);
  if (goes_on)
    records.back().work = work;
  else
    records.push_back({change, work});
  lock.unlock();
  writer_.Ask();
}

// Saving and removing go by slots: of two requests for one slot that wait, the later one counts.
void WorkWriter::Save(const Work& work) {
  Request({work, false});
}

void WorkWriter::Remove(const Work& work) {
  Request({work, true});
}

// At once and not after the pause: an author who saves wants to switch the box off.
void WorkWriter::Request(FileRequest file) {
  {
    const std::scoped_lock lock(mutex_);
    asked_.files[static_cast<std::size_t>(file.work.slot)] = std::move(file);
  }
  writer_.Ask(/*at_once=*/true);
}

// The flag is cleared under the lock, so that no outcome is left behind unseen.
std::vector<Outcome> WorkWriter::DrainOutcomes() {
  const std::scoped_lock lock(mutex_);
  has_outcomes_.store(false, std::memory_order_release);
  return std::exchange(outcomes_, {});
}

// The lock is held to take and to put back, never while the disk is waited for.
bool WorkWriter::WriteAll() {
  Requests requests;
  {
    const std::scoped_lock lock(mutex_);
    requests = std::exchange(asked_, {});
  }
  Attempt(requests);
  const std::scoped_lock lock(mutex_);
  PutBack(requests);
  return !asked_.any();
}

// The journal first: it is what a crash must not lose. Files are tried even where it failed.
void WorkWriter::Attempt(Requests& requests) {
  if (!requests.any()) return;
  const auto noted = WriteRecords(requests.records);
  const auto saved = WriteFiles(requests);
  TellWhetherItWorks(noted ? saved : noted);
}

// All that is before a new beginning is of no use any more. `records` is empty afterwards only where all of
// it is on the disk; what is left is tried again.
Result<void> WorkWriter::WriteRecords(std::vector<Record>& records) {
  if (records.empty() || !journal_) return {};
  const auto begun = std::find_if(records.rbegin(), records.rend(),
                                  [](const Record& record) { return record.change == Change::kBegun; });
  if (begun != records.rend()) {
    records.erase(records.begin(), std::prev(begun.base()));
    if (auto cleared = journal_->Clear(); !cleared) return cleared;
  }
  std::vector<std::uint8_t> bytes;
  for (const Record& record : records) Encode(record, bytes);
  auto written = journal_->Append(bytes);
  if (written) records.clear();
  return written;
}

// Each file stands for itself: one that cannot be written does not keep the others.
Result<void> WorkWriter::WriteFiles(Requests& requests) {
  Result<void> outcome;
  for (auto& file : requests.files) {
    if (!file) continue;
    auto done =
        file->remove ? RemoveFromStore(folder_, file->work.slot) : WriteToStore(folder_, file->work, points_);
    if (!done) {
      outcome = std::move(done);
      continue;
    }
    Tell({file->remove ? Outcome::Kind::kRemoved : Outcome::Kind::kSaved, std::move(file->work), {}});
    file.reset();
  }
  return outcome;
}

// What failed comes before what was asked for since; a newer file for a slot stands for the older one.
void WorkWriter::PutBack(Requests& requests) {
  asked_.records.insert(asked_.records.begin(), std::make_move_iterator(requests.records.begin()),
                        std::make_move_iterator(requests.records.end()));
  for (std::size_t slot = 0; slot < asked_.files.size(); ++slot)
    if (!asked_.files[slot]) asked_.files[slot] = std::move(requests.files[slot]);
}

// Called by the writer's thread; the flag spares the stage a lock in every frame.
void WorkWriter::Tell(Outcome outcome) {
  const std::scoped_lock lock(mutex_);
  outcomes_.push_back(std::move(outcome));
  has_outcomes_.store(true, std::memory_order_release);
}

// Only the change is told, since a full disk is tried twice a second.
void WorkWriter::TellWhetherItWorks(const Result<void>& outcome) {
  if (outcome.has_value() != failing_) return;  // As before.
  failing_ = !outcome;
  Tell({failing_ ? Outcome::Kind::kFailing : Outcome::Kind::kWorking,
        {},
        outcome ? "" : outcome.error().message()});
}

}  // namespace kaori::editor
