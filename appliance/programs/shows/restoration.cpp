#include "appliance/programs/shows/restoration.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/restore/kept.h"
#include "appliance/programs/shows/restore_disk.h"
#include "appliance/programs/shows/settings_line.h"
#include "drivers/base/folder.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

namespace fs = std::filesystem;

}  // namespace

Message BackupMessageOf(const Error& error) {
  switch (error.cause) {
    case backup::kNoBackup:
      return Message::kNotABackup;
    case backup::kNewerBackup:
      return Message::kNewerBackup;
    case backup::kOutsideBackup:
      return Message::kOutside;
    case backup::kCutOffBackup:
      return Message::kCutOff;
    case std::errc::file_too_large:
      return Message::kTooLarge;
    default:
      return error.kind == ErrorKind::kInput ? Message::kDamaged : Message::kPulled;
  }
}

Restoration::Restoration(RestoreTerms terms, std::unique_ptr<backup::Input> input)
    : terms_(std::move(terms)), input_(std::move(input)) {}

// Where this fails the next one replaces it.
Restoration::~Restoration() {
  static_cast<void>(RemoveFolder(terms_.data / restore::kIncoming));
}

// Outside of the folders that programs of the box read.
fs::path Restoration::Staged(const std::string& path) const {
  return terms_.data / restore::kIncoming / restore::kFiles / path;
}

void Restoration::Refuse(Message message, std::string detail) {
  file_ = {};
  reader_.reset();
  static_cast<void>(RemoveFolder(terms_.data / restore::kIncoming));
  progress_ = {message, std::move(detail), progress_.done};
  stage_ = Stage::kEnded;
}

void Restoration::RefuseDisk(const Error& error) {
  Refuse(DiskMessageOf(error), error.message());
}

const Progress& Restoration::Step() {
  if (stage_ == Stage::kOpen)
    Open();
  else if (stage_ == Stage::kCopy)
    Copy();
  else if (stage_ == Stage::kSame)
    LookForSame();
  else if (stage_ == Stage::kTry)
    Try();
  else if (stage_ == Stage::kCompare)
    Compare();
  return progress_;
}

// Reports stay where they are, so that they need no room.
void Restoration::Open() {
  auto reader = backup::Reader::Begin(std::move(input_));
  if (!reader) return Refuse(BackupMessageOf(reader.error()), reader.error().message());
  reader_.emplace(std::move(*reader));
  const fs::path incoming = terms_.data / restore::kIncoming;
  if (auto ok = RemoveFolder(incoming); !ok) return RefuseDisk(ok.error());
  if (auto ok = MakeFolders(incoming / restore::kFiles); !ok) return RefuseDisk(ok.error());
  std::uint64_t wanted = Installation::kReserve_bytes;
  for (const auto& [member, sum] : reader_->contents().files)
    if (!restore::IsReport(member.path)) wanted += member.bytes;
  const auto free = FreeBytesOf(incoming);
  if (!free) return RefuseDisk(free.error());
  if (*free < wanted) return Refuse(Message::kFull, fmt::format("{} MB are needed", wanted / 1'000'000 + 1));
  stage_ = Stage::kCopy;
}

Result<void> Restoration::Begin(const backup::Entry& entry) {
  writing_ = entry.member.path;
  if (restore::IsReport(writing_)) return {};
  is_disk_ = true;
  if (restore::IsPack(writing_)) {
    pack_ = writing_;
    pack_bytes_ = entry.member.bytes;
  }
  const fs::path file = Staged(writing_);
  if (auto ok = MakeFolders(file.parent_path()); !ok) return ok;
  file_ = UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (!file_.valid()) return FailErrno("write " + file.string());
  is_disk_ = false;
  return {};
}

// The pack's header holds its signature, and is no part of what that signs.
Result<void> Restoration::Append(std::span<const std::uint8_t> bytes) {
  if (!file_.valid()) return {};
  if (writing_ == pack_) {
    const std::size_t head = std::min(bytes.size(), header_.size() - header_bytes_);
    std::copy_n(bytes.begin(), head, header_.begin() + static_cast<std::ptrdiff_t>(header_bytes_));
    header_bytes_ += head;
    pack_sum_.Add(bytes.subspan(head));
  }
  auto written = WriteAll(file_.get(), bytes, writing_);
  is_disk_ = !written;
  return written;
}

// Dropped from memory, so that a large pack does not press out what plays.
Result<void> Restoration::End(const backup::Entry&) {
  if (!file_.valid()) return {};
  is_disk_ = ::fsync(file_.get()) < 0;
  if (is_disk_) return FailErrno("write " + writing_);
  ::posix_fadvise(file_.get(), 0, 0, POSIX_FADV_DONTNEED);
  file_ = {};
  return {};
}

void Restoration::Copy() {
  const auto read = reader_->Step(*this);
  if (!read) {
    if (is_disk_) return RefuseDisk(read.error());
    return Refuse(BackupMessageOf(read.error()), read.error().message());
  }
  if (!*read) return;
  if (pack_.empty()) {
    stage_ = Stage::kCompare;
    return;
  }
  if (const auto wrong = CheckSigner()) return Refuse(*wrong);
  progress_.message = Message::kTrying;
  auto there = backup::OpenInput(terms_.data / pack_);
  if (there) box_pack_ = std::move(*there);
  stage_ = box_pack_ ? Stage::kSame : Stage::kTry;
}

