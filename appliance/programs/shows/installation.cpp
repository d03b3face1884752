#include "appliance/programs/shows/installation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"
#include "drivers/base/read_full.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

// Read from front to back, once: what the header said and what is copied come from one open file, so that a
// name that is given to another file meanwhile changes nothing.
class FileSource final : public Source {
 public:
  FileSource(UniqueFd fd, std::uint64_t bytes, std::string name)
      : fd_(std::move(fd)), bytes_(bytes), name_(std::move(name)) {}
  std::uint64_t bytes() const override { return bytes_; }
  Result<std::size_t> Read(std::span<std::uint8_t> into) override {
    ExpectSlowDisk();
    return ReadFull(fd_.get(), into, name_);
  }

 private:
  UniqueFd fd_;
  std::uint64_t bytes_;
  std::string name_;
};

std::string IdOf(const show::Checksum& sum) {
  return fmt::format("{:02x}", fmt::join(sum, ""));
}

std::string InMegabytes(std::uint64_t bytes) {
  constexpr std::uint64_t kMegabyte = 1'000'000;
  return std::to_string((bytes + kMegabyte - 1) / kMegabyte) + " MB";
}

}  // namespace

Result<std::unique_ptr<Source>> OpenSource(const std::filesystem::path& file) {
  auto opened = OpenRegular(file, "open " + file.string(), Links::kRefuse);
  if (opened) return std::make_unique<FileSource>(std::move(opened->fd), opened->bytes, file.string());
  if (IsNoFile(opened.error())) return FailInput(file.string() + " is no file", show::kNoPack);
  return tl::unexpected(opened.error());
}

// A pack's own causes first. What else is wrong with the input is damage; what the system cannot read is a
// stick that is gone.
Message MessageOf(const Error& error) {
  switch (error.cause) {
    case show::kNoPack:
      return Message::kNotAShow;
    case show::kNewerPack:
      return Message::kNewerFormat;
    case show::kOlderPack:
      return Message::kOlderFormat;
    case show::kCutOffPack:
      return Message::kCutOff;
    case std::errc::file_too_large:
      return Message::kTooLarge;
    default:
      return error.kind == ErrorKind::kInput ? Message::kDamaged : Message::kPulled;
  }
}

void RemoveLeftovers(Folder& folder) {
  for (const char* name : {store::kIncomingName, kNewChoice}) static_cast<void>(folder.Remove(name));
}

Installation::Installation(Folder& folder, std::unique_ptr<Source> source, show::PublicKeys keys, Trial trial,
                           OnBox on_box)
    : folder_(folder),
      source_(std::move(source)),
      keys_(std::move(keys)),
      trial_(std::move(trial)),
      before_(ReadChoice(folder)),
      plays_(on_box.plays.empty() ? before_.current : std::move(on_box.plays)),
      told_(on_box.told) {}

// One stage after the other, and none twice: each ends in the next or in kEnded.
const Progress& Installation::Step() {
  switch (stage_) {
    case Stage::kHeader:
      ReadHeader();
      break;
    case Stage::kCopy:
      CopyPiece();
      break;
    case Stage::kTry:
      TryIt();
      break;
    case Stage::kSwitch:
      Switch();
      break;
    case Stage::kEnded:
      break;
  }
  return progress_;
}

// The draft is closed before its file goes. How far the copy came is kept for whoever shows it.
void Installation::Refuse(Message message, std::string detail) {
  draft_.reset();
  static_cast<void>(
      folder_.Remove(store::kIncomingName));  // Where this fails the next installation replaces it.
  progress_ = {message, std::move(detail), progress_.done};
  stage_ = Stage::kEnded;
}

// The box's own disk failed.
void Installation::RefuseFolder(const Error& error) {
  Refuse(DiskMessageOf(error), error.message());
}

