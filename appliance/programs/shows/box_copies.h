// Backups at the box: writes one onto a stick, takes one from it, and puts back what the last restore took away.
#pragma once

#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/backup/writer.h"
#include "appliance/programs/shows/menu.h"
#include "appliance/programs/shows/restoration.h"
#include "drivers/base/unique_fd.h"

namespace kaori::shows {

// What a backup is of, and what is asked of the box meanwhile. The functions are called by the thread of BoxCopies.
struct CopyPlaces {
  // Of the box: /var/lib/kaori.
  std::filesystem::path data;
  // Of the box, as a part of a file's name.
  std::function<std::string()> name;
  // The box's clock, which may be wrong.
  std::function<std::time_t()> wall;
  // Of the stick, while a backup is written.
  std::function<Result<void>(bool)> set_writable;
};

// One that was made for the desk.
struct BackupFile {
  std::string name;
  UniqueFd file;  // For reading, from its beginning.
};

// "left-lobby-1a2b3c4d-20261123-221005.kaorishow". Pure but for the time zone.
std::string BackupFileName(const std::string& box, std::time_t wall);

// One thread. Blocks for the disk, for the stick, and for the trial of a show.
class BoxCopies {
 public:
  BoxCopies(CopyPlaces places, Trial trial);
  // A backup that is half written is taken off the stick, and a restore that nobody has confirmed leaves nothing.
  ~BoxCopies();

  // Lines of the list, besides the backups that lie on a stick (offers.h).
  std::vector<Choosable> Offers(bool has_stick) const;

  // Begins what was taken: kBackup, kRestore or kPutBack. `keys` are those that the box trusts. To be called while it is
  // not busy.
  Progress Begin(const Choosable& taken, const std::filesystem::path& stick, show::PublicKeys keys);
  // The same for the desk: a backup that is fetched there, whose file has no room beside the disk's own, and one that was brought
  // there as an open file.
  Progress BeginForDesk();
  Progress BeginRestore(std::string name, UniqueFd file, show::PublicKeys keys);
  // The backup that BeginForDesk began, once it is whole, and once only. The file has no name any more: it goes with the descriptor.
  std::optional<BackupFile> ReleaseForDesk();
  // To be called while busy(): the next piece, 1 MiB at most.
  Progress Step();
  bool busy() const { return writer_.has_value() || (restoration_ && !restoration_->ended()); }
  // Of what is busy: a backup is made beside a show that plays; a restore ends with the box switched off, and nobody begins one
  // during a show.
  bool is_backup() const { return writer_.has_value(); }
  // Of the box, as a part of a file's name.
  std::string box() const { return places_.name(); }
  // Of what is on its way, or ended last: stands before what is said.
  const std::string& name() const { return name_; }

  // A backup is on the box and waits for an answer; the list is then that of the answers, with the differences below it.
  bool asks() const { return restoration_ && restoration_->progress().message == Message::kAskChange; }
  // No comes first, since GO takes the first line.
  static std::vector<Choosable> Answers();
  // As Restoration has them; of more than a small screen has lines for, the rest is counted.
  std::vector<std::string> Differences() const;
  // Ends the question: kRestoreWaits, kLeft, or a refusal.
  Progress Answer(bool yes);

 private:
  // EndBackup makes the stick one that cannot be written again, however the backup ended.
  Progress BeginBackup(const std::filesystem::path& stick);
  Progress WriteInto(const std::filesystem::path& folder);
  Progress BeginReading(Result<std::unique_ptr<backup::Input>> input, show::PublicKeys keys);
  Progress StepBackup();
  Progress EndBackup(const Result<void>& written);
  Progress EndForDesk(const Result<void>& written);

  CopyPlaces places_;
  Trial trial_;
  std::string name_;
  std::optional<backup::Writer> writer_;
  // What is written, or was written last, is for the desk; then the file that it has not taken yet.
  bool for_desk_ = false;
  std::optional<BackupFile> ready_;
  std::optional<Restoration> restoration_;
};

}  // namespace kaori::shows
