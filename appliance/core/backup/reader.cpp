#include "appliance/core/backup/reader.h"

#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"
#include "drivers/base/read_full.h"

namespace kaori::backup {
namespace {

class FileInput final : public Input {
 public:
  FileInput(UniqueFd fd, std::string name) : fd_(std::move(fd)), name_(std::move(name)) {}
  Result<std::size_t> Read(std::span<std::uint8_t> into) override {
    ExpectSlowDisk();
    return ReadFull(fd_.get(), into, name_);
  }

 private:
  UniqueFd fd_;
  std::string name_;
};

Result<std::unique_ptr<Input>> InputOfOpened(Result<RegularFile> opened, const std::string& name) {
  if (opened) return std::make_unique<FileInput>(std::move(opened->fd), name);
  if (IsNoFile(opened.error())) return FailInput("is no file", kNoBackup);
  return tl::unexpected(opened.error());
}

}  // namespace

Result<std::unique_ptr<Input>> OpenInput(const std::filesystem::path& file) {
  return InputOfOpened(OpenRegular(file, "open " + file.string(), Links::kRefuse), file.string());
}

Result<std::unique_ptr<Input>> InputOf(UniqueFd file, const std::string& name) {
  auto opened = RequireRegular(std::move(file), "look at " + name);
  if (opened && ::lseek(opened->fd.get(), 0, SEEK_SET) < 0) return FailErrno("read " + name);
  return InputOfOpened(std::move(opened), name);
}

Result<Reader> Reader::Begin(std::unique_ptr<Input> input) {
  Reader reader(std::move(input));
  if (auto ok = reader.ReadContents(); !ok) return tl::unexpected(ok.error());
  return reader;
}

Result<void> Reader::ReadAll(std::span<std::uint8_t> into) {
  const auto got = input_->Read(into);
  if (!got) return tl::unexpected(got.error());
  if (*got < into.size()) return FailInput("ends too early", kCutOffBackup);
  return {};
}

Result<Member> Reader::ReadHeader() {
  Block block{};
  if (auto ok = ReadAll(block); !ok) return tl::unexpected(ok.error());
  auto member = ReadBlock(block);
  if (!member) return tl::unexpected(member.error());
  if (!*member) return FailInput("ends too early", kCutOffBackup);
  return std::move(**member);
}

// Of a file that begins otherwise it is said that it is no backup, whatever its end.
Result<void> Reader::ReadContents() {
  const auto first = ReadHeader();
  const bool is_list = first && first->path == kContents;
  if (!first && first.error().kind != ErrorKind::kInput) return tl::unexpected(first.error());
  if (!is_list) return FailInput("is no backup of a box", kNoBackup);
  if (first->bytes > kMostContents_bytes) return FailInput("has too long a list", std::errc::file_too_large);
  std::string text(static_cast<std::size_t>(first->bytes) + Padding(first->bytes), '\0');
  if (auto ok = ReadAll({reinterpret_cast<std::uint8_t*>(text.data()), text.size()}); !ok) return ok;
  auto contents = ParseContents(std::string_view(text).substr(0, static_cast<std::size_t>(first->bytes)));
  if (!contents) return tl::unexpected(contents.error());
  contents_ = std::move(*contents);
  return {};
}

// An archive says again what the list said.
Result<void> Reader::BeginFile(Sink& sink) {
  const Entry& entry = contents_.files[file_];
  const auto member = ReadHeader();
  if (!member) return tl::unexpected(member.error());
  if (*member != entry.member) return FailInput("does not hold what its list says: " + entry.member.path);
  begun_ = true;
  left_bytes_ = entry.member.bytes;
  sum_ = Sha256();
  return sink.Begin(entry);
}

// The zeros up to the next block are read and not judged: tar(1) does not either.
Result<void> Reader::EndFile(Sink& sink) {
  const Entry& entry = contents_.files[file_];
  std::vector<std::uint8_t> padding(Padding(entry.member.bytes));
  if (auto ok = ReadAll(padding); !ok) return ok;
  if (sum_.Finish() != entry.sha256) return FailInput("has a damaged file: " + entry.member.path);
  begun_ = false;
  ++file_;
  return sink.End(entry);
}

// Two blocks of zeros or more, up to a whole record of tar(1), and nothing behind them.
Result<void> Reader::ReadEnd() {
  constexpr std::size_t kRecord_bytes = 20 * kBlock_bytes;
  std::array<std::uint8_t, kRecord_bytes + 1> end{};
  const auto got = input_->Read(end);
  if (!got) return tl::unexpected(got.error());
  if (*got < 2 * kBlock_bytes) return FailInput("ends too early", kCutOffBackup);
  if (*got > kRecord_bytes || std::ranges::any_of(end, [](std::uint8_t byte) { return byte != 0; }))
    return FailInput("goes on behind its end", kCutOffBackup);
  return {};
}

// A file of no bytes is begun and ended by one step, as any other that fits into a piece.
Result<bool> Reader::Step(Sink& sink) {
  if (file_ == contents_.files.size()) {
    if (auto ok = ReadEnd(); !ok) return tl::unexpected(ok.error());
    return true;
  }
  if (!begun_)
    if (auto ok = BeginFile(sink); !ok) return tl::unexpected(ok.error());
  std::vector<std::uint8_t> piece(
      static_cast<std::size_t>(std::min<std::uint64_t>(left_bytes_, kPiece_bytes)));
  if (auto ok = ReadAll(piece); !ok) return tl::unexpected(ok.error());
  sum_.Add(piece);
  if (auto ok = sink.Append(piece); !ok) return tl::unexpected(ok.error());
  left_bytes_ -= piece.size();
  if (left_bytes_ > 0) return false;
  if (auto ok = EndFile(sink); !ok) return tl::unexpected(ok.error());
  return false;
}

}  // namespace kaori::backup
