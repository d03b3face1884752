#include "appliance/programs/editor/scribe.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kaori::editor {
namespace {

constexpr std::chrono::milliseconds kScribePause{500};  // Between two writes of the journal.

}  // namespace

bool Scribe::Duties::any() const {
  return !records.empty() ||
         std::ranges::any_of(errands, [](const auto& errand) { return errand.has_value(); });
}

Scribe::Scribe(std::optional<Journal> journal, std::filesystem::path folder, Points points)
    : journal_(std::move(journal)),
      folder_(std::move(folder)),
      points_(std::move(points)),
      thread_([this] { Run(); }) {}

Scribe::~Scribe() {
  {
    const std::scoped_lock lock(mutex_);
    ending_ = urgent_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Scribe::Note(Change change, const Work& work) {
  if (change == Change::kNone) return;
  const std::scoped_lock lock(mutex_);
  if (!journal_) return;
  auto& records = asked_.records;
  const bool goes_on =
      change == Change::kReplaced && !records.empty() &&
      (records.back().change == Change::kReplaced || records.back().change == Change::kPushed);
  if (goes_on)
    records.back().work = work;
  else
    records.push_back({change, work});
  changed_.notify_all();
}

void Scribe::Save(const Work& work) {
  Demand({work, false});
}

void Scribe::Remove(const Work& work) {
  Demand({work, true});
}

void Scribe::Demand(Errand errand) {
  const std::scoped_lock lock(mutex_);
  asked_.errands[static_cast<std::size_t>(errand.work.place)] = std::move(errand);
  urgent_ = true;
  changed_.notify_all();
}

std::vector<News> Scribe::DrainNews() {
  const std::scoped_lock lock(mutex_);
  has_news_.store(false, std::memory_order_release);
  return std::exchange(news_, {});
}

void Scribe::Finish() {
  std::unique_lock lock(mutex_);
  if (!asked_.any() && !busy_) return;
  urgent_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this] { return !urgent_ && !busy_; });
}

void Scribe::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return asked_.any() || ending_ || urgent_; });
    const bool last = ending_;
    urgent_ = false;
    busy_ = true;
    Duties duties = std::exchange(asked_, {});
    lock.unlock();
    Attempt(duties);
    lock.lock();
    GiveBack(duties);
    busy_ = false;
    changed_.notify_all();
    if (last) return;
    changed_.wait_for(lock, kScribePause, [this] { return urgent_; });
  }
}

void Scribe::Attempt(Duties& duties) {
  if (!duties.any()) return;
  const auto noted = WriteRecords(duties.records);
  const auto saved = DoErrands(duties);
  TellOutcome(noted ? saved : noted);
}

// All that is before a new beginning is of no use any more.
Result<void> Scribe::WriteRecords(std::vector<Record>& records) {
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

Result<void> Scribe::DoErrands(Duties& duties) {
  Result<void> outcome;
  for (auto& errand : duties.errands) {
    if (!errand) continue;
    auto done = errand->remove ? RemoveFromStore(folder_, errand->work.place)
                               : WriteToStore(folder_, errand->work, points_);
    if (!done) {
      outcome = std::move(done);
      continue;
    }
    Tell({errand->remove ? News::Kind::kRemoved : News::Kind::kSaved, std::move(errand->work), {}});
    errand.reset();
  }
  return outcome;
}

// What failed comes before what was asked for since; a newer errand for a place stands for the older one.
void Scribe::GiveBack(Duties& duties) {
  asked_.records.insert(asked_.records.begin(), std::make_move_iterator(duties.records.begin()),
                        std::make_move_iterator(duties.records.end()));
  for (std::size_t place = 0; place < asked_.errands.size(); ++place)
    if (!asked_.errands[place]) asked_.errands[place] = std::move(duties.errands[place]);
}

void Scribe::Tell(News news) {
  const std::scoped_lock lock(mutex_);
  news_.push_back(std::move(news));
  has_news_.store(true, std::memory_order_release);
}

void Scribe::TellOutcome(const Result<void>& outcome) {
  if (outcome.has_value() != failing_) return;  // As before.
  failing_ = !outcome;
  Tell(
      {failing_ ? News::Kind::kFailing : News::Kind::kWorking, {}, outcome ? "" : outcome.error().message()});
}

}  // namespace kaori::editor
