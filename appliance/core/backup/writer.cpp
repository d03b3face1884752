#include "appliance/core/backup/writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "appliance/core/restore/kept.h"
#include "appliance/core/store/choice.h"
#include "drivers/base/folder.h"
#include "drivers/base/long_call.h"
#include "drivers/base/whole_file.h"

namespace kaori::backup {
namespace {

namespace fs = std::filesystem;

// Reads and compares alone.
class Nowhere final : public Sink {
 public:
  Result<void> Begin(const Entry&) override { return {}; }
  Result<void> Append(std::span<const std::uint8_t>) override { return {}; }
  Result<void> End(const Entry&) override { return {}; }
};

auto Changed(const std::string& path) {
  return Fail(std::errc::text_file_busy, "copy " + path);
}

}  // namespace

Result<Writer> Writer::Begin(const fs::path& data, const Head& head, const fs::path& file) {
  Writer writer(data, file);
  writer.contents_ = {
      .box = head.box, .made = head.made, .show = store::ReadChoice(data / "shows").current, .files = {}};
  if (auto ok = writer.AddFiles(); !ok) return tl::unexpected(ok.error());
  writer.out_ = UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (!writer.out_.valid()) return FailErrno("write " + file.string());
  return writer;
}

Writer::~Writer() {
  if (out_.valid() && stage_ != Stage::kEnded) ::unlink(name_.c_str());
}

// A chosen show whose pack is gone does not play: the root's does, and that needs no pack.
Result<void> Writer::AddFiles() {
  auto paths = restore::RestoredPaths(data_);
  if (!paths) return tl::unexpected(paths.error());
  const std::string pack = "shows/" + store::PackName(contents_.show);
  if (contents_.show != store::kRootShow && IsThere(data_ / pack))
    paths->push_back(pack);
  else
    contents_.show = store::kRootShow;
  auto reports = restore::ReportPaths(data_);
  if (!reports) return tl::unexpected(reports.error());
  paths->insert(paths->end(), reports->begin(), reports->end());
  if (paths->size() > kMostFiles) return Fail(std::errc::file_too_large, "list what the box keeps");
  for (std::string& path : *paths) contents_.files.push_back({{std::move(path), 0}, {}});
  return {};
}

Result<void> Writer::OpenNext() {
  if (source_) return {};
  auto source = OpenInput(data_ / contents_.files[at_].member.path);
  const std::string& path = contents_.files[at_].member.path;
  if (!source && source.error().cause == std::errc::no_such_file_or_directory) return Changed(path);
  if (!source) return tl::unexpected(source.error());
  source_ = std::move(*source);
  read_bytes_ = 0;
  sum_ = Sha256();
  return {};
}

// Into piece_; shorter than a piece only at the file's end, or where no more than `most_bytes` are wanted.
Result<std::size_t> Writer::ReadPiece(std::uint64_t most_bytes) {
  if (auto ok = OpenNext(); !ok) return tl::unexpected(ok.error());
  piece_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(Reader::kPiece_bytes, most_bytes)));
  auto got = source_->Read(piece_);
  if (!got) return got;
  piece_.resize(*got);
  sum_.Add(piece_);
  read_bytes_ += *got;
  return got;
}

Result<void> Writer::SumPiece() {
  if (at_ == contents_.files.size()) {
    stage_ = Stage::kList;
    return {};
  }
  const auto got = ReadPiece(Reader::kPiece_bytes);
  if (!got) return tl::unexpected(got.error());
  if (*got == Reader::kPiece_bytes) return {};
  Entry& entry = contents_.files[at_++];
  entry.member.bytes = read_bytes_;
  entry.sha256 = sum_.Finish();
  source_.reset();
  return {};
}

Result<void> Writer::Write(std::span<const std::uint8_t> bytes) {
  ExpectSlowDisk();
  return WriteAll(out_.get(), bytes, name_.string());
}

// What the reader would refuse is not written: the list is read as it will be.
Result<void> Writer::WriteList() {
  const std::string text = Format(contents_);
  if (const auto sound = ParseContents(text); !sound) return tl::unexpected(sound.error());
  if (text.size() > kMostContents_bytes) return Fail(std::errc::file_too_large, "list what the box keeps");
  const Block header = MakeBlock({std::string(kContents), text.size()});
  if (auto ok = Write(header); !ok) return ok;
  if (auto ok = Write(AsBytes(text)); !ok) return ok;
  at_ = 0;
  stage_ = Stage::kCopy;
  return Write(std::vector<std::uint8_t>(Padding(text.size())));
}

// What a report has grown by since it was summed is left out; any other file that differs ends the backup.
Result<void> Writer::CopyPiece() {
  if (at_ == contents_.files.size()) return Finish();
  const Entry& entry = contents_.files[at_];
  if (!source_)
    if (auto ok = Write(MakeBlock(entry.member)); !ok) return ok;
  if (auto ok = OpenNext(); !ok) return ok;
  const bool grows = restore::IsReport(entry.member.path);
  const auto got = ReadPiece(grows ? entry.member.bytes - read_bytes_ : Reader::kPiece_bytes);
  if (!got) return tl::unexpected(got.error());
  if (read_bytes_ > entry.member.bytes) return Changed(entry.member.path);
  if (auto ok = Write(piece_); !ok) return ok;
  if (*got == Reader::kPiece_bytes) return {};
  if (read_bytes_ != entry.member.bytes || sum_.Finish() != entry.sha256) return Changed(entry.member.path);
  source_.reset();
  ++at_;
  return Write(std::vector<std::uint8_t>(Padding(entry.member.bytes)));
}

// The kernel forgets the pages, so that what is read back comes from the stick.
Result<void> Writer::Finish() {
  if (auto ok = Write(std::vector<std::uint8_t>(2 * kBlock_bytes)); !ok) return ok;
  ExpectSlowDisk();
  if (::fsync(out_.get()) < 0 || ::syncfs(out_.get()) < 0) return FailErrno("write " + name_.string());
  ::posix_fadvise(out_.get(), 0, 0, POSIX_FADV_DONTNEED);
  auto input = OpenInput(name_);
  if (!input) return tl::unexpected(input.error());
  auto back = Reader::Begin(std::move(*input));
  if (!back) return FailAs({std::errc::bad_message, {}}, "read back " + name_.string());
  back_.emplace(std::move(*back));
  stage_ = Stage::kBack;
  return {};
}

// A stick that gives back other bytes than it got is as good as one that cannot be written.
Result<bool> Writer::Step() {
  Result<void> done;
  Nowhere nowhere;
  if (stage_ == Stage::kSum)
    done = SumPiece();
  else if (stage_ == Stage::kList)
    done = WriteList();
  else if (stage_ == Stage::kCopy)
    done = CopyPiece();
  else if (stage_ == Stage::kBack) {
    const auto read = back_->Step(nowhere);
    if (!read && read.error().kind == ErrorKind::kInput)
      return FailAs({std::errc::bad_message, {}}, "read back " + name_.string());
    if (!read) return tl::unexpected(read.error());
    if (*read) stage_ = Stage::kEnded;
  }
  if (!done) return tl::unexpected(done.error());
  return stage_ == Stage::kEnded;
}

}  // namespace kaori::backup