// By the keys of the backup as well, which are shown as what is new before anybody agrees.
std::optional<Message> Restoration::CheckSigner() const {
  const auto seal = show::ReadHeader(std::span(header_).first(header_bytes_), pack_bytes_);
  if (!seal) return MessageOf(seal.error());
  const auto sum = show::Checksummer(pack_sum_).Finish();
  if (sum != seal->checksum || pack_ != "shows/" + store::PackName(fmt::format("{:02x}", fmt::join(sum, ""))))
    return Message::kDamaged;
  if (!seal->signer) return Message::kUnsigned;
  auto keys = terms_.keys;
  const std::vector<fs::path> brought{Staged("settings/keys")};
  std::vector<std::string> faults;
  const auto more = show::ReadPublicKeys(brought, &faults);
  if (more) keys.insert(keys.end(), more->begin(), more->end());
  return std::ranges::find(keys, *seal->signer) == keys.end() ? std::optional(Message::kForeign)
                                                              : std::nullopt;
}

// The box's own pack goes on where it has the same bytes; one that the disk has spoilt is put anew.
void Restoration::LookForSame() {
  std::vector<std::uint8_t> piece(backup::Reader::kPiece_bytes);
  const auto got = box_pack_->Read(piece);
  if (got) box_sum_.Add(std::span(piece).first(*got));
  if (got && *got == piece.size()) return;
  box_pack_.reset();
  const auto& files = reader_->contents().files;
  const auto entry =
      std::ranges::find(files, pack_, [](const backup::Entry& each) { return each.member.path; });
  stage_ = Stage::kTry;
  if (!got || box_sum_.Finish() != entry->sha256) return;
  ::unlink(Staged(pack_).c_str());
  stage_ = Stage::kCompare;
}

void Restoration::Try() {
  stage_ = Stage::kCompare;
  if (auto ok = terms_.trial(Staged(pack_)); !ok)
    Refuse(ok.error().cause == std::errc::operation_canceled ? Message::kKeyOff : Message::kUnplayable,
           ok.error().message());
}

// A box that has no settings and no name gets none by this.
Result<void> Restoration::KeepName() {
  const std::string path(restore::kSettings);
  const std::string brought = ContentOf(Staged(path)), own = ContentOf(terms_.data / path);
  const std::string text = WithLineOf(brought, own, "name");
  if (terms_.with_name || text == brought || (text.empty() && !IsThere(Staged(path)))) return {};
  if (auto ok = MakeFolders(Staged(path).parent_path()); !ok) return ok;
  return WriteWholeFile(Staged(path), {AsBytes(text)});
}

// What is the same on both sides is not put, so that the way back has only what was changed.
Result<void> Restoration::MakePlan() {
  const fs::path staged = terms_.data / restore::kIncoming / restore::kFiles;
  const auto brought = restore::RestoredPaths(staged), own = restore::RestoredPaths(terms_.data);
  if (!brought || !own) return tl::unexpected((!brought ? brought : own).error());
  for (const std::string& path : *brought) {
    const bool is_there = IsThere(terms_.data / path);
    if (is_there && ContentOf(terms_.data / path) == ContentOf(staged / path)) continue;
    (is_there ? changed_ : fresh_).push_back(path);
    plan_.put.push_back(path);
  }
  for (const std::string& path : *own)
    if (std::ranges::find(*brought, path) == brought->end()) plan_.removed.push_back(path);
  if (!pack_.empty() && IsThere(staged / pack_)) plan_.put.push_back(pack_);
  const std::string& show = reader_->contents().show;
  if (show != store::ReadChoice(terms_.data / "shows").current) plan_.show = show;
  return {};
}

// Only what differs is asked about: a backup of the box as it is needs no restart.
void Restoration::Compare() {
  if (auto ok = KeepName(); !ok) return RefuseDisk(ok.error());
  if (auto ok = MakePlan(); !ok) return RefuseDisk(ok.error());
  if (plan_ == restore::Plan()) return Refuse(Message::kNothingDiffers);
  progress_.message = Message::kAskChange;
  stage_ = Stage::kAsks;
}

// The plan last, when all that it names is there. LetWait brings both onto the disk before the name counts.
Result<void> Restoration::Commit() {
  const fs::path incoming = terms_.data / restore::kIncoming;
  if (auto ok = WriteWholeFile(incoming / restore::kPlan, {AsBytes(Format(plan_))}); !ok) return ok;
  return LetWait(terms_.data, incoming);
}

const Progress& Restoration::Confirm() {
  if (stage_ != Stage::kAsks) return progress_;
  if (auto ok = Commit(); !ok) {
    RefuseDisk(ok.error());
    return progress_;
  }
  progress_ = {Message::kRestoreWaits, {}, 1};
  stage_ = Stage::kEnded;
  return progress_;
}

}  // namespace kaori::shows