// Whoever signed it is asked before anything is copied: what is not trusted is not worth reading. The chosen
// show is copied anew where the disk has spoilt it.
void Installation::ReadHeader() {
  show::PackHeader header{};
  const auto got = source_->Read(header);
  if (!got) return Refuse(Message::kPulled, got.error().message());
  const auto seal = show::ReadHeader(std::span(header).first(*got), source_->bytes());
  if (!seal) return Refuse(MessageOf(seal.error()), seal.error().message());
  if (keys_.empty()) return Refuse(Message::kNoKeys);
  if (!seal->signer) return Refuse(Message::kUnsigned);
  if (std::ranges::find(keys_, *seal->signer) == keys_.end())
    return Refuse(Message::kForeign, "key " + show::Fingerprint(*seal->signer));
  seal_ = *seal;
  id_ = IdOf(seal_.checksum);
  if (plays_ == id_ && !NeedsCopy()) return;
  const auto room = MakeRoom(source_->bytes());
  if (!room) return RefuseFolder(room.error());
  if (!*room) return Refuse(Message::kFull, InMegabytes(source_->bytes() + kReserve_bytes) + " are needed");
  auto draft = folder_.Begin(store::kIncomingName);
  if (!draft) return RefuseFolder(draft.error());
  draft_ = std::move(*draft);
  if (auto ok = draft_->Append(header); !ok) return RefuseFolder(ok.error());
  stage_ = Stage::kCopy;
}

// False: it is on the box and whole, or that was not found out; the next stage is chosen then. Only what was
// found to be spoilt may make room for its own copy: a trial that was cut off says nothing of the show.
bool Installation::NeedsCopy() {
  const auto whole = trial_(folder_.path() / store::PackName(id_));
  if (whole && before_.current == id_) {
    Refuse(Message::kAlreadyThere);
  } else if (whole) {
    is_there_ = true;
    stage_ = Stage::kSwitch;
  } else if (whole.error().cause == std::errc::operation_canceled) {
    Refuse(Message::kKeyOff, whole.error().message());
  } else {
    spoilt_ = whole.error().kind == ErrorKind::kInput || whole.error().cause == std::errc::interrupted;
    return true;
  }
  return false;
}

// A copy of the root's show that is being made gives way at its next piece (copy.cpp): its room comes a little later.
Result<std::uint64_t> Installation::RemoveUnfinishedCopy() {
  const std::uint64_t copying_bytes = folder_.BytesOf(store::kUnfinishedCopyName);
  if (copying_bytes == 0) return 0;
  const auto before = folder_.FreeBytes();
  if (!before) return tl::unexpected(before.error());
  if (auto ok = folder_.Remove(store::kUnfinishedCopyName); !ok) return tl::unexpected(ok.error());
  const auto after = folder_.FreeBytes();
  if (!after) return tl::unexpected(after.error());
  return *before + copying_bytes - std::min(*after, *before + copying_bytes);
}

// The room of what was removed is free at once, except that of an open file, which its writer still has. What comes of it is
// added to each look at the disk; a writer that never closes it would have the copy end for want of room, and say so.
//
// Where all that may go would not be enough, nothing goes.
Result<bool> Installation::MakeRoom(std::uint64_t bytes) {
  if (auto ok = folder_.Remove(store::kIncomingName); !ok) return tl::unexpected(ok.error());
  const auto comes = RemoveUnfinishedCopy();
  if (!comes) return tl::unexpected(comes.error());
  const auto free = [&] { return folder_.FreeBytes().map([&](std::uint64_t now) { return now + *comes; }); };
  const std::uint64_t wanted = bytes + kReserve_bytes;
  const auto at_first = free();
  if (!at_first) return tl::unexpected(at_first.error());
  const auto removable = Removable();
  if (!removable) return tl::unexpected(removable.error());
  std::uint64_t at_most = *at_first;
  for (const std::string& name : *removable) at_most += folder_.BytesOf(name);
  if (at_most < wanted) return false;
  for (const std::string& name : *removable) {
    const auto now = free();
    if (!now) return tl::unexpected(now.error());
    if (*now >= wanted) return true;
    if (auto ok = folder_.Remove(name); !ok) return tl::unexpected(ok.error());
    if (auto ok = folder_.KeepNames(); !ok) return tl::unexpected(ok.error());
  }
  return free().map([&](std::uint64_t now) { return now >= wanted; });
}

