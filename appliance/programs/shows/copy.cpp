#include "appliance/programs/shows/copy.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "drivers/base/log.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

// A show that comes from a stick needs the room more. Errors: operation_canceled.
Result<void> WantAlone(const Folder& folder) {
  if (folder.BytesOf(store::kIncomingName) == 0) return {};
  return Fail(std::errc::operation_canceled, "copy the box's own show while another one comes");
}

// Before each piece, and ten times a second while the copy rests: at the lowest priority one piece may take seconds.
Result<void> AwaitTurn(const Folder& folder, const std::function<bool()>& may_work) {
  constexpr auto kAsk = std::chrono::milliseconds(100);
  while (true) {
    if (auto ok = WantAlone(folder); !ok || !may_work || may_work()) return ok;
    std::this_thread::sleep_for(kAsk);
  }
}

// Content by content, so that what goes to the disk is what the header's checksum was made of.
Result<void> CopyContent(const Folder& folder, Source& root, const show::PackSeal& seal, Draft& draft,
                         const std::function<bool()>& may_work) {
  show::Checksummer sum;
  // One piece at a time is in memory, since a show may be larger than what is free.
  std::vector<std::uint8_t> piece(Installation::kPiece_bytes);
  for (std::uint64_t left = seal.content_bytes; left > 0;) {
    if (auto ok = AwaitTurn(folder, may_work); !ok) return ok;
    const auto wanted =
        std::span(piece).first(static_cast<std::size_t>(std::min<std::uint64_t>(left, piece.size())));
    const auto got = root.Read(wanted);
    if (!got) return tl::unexpected(got.error());
    if (*got < wanted.size()) return FailInput("the box's own show became shorter while it was read");
    sum.Add(wanted);
    if (auto ok = draft.Append(wanted); !ok) return ok;
    left -= wanted.size();
  }
  // The draft is not finished then, and the caller removes it.
  if (sum.Finish() != seal.checksum)
    return FailInput("the box's own show is damaged: its checksum does not fit");
  return draft.Finish();
}

// An old copy goes first where both have no room.
Result<bool> HasRoom(Folder& folder, std::uint64_t bytes) {
  const auto free = folder.FreeBytes();
  if (!free) return tl::unexpected(free.error());
  const std::uint64_t wanted = bytes + Installation::kReserve_bytes,
                      old_bytes = folder.BytesOf(store::kCopyName);
  if (*free >= wanted) return true;
  if (old_bytes == 0 || *free + old_bytes < wanted) return false;
  if (auto ok = folder.Remove(store::kCopyName); !ok) return tl::unexpected(ok.error());
  if (auto ok = folder.KeepNames(); !ok) return tl::unexpected(ok.error());
  return folder.FreeBytes().map([&](std::uint64_t now) { return now >= wanted; });
}

// The content is on the disk before it has the copy's name.
Result<void> WriteCopy(Folder& folder, Source& root, const show::PackHeader& header,
                       const show::PackSeal& seal, const std::function<bool()>& may_work) {
  auto draft = folder.Begin(store::kUnfinishedCopyName);
  if (!draft) return tl::unexpected(draft.error());
  if (auto ok = (*draft)->Append(header); !ok) return ok;
  if (auto ok = CopyContent(folder, root, seal, **draft, may_work); !ok) return ok;
  draft->reset();
  if (auto ok = WantAlone(folder); !ok) return ok;
  if (auto ok = folder.Rename(store::kUnfinishedCopyName, store::kCopyName); !ok) return ok;
  return folder.KeepNames();
}

}  // namespace

// A copy that was cut off takes the room of the next one.
Result<Copied> KeepCopy(Folder& folder, Source& root, std::span<const std::uint8_t> there,
                        const std::function<bool()>& may_work) {
  show::PackHeader header{};
  const auto got = root.Read(header);
  if (!got) return tl::unexpected(got.error());
  const auto seal = show::ReadHeader(std::span(header).first(*got), root.bytes());
  if (!seal) return tl::unexpected(seal.error());
  if (std::ranges::equal(header, there) && folder.BytesOf(store::kCopyName) == root.bytes())
    return Copied::kIsThere;
  if (auto ok = folder.Remove(store::kUnfinishedCopyName); !ok) return tl::unexpected(ok.error());
  const auto has_room = HasRoom(folder, root.bytes());
  if (!has_room) return tl::unexpected(has_room.error());
  if (!*has_room) return Copied::kNoRoom;
  const auto written = WriteCopy(folder, root, header, *seal, may_work);
  if (written) return Copied::kMade;
  static_cast<void>(folder.Remove(store::kUnfinishedCopyName));
  if (written.error().cause == std::errc::operation_canceled) return Copied::kGaveWay;
  return tl::unexpected(written.error());
}

Result<void> KeepCopyOf(const std::filesystem::path& root_pack, const std::filesystem::path& shows,
                        const std::function<bool()>& may_work) {
  const auto folder = OpenFolder(shows);
  auto root = OpenSource(root_pack);
  if (!root) return tl::unexpected(root.error());
  const auto there = ReadBeginning(shows / store::kCopyName, show::kPackHeader_bytes);
  const auto kept = KeepCopy(*folder, **root, AsBytes(there.value_or("")), may_work);
  // What a header is found to be is said of the file: the attempt of such an error is the end of a sentence.
  if (!kept && kept.error().kind == ErrorKind::kInput)
    return FailAs(kept.error(), root_pack.string() + " " + kept.error().attempt);
  if (!kept) return tl::unexpected(kept.error());
  if (*kept == Copied::kMade) Log("a copy of the box's own show is kept");
  if (*kept == Copied::kGaveWay)
    Log("a show comes from a stick: the box's own show is copied after the next start");
  if (*kept == Copied::kNoRoom)
    LogWarning("there is no room for a copy of the box's own show, which would play if its disk were spoilt");
  return {};
}

}  // namespace kaori::shows
