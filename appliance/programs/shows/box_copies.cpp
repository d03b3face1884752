#include "appliance/programs/shows/box_copies.h"

#include <fcntl.h>

#include <array>
#include <utility>

#include "appliance/programs/shows/restore_disk.h"
#include "appliance/programs/shows/support_file.h"
#include "drivers/base/log.h"

namespace kaori::shows {
namespace {

// On the data partition, beside what a restore keeps there; a backup has nothing of it.
constexpr const char* kForDesk = "restore/for-desk";
constexpr std::size_t kMostDifferences = 8;  // Lines that a small screen has beside the list.

// `form` is that of strftime(3), in the box's time zone; a text beyond 63 letters becomes empty.
std::string TimeText(std::time_t wall, const char* form) {
  std::tm local{};
  ::localtime_r(&wall, &local);
  std::array<char, 64> text{};
  return {text.data(), std::strftime(text.data(), text.size(), form, &local)};
}

// The disk's and the stick's errors mean the same to the person: what is written is a stick, or, for the desk, the box's own disk.
Message MessageOfBackup(const Error& error, bool for_desk) {
  if (error.cause == std::errc::text_file_busy) return Message::kChanged;
  return for_desk ? DiskMessageOf(error) : SupportMessageOf(error);
}

}  // namespace

std::string BackupFileName(const std::string& box, std::time_t wall) {
  return box + "-" + TimeText(wall, "%Y%m%d-%H%M%S") + ".kaorishow";
}

BoxCopies::BoxCopies(CopyPlaces places, Trial trial) : places_(std::move(places)), trial_(std::move(trial)) {}

// A backup that was begun and not finished is given up, and the stick is closed for writing again.
BoxCopies::~BoxCopies() {
  if (writer_) static_cast<void>(EndBackup(Fail(std::errc::operation_canceled, "write the backup")));
}

// The way back is there without a stick too.
std::vector<Choosable> BoxCopies::Offers(bool has_stick) const {
  std::vector<Choosable> offers;
  const auto offer = [&](Choosable::Kind kind, const char* name) {
    offers.push_back({.kind = kind, .offer = {.file = {}, .name = name}, .remark = {}});
  };
  if (HasKept(places_.data)) offer(Choosable::Kind::kPutBack, "back to what was here before the restore");
  if (has_stick) offer(Choosable::Kind::kBackup, "backup of this box, onto the stick");
  return offers;
}

// The harmless answer stands first, since the list begins at its first line.
std::vector<Choosable> BoxCopies::Answers() {
  return {
      {.kind = Choosable::Kind::kNo, .offer = {.file = {}, .name = "leave the box as it is"}, .remark = {}},
      {.kind = Choosable::Kind::kYes, .offer = {.file = {}, .name = "yes, restore this"}, .remark = {}}};
}

std::vector<std::string> BoxCopies::Differences() const {
  return asks() ? restoration_->Differences(kMostDifferences) : std::vector<std::string>{};
}

// What was asked before is over: whoever takes something else has not agreed to it.
Progress BoxCopies::Begin(const Choosable& taken, const std::filesystem::path& stick, show::PublicKeys keys) {
  restoration_.reset();
  name_ = taken.kind == Choosable::Kind::kRestore ? taken.offer.name : "";
  if (taken.kind == Choosable::Kind::kBackup) return BeginBackup(stick);
  if (taken.kind == Choosable::Kind::kPutBack) {
    if (auto ok = PutBack(places_.data); !ok) return {Message::kDiskFault, ok.error().message()};
    return {Message::kUndoWaits};
  }
  return BeginReading(backup::OpenInput(taken.offer.file), std::move(keys));
}

Progress BoxCopies::BeginRestore(std::string name, UniqueFd file, show::PublicKeys keys) {
  restoration_.reset();
  name_ = std::move(name);
  return BeginReading(backup::InputOf(std::move(file), name_), std::move(keys));
}

Progress BoxCopies::BeginReading(Result<std::unique_ptr<backup::Input>> input, show::PublicKeys keys) {
  if (!input) return {BackupMessageOf(input.error()), input.error().message()};
  restoration_.emplace(RestoreTerms{places_.data, std::move(keys), trial_}, std::move(*input));
  return restoration_->progress();
}

// Two backups within a second would have one name: the second is refused, since a file that is there is never replaced.
Progress BoxCopies::BeginBackup(const std::filesystem::path& stick) {
  for_desk_ = false;
  if (auto ok = places_.set_writable(true); !ok) return {SupportMessageOf(ok.error()), ok.error().message()};
  return WriteInto(stick);
}

// What an end without a word left there is of no use to anybody.
Progress BoxCopies::BeginForDesk() {
  restoration_.reset();
  ready_.reset();
  for_desk_ = true;
  std::error_code failed;
  std::filesystem::remove_all(places_.data / kForDesk, failed);
  std::filesystem::create_directories(places_.data / kForDesk, failed);
  if (failed) return EndBackup(Fail(static_cast<std::errc>(failed.value()), "make room for a backup"));
  return WriteInto(places_.data / kForDesk);
}

Progress BoxCopies::WriteInto(const std::filesystem::path& folder) {
  const std::string box = places_.name();
  const std::time_t wall = places_.wall();
  name_ = BackupFileName(box, wall);
  auto writer =
      backup::Writer::Begin(places_.data, {box, TimeText(wall, "%Y-%m-%d %H:%M:%S %z")}, folder / name_);
  if (!writer) return EndBackup(tl::unexpected(writer.error()));
  writer_.emplace(std::move(*writer));
  return {Message::kBackingUp};
}

// Each step is short, so that the program answers its buttons in between.
Progress BoxCopies::Step() {
  return writer_ ? StepBackup() : restoration_->Step();
}

Progress BoxCopies::StepBackup() {
  const auto step = writer_->Step();
  if (!step) return EndBackup(tl::unexpected(step.error()));
  return *step ? EndBackup({}) : Progress{Message::kBackingUp};
}

// What is not whole is removed before the stick is closed again.
Progress BoxCopies::EndBackup(const Result<void>& written) {
  writer_.reset();
  if (for_desk_) return EndForDesk(written);
  if (auto closed = places_.set_writable(false); !closed) LogWarning("{}", closed.error().message());
  if (!written) return {MessageOfBackup(written.error(), false), written.error().message()};
  return {Message::kBackedUp, {}, 1};
}

// The file loses its name at once, so that it goes with whoever has it open, whatever happens to this program.
Progress BoxCopies::EndForDesk(const Result<void>& written) {
  const std::filesystem::path folder = places_.data / kForDesk;
  UniqueFd file(written ? ::open((folder / name_).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW) : -1);
  const Result<void> opened = written && !file.valid() ? Result<void>(FailErrno("open the backup")) : written;
  std::error_code none;
  std::filesystem::remove_all(folder, none);
  if (!opened) return {MessageOfBackup(opened.error(), true), opened.error().message()};
  ready_ = BackupFile{name_, std::move(file)};
  return {Message::kBackupForDesk, {}, 1};
}

std::optional<BackupFile> BoxCopies::ReleaseForDesk() {
  return std::exchange(ready_, std::nullopt);
}

// Either answer ends the question; the files of the stick are closed with it.
Progress BoxCopies::Answer(bool yes) {
  Progress progress = yes ? restoration_->Confirm() : Progress{Message::kLeft};
  restoration_.reset();
  return progress;
}

}  // namespace kaori::shows
