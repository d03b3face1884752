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

namespace kaori::shows {

struct CopyPlaces {
  std::filesystem::path data;            // Of the box: /var/lib/kaori.
  std::function<std::string()> name;     // Of the box, as a part of a file's name.
  std::function<std::time_t()> wall;     // The box's clock, which may be wrong.
  std::function<Result<void>(bool)> set_writable;  // Of the stick, while a backup is written.
};

// "left-lobby-1a2b3c4d-20261123-221005.kaorishow". Pure but for the time zone.
std::string BackupFileName(const std::string& box, std::time_t wall);

// One thread. Blocks for the disk, for the stick, and for the trial of a show.
class BoxCopies {
 public:
  BoxCopies(CopyPlaces places, Trial trial);
  ~BoxCopies();

  // Lines of the list, besides the backups that lie on a stick (offers.h).
  std::vector<Choosable> Offers(bool has_stick) const;

  // Begins what was taken: kBackup, kRestore or kPutBack. `keys` are those that the box trusts. To be called while it is
  // not busy.
  Progress Begin(const Choosable& taken, const std::filesystem::path& stick, show::PublicKeys keys);
  // To be called while busy(): the next piece, 1 MiB at most.
  Progress Step();
  bool busy() const { return writer_.has_value() || (restoration_ && !restoration_->ended()); }
  // Of what is on its way, or ended last: stands before what is said.
  const std::string& name() const { return name_; }

  // A backup is on the box and waits for an answer; the list is then that of the answers, with the differences below it.
  bool asks() const { return restoration_ && restoration_->progress().message == Message::kAskRestore; }
  static std::vector<Choosable> Answers();
  std::vector<std::string> Differences() const;
  // Ends the question.
  Progress Answer(bool yes);

 private:
  Progress BeginBackup(const std::filesystem::path& stick);
  Progress StepBackup();
  Progress EndBackup(const Result<void>& written);

  CopyPlaces places_;
  Trial trial_;
  std::string name_;
  std::optional<backup::Writer> writer_;
  std::optional<Restoration> restoration_;
};

}  // namespace kaori::shows
