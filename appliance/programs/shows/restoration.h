// Takes a backup from a stick: copies it to the data partition, checks it in every way there is, says how it differs from
// what the box has, and, once somebody has confirmed that, leaves it to the next start (core/restore/apply.h). Until
// then nothing of the box is changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/backup/reader.h"
#include "appliance/core/restore/plan.h"
#include "appliance/core/show/pack_container.h"
#include "appliance/programs/shows/installation.h"
#include "drivers/base/unique_fd.h"

namespace kaori::shows {

// What a restore may count on.
struct RestoreTerms {
  // Of the box: /var/lib/kaori.
  std::filesystem::path data;
  // That the box trusts. Those that the backup brings count as well.
  show::PublicKeys keys;
  // As a show from a stick is tried before it is the box's.
  Trial trial;
  // The box takes the backup's name, too.
  bool with_name = false;
};

// What a backup means to a person who looks at this error of reading it.
Message BackupMessageOf(const Error& error);

// One thread. Destroyed before it was confirmed it leaves nothing behind.
class Restoration final : private backup::Sink {
 public:
  Restoration(RestoreTerms terms, std::unique_ptr<backup::Input> input);
  ~Restoration() override;
  Restoration(const Restoration&) = delete;
  Restoration& operator=(const Restoration&) = delete;

  // The next piece, 1 MiB at most; blocks for the trial of a show. Ends with kAskChange, kNothingDiffers, or a refusal.
  const Progress& Step();
  bool ended() const { return stage_ == Stage::kEnded || stage_ == Stage::kAsks; }
  const Progress& progress() const { return progress_; }

  // While it asks: one line for each thing that would change, "new own/03-smile.toml". Most important first: the show, keys with
  // their fingerprints, each setting, and files. `most` lines and one more, which says how many are left out. Blocks for
  // the disk.
  std::vector<std::string> Differences(std::size_t most = SIZE_MAX) const;
  // Somebody has seen them and agrees. kRestoreWaits, or a refusal.
  const Progress& Confirm();

 private:
  // In their order; kSame and kTry only where the backup has a pack.
  enum class Stage : std::uint8_t { kOpen, kCopy, kSame, kTry, kCompare, kAsks, kEnded };

  // What the reader gives, file by file: each is written below restore/incoming, the reports excepted.
  Result<void> Begin(const backup::Entry& entry) override;
  Result<void> Append(std::span<const std::uint8_t> bytes) override;
  Result<void> End(const backup::Entry& entry) override;

  // One for each stage. Each ends in the next one, or in Refuse. Open looks for room, Copy takes a piece and checks the show's
  // signature at the end, Try draws its scenes, Compare makes the plan and the differences.
  void Open();
  void Copy();
  // Whether the box has the show's pack already, and whole: it need not be there twice.
  void LookForSame();
  void Try();
  void Compare();
  // What is wrong with the pack's signature; nothing where it is good.
  std::optional<Message> CheckSigner() const;
  // Puts the box's own name in place of the one in the settings that were brought.
  Result<void> KeepName();
  // Of a key that the backup brings, behind its path; empty for one that it has not.
  std::string FingerprintOf(const std::string& path) const;
  std::vector<std::string> DifferencesOfSettings() const;
  Result<void> MakePlan();
  // Makes it the restore that waits.
  Result<void> Commit();
  // Ends with that, and leaves nothing of the copy. RefuseDisk does it for an error of the box's own disk.
  void Refuse(Message message, std::string detail = {});
  void RefuseDisk(const Error& error);
  // Where a file of the backup lies until then, by its path.
  std::filesystem::path Staged(const std::string& path) const;

  RestoreTerms terms_;
  std::unique_ptr<backup::Input> input_;
  std::optional<backup::Reader> reader_;
  Stage stage_ = Stage::kOpen;
  Progress progress_{Message::kReadingBackup, {}, 0};
  // The error is of the box's disk, and not of the stick.
  bool is_disk_ = false;
  // The file that is being copied, and its path; not valid for a report, which is read and dropped.
  UniqueFd file_;
  std::string writing_;
  // Its path; empty: there is none.
  std::string pack_;
  // The beginning of it, where its signature stands, and the checksum of all behind that.
  show::PackHeader header_{};
  std::size_t header_bytes_ = 0;
  std::uint64_t pack_bytes_ = 0;
  show::Checksummer pack_sum_;
  // The box's own pack of that name, while it is compared.
  std::unique_ptr<backup::Input> box_pack_;
  backup::Sha256 box_sum_;
  // What would be done; of the paths that it puts these are new, and these there already.
  restore::Plan plan_;
  std::vector<std::string> fresh_, changed_;
};

}  // namespace kaori::shows