// A copy of the root's show is first. The pack of the new show itself is among the next where it is there and does not play, or is spoilt: it is
// copied anew.
Result<std::vector<std::string>> Installation::Removable() const {
  auto names = folder_.Names();
  if (!names) return names;
  const auto is = [&](const std::string& name, const std::string& id) {
    const bool is_copied_anew = id == id_ && (id != plays_ || spoilt_);
    return !is_copied_anew && name == store::PackName(id);
  };
  std::erase_if(*names, [&](const std::string& name) {
    if (name == store::kCopyName) return false;
    return !name.ends_with(".kaori") || is(name, before_.current) || is(name, plays_);
  });
  std::ranges::sort(*names);
  // Not that of std::ranges, which clang-tidy 14 cannot read.
  std::stable_partition(names->begin(), names->end(),
                        [&](const std::string& name) { return !is(name, before_.previous); });
  const auto is_copy = [](const std::string& name) { return name == store::kCopyName; };
  std::stable_partition(names->begin(), names->end(), is_copy);
  return names;
}

// A chosen show that gave way is no show to fall back to.
std::string Installation::ShowBefore() const {
  for (const std::string& id : {plays_, before_.previous})
    if (id != id_) return id;
  return std::string(store::kRootShow);
}

// The length is the header's, so that a file that grows meanwhile is read no further than was agreed.
void Installation::CopyPiece() {
  const std::uint64_t left = seal_.content_bytes - copied_bytes_;
  std::vector<std::uint8_t> piece(static_cast<std::size_t>(std::min<std::uint64_t>(left, kPiece_bytes)));
  const auto got = source_->Read(piece);
  if (!got) return Refuse(Message::kPulled, got.error().message());
  if (*got < piece.size()) return Refuse(Message::kPulled, "it became shorter while it was read");
  sum_.Add(piece);
  if (auto ok = draft_->Append(piece); !ok) return RefuseFolder(ok.error());
  copied_bytes_ += piece.size();
  progress_.done =
      seal_.content_bytes == 0
          ? 1
          : static_cast<float>(static_cast<double>(copied_bytes_) / static_cast<double>(seal_.content_bytes));
  if (copied_bytes_ < seal_.content_bytes) return;
  if (sum_.Finish() != seal_.checksum) return Refuse(Message::kDamaged, "its checksum does not fit");
  if (auto ok = draft_->Finish(); !ok) return RefuseFolder(ok.error());
  draft_.reset();
  source_.reset();
  progress_.message = Message::kTrying;
  stage_ = Stage::kTry;
}

// The trial reads the copy from the disk: what the disk spoilt is found as well.
void Installation::TryIt() {
  if (auto ok = trial_(folder_.path() / store::kIncomingName); !ok)
    return Refuse(ok.error().cause == std::errc::operation_canceled ? Message::kKeyOff : Message::kUnplayable,
                  ok.error().message());
  stage_ = Stage::kSwitch;
}

// Else a folder that has a pack and no choice, since the power went between the two, would look as one whose
// choice was lost.
Result<void> Installation::BeginChoices() {
  const auto names = folder_.Names();
  if (!names) return tl::unexpected(names.error());
  const bool has_packs =
      std::ranges::any_of(*names, [](const std::string& name) { return name.ends_with(".kaori"); });
  if (has_packs || HasChoice(folder_)) return {};
  return WriteChoice(folder_, store::Choice());
}

// The pack has its name on the disk before the choice names it.
void Installation::Switch() {
  if (!is_there_) {
    if (auto ok = BeginChoices(); !ok) return RefuseFolder(ok.error());
    if (auto ok = folder_.Rename(store::kIncomingName, store::PackName(id_)); !ok)
      return RefuseFolder(ok.error());
    if (auto ok = folder_.KeepNames(); !ok) return RefuseFolder(ok.error());
  }
  if (auto ok = WriteChoice(folder_, {store::NextGeneration(before_, told_), id_, ShowBefore()}); !ok)
    return RefuseFolder(ok.error());
  progress_.message = Message::kInstalled;
  stage_ = Stage::kEnded;
}

}  // namespace kaori::shows
