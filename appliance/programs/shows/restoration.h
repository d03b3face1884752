// Takes a backup from a stick: copies it to the data partition, checks it in every way there is, says how it differs from
// what the box has, and, once somebody has confirmed that, leaves it to the next start (core/restore/apply.h). Until
// then nothing of the box is changed.
#pragma once

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

struct RestoreTerms {
  std::filesystem::path data;  // Of the box: /var/lib/kaori.
  show::PublicKeys keys;       // That the box trusts. Those that the backup brings count as well.
  Trial trial;
  bool with_name = false;      // The box takes the backup's name, too.
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

  // The next piece, 1 MiB at most; blocks for the trial of a show. Ends with kAskRestore, kNothingDiffers, or a refusal.
  const Progress& Step();
  bool ended() const { return stage_ == Stage::kEnded || stage_ == Stage::kAsks; }
  const Progress& progress() const { return progress_; }

  // While it asks: one line for each thing that would change, "new own/03-smile.toml". Most important first.
  std::vector<std::string> Differences() const;
  // Somebody has seen them and agrees. kRestoreWaits, or a refusal.
  const Progress& Confirm();

 private:
  enum class Stage : std::uint8_t { kOpen, kCopy, kSame, kTry, kCompare, kAsks, kEnded };

  Result<void> Begin(const backup::Entry& entry) override;
  Result<void> Append(std::span<const std::uint8_t> bytes) override;
  Result<void> End(const backup::Entry& entry) override;

  void Open();
  void Copy();
  // Whether the box has the show's pack already, and whole: it need not be there twice.
  void LookForSame();
  void Try();
  void Compare();
  // What is wrong with the pack's signature; nothing where it is good.
  std::optional<Message> CheckSigner() const;
  Result<void> KeepName();
  Result<void> MakePlan();
  Result<void> Commit();
  void Refuse(Message message, std::string detail = {});
  void RefuseDisk(const Error& error);
  std::filesystem::path Staged(const std::string& path) const;

  RestoreTerms terms_;
  std::unique_ptr<backup::Input> input_;
  std::optional<backup::Reader> reader_;
  Stage stage_ = Stage::kOpen;
  Progress progress_{Message::kReadingBackup, {}, 0};
  bool is_disk_ = false;  // The error is of the box's disk, and not of the stick.
  UniqueFd file_;
  std::string writing_;
  std::string pack_;  // Its path; empty: there is none.
  show::PackHeader header_{};
  std::size_t header_bytes_ = 0;
  std::uint64_t pack_bytes_ = 0;
  show::Checksummer pack_sum_;
  std::unique_ptr<backup::Input> box_pack_;
  backup::Sha256 box_sum_;
  restore::Plan plan_;
  std::vector<std::string> fresh_, changed_;
};

}  // namespace kaori::shows
