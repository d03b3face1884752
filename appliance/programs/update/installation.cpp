#include "appliance/programs/update/installation.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"

namespace kaori::update {
namespace {

constexpr std::size_t kPacked_bytes = std::size_t{256}
                                      << 10U;  // Read from a stick at once while it is written.

class FileSource final : public Source {
 public:
  FileSource(UniqueFd fd, std::uint64_t bytes) : fd_(std::move(fd)), bytes_(bytes) {}
  std::uint64_t bytes() const override { return bytes_; }
  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override {
    ExpectSlowDisk();
    while (!into.empty()) {
      const ssize_t got = ::pread(fd_.get(), into.data(), into.size(), static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return FailErrno("read the update");
      if (got == 0) return Fail(std::errc::io_error, "read the update to its end");
      into = into.subspan(static_cast<std::size_t>(got));
      at += static_cast<std::uint64_t>(got);
    }
    return {};
  }

 private:
  UniqueFd fd_;
  std::uint64_t bytes_;
};

}  // namespace

Result<std::unique_ptr<Source>> SourceOf(UniqueFd file) {
  auto opened = RequireRegular(std::move(file), "look at the update");
  if (opened) return std::make_unique<FileSource>(std::move(opened->fd), opened->bytes);
  if (IsNoFile(opened.error())) return FailInput("the update is no file", std::errc::executable_format_error);
  return tl::unexpected(opened.error());
}

// Whether it is trusted comes first: of a foreign file nothing else is worth saying. The same version again is
// taken, so that a slot that was spoilt can be written anew.
Message Judge(const Manifest& manifest, const Running& running, const show::PublicKeys& keys) {
  if (std::ranges::find(keys, manifest.signer) == keys.end()) return Message::kForeign;
  if (manifest.product != running.product) return Message::kOtherProduct;
  if (manifest.version < running.least) return Message::kBelowLeast;
  if (manifest.version < running.version) return Message::kOlder;
  if (running.version < manifest.from) return Message::kNewerForm;
  return Message::kFits;
}

Result<Manifest> ReadManifest(Source& source) {
  Header header{};
  const auto head = std::span(header).first(std::min<std::uint64_t>(source.bytes(), header.size()));
  if (auto ok = source.Read(0, head); !ok) return tl::unexpected(ok.error());
  return ReadHeader(head, source.bytes());
}

Message MessageOf(const Error& error) {
  switch (error.cause) {
    case std::errc::executable_format_error:
      return Message::kNotAnUpdate;
    case std::errc::function_not_supported:
      return Message::kNewerForm;
    case std::errc::message_size:
      return Message::kCutOff;
    default:
      return error.kind == ErrorKind::kInput ? Message::kDamaged : Message::kPulled;
  }
}

// The kernel comes last: a slot whose kernel is the old one never starts with the new root.
Installation::Installation(std::unique_ptr<Source> source, show::PublicKeys keys, Running running,
                           OtherSlot slot, Notes& notes)
    : source_(std::move(source)),
      keys_(std::move(keys)),
      running_(std::move(running)),
      areas_{Area{Part::kRoot, &slot.root, 0, slot.root.bytes()},
             Area{Part::kVerity, &slot.verity, 0, slot.verity.bytes()},
             Area{running_.slot == ports::Slot::kA ? Part::kKernelB : Part::kKernelA, &slot.boot,
                  slot.kernel_at, slot.kernel_bytes}},
      notes_(notes) {}

const Progress& Installation::Step() {
  switch (stage_) {
    case Stage::kHeader:
      AcceptHeader();
      break;
    case Stage::kRead:
      ReadPiece();
      break;
    case Stage::kBegin:
      Begin();
      break;
    case Stage::kUnpack:
      UnpackKernelPiece();
      break;
    case Stage::kWrite:
      WritePiece();
      break;
    case Stage::kReadBack:
      ReadPieceBack();
      break;
    case Stage::kNote:
      Note();
      break;
    case Stage::kEnded:
      break;
  }
  return progress_;
}

void Installation::Refuse(Message message, std::string detail) {
  progress_ = {message, progress_.version, std::move(detail), progress_.done};
  stage_ = Stage::kEnded;
}

void Installation::RefuseDisk(const Error& error) {
  Refuse(Message::kDiskFault, error.message());
}

void Installation::RefuseNote(const Error& error) {
  if (error.cause == std::errc::no_space_on_device) return Refuse(Message::kDataFull);
  RefuseDisk(error);
}

void Installation::CountDone(std::uint64_t bytes) {
  done_bytes_ += bytes;
  progress_.done = static_cast<float>(static_cast<double>(done_bytes_) / static_cast<double>(all_bytes_));
}

// Nothing is read of what would be refused. A kernel fills its file, which has one size on every box.
void Installation::AcceptHeader() {
  const auto manifest = ReadManifest(*source_);
  if (!manifest) return Refuse(MessageOf(manifest.error()), manifest.error().message());
  manifest_ = *manifest;
  progress_.version = manifest_.version;
  const Message judged = Judge(manifest_, running_, keys_);
  if (judged == Message::kForeign) return Refuse(judged, "key " + show::Fingerprint(manifest_.signer));
  if (judged != Message::kFits)
    return Refuse(judged, "this box runs version " + std::to_string(running_.version));
  all_bytes_ = manifest_.payload_bytes;
  for (const Area& each : areas_) {
    const PackedPart& its = manifest_.part(each.part);
    const bool is_kernel = each.device == areas_.back().device;
    if (its.bytes > each.room_bytes || (is_kernel && its.bytes != each.room_bytes))
      return Refuse(Message::kTooLarge);
    all_bytes_ += 2 * its.bytes;
  }
  stage_ = Stage::kRead;
}

// A signature covers the payload by its checksum alone: all of it is read before a byte is written.
void Installation::ReadPiece() {
  const std::uint64_t left = manifest_.payload_bytes - read_bytes_;
  std::vector<std::uint8_t> piece(static_cast<std::size_t>(std::min<std::uint64_t>(left, kPiece_bytes)));
  if (auto ok = source_->Read(kHeader_bytes + read_bytes_, piece); !ok)
    return Refuse(Message::kPulled, ok.error().message());
  sum_.Add(piece);
  read_bytes_ += piece.size();
  CountDone(piece.size());
  if (read_bytes_ < manifest_.payload_bytes) return;
  if (sum_.Finish() != manifest_.payload) return Refuse(Message::kDamaged, "its checksum does not fit");
  stage_ = Stage::kBegin;
}

// What waited in that slot, or ran there before, is lost with the first write, and must not be tried. Room for the note at the end
// is taken first: half an hour of writing is not to end in a full partition.
void Installation::Begin() {
  if (auto ok = notes_.ForgetPending(); !ok) return RefuseNote(ok.error());
  if (auto ok = notes_.Reserve(); !ok) return RefuseNote(ok.error());
  if (auto ok = notes_.BeginOverwriting(); !ok) return RefuseNote(ok.error());
  progress_.message = Message::kWriting;
  BeginPart();
}

void Installation::BeginPart() {
  read_bytes_ = written_bytes_ = 0;
  sum_ = show::Checksummer();
  unpacker_ = Unpacker();
  packed_ = {};
  kernel_.clear();
  stage_ = IsKernel() ? Stage::kUnpack : Stage::kWrite;
}

bool Installation::RefillPacked() {
  buffer_.resize(
      static_cast<std::size_t>(std::min<std::uint64_t>(part().packed_bytes - read_bytes_, kPacked_bytes)));
  if (auto ok = source_->Read(kHeader_bytes + manifest_.PackedAt(area().part) + read_bytes_, buffer_); !ok) {
    Refuse(Message::kPulled, ok.error().message());
    return false;
  }
  read_bytes_ += buffer_.size();
  packed_ = buffer_;
  return true;
}

// The stick may give another thing than at the first reading. It is found at the latest by the part's checksum, and
// then no kernel says that the slot is whole, and nothing that an update waits there.
bool Installation::UnpackPiece(std::span<std::uint8_t> piece) {
  std::size_t filled = 0;
  while (filled < piece.size() && !unpacker_.ended()) {
    if (packed_.empty() && read_bytes_ == part().packed_bytes) break;
    if (packed_.empty() && !RefillPacked()) return false;
    const auto got = unpacker_.Unpack(packed_, piece.subspan(filled));
    if (!got) {
      Refuse(Message::kPulled, got.error().message());
      return false;
    }
    filled += *got;
  }
  if (filled < piece.size()) Refuse(Message::kPulled, "it became shorter while it was read");
  return filled == piece.size();
}

void Installation::UnpackKernelPiece() {
  const std::size_t there = kernel_.size();
  kernel_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(part().bytes, there + kPiece_bytes)));
  const auto piece = std::span(kernel_).subspan(there);
  if (!UnpackPiece(piece)) return;
  sum_.Add(piece);
  if (kernel_.size() < part().bytes) return;
  if (sum_.Finish() != part().checksum) return Refuse(Message::kPulled, "it is another one than before");
  sum_ = show::Checksummer();
  stage_ = Stage::kWrite;
}

// The sum of the kernel fits already; that of the others is known at their end, and until a kernel with their root's hash
// is there nothing starts them.
void Installation::WritePiece() {
  const auto bytes =
      static_cast<std::size_t>(std::min<std::uint64_t>(part().bytes - written_bytes_, kPiece_bytes));
  std::vector<std::uint8_t> unpacked(IsKernel() ? 0 : bytes);
  if (!UnpackPiece(unpacked)) return;
  const std::span<const std::uint8_t> piece =
      IsKernel() ? std::span(kernel_).subspan(static_cast<std::size_t>(written_bytes_), bytes)
                 : std::span(unpacked);
  if (auto ok = area().device->Write(area().at + written_bytes_, piece); !ok) return RefuseDisk(ok.error());
  sum_.Add(piece);
  written_bytes_ += piece.size();
  CountDone(piece.size());
  if (written_bytes_ < part().bytes) return;
  if (sum_.Finish() != part().checksum) return Refuse(Message::kPulled, "it is another one than before");
  if (auto ok = area().device->Flush(); !ok) return RefuseDisk(ok.error());
  sum_ = show::Checksummer();
  written_bytes_ = 0;
  stage_ = Stage::kReadBack;
}

void Installation::ReadPieceBack() {
  std::vector<std::uint8_t> piece(
      static_cast<std::size_t>(std::min<std::uint64_t>(part().bytes - written_bytes_, kPiece_bytes)));
  if (auto ok = area().device->Read(area().at + written_bytes_, piece); !ok) return RefuseDisk(ok.error());
  sum_.Add(piece);
  written_bytes_ += piece.size();
  CountDone(piece.size());
  if (written_bytes_ < part().bytes) return;
  if (sum_.Finish() != part().checksum)
    return Refuse(Message::kDiskFault, "what was written is not what is read back");
  if (++area_ < areas_.size()) return BeginPart();
  stage_ = Stage::kNote;
}

// Also where nobody asks for a try and a person starts the other slot by hand, the version that it replaces is known.
void Installation::Note() {
  if (auto ok = notes_.KeepBefore({running_.version, running_.slot, 0}); !ok) return RefuseNote(ok.error());
  if (auto ok = notes_.KeepPending({manifest_.version, ports::Other(running_.slot), 0}); !ok)
    return RefuseNote(ok.error());
  static_cast<void>(notes_.EndOverwriting());  // Where it stays it is of no version that is newer.
  progress_.message = Message::kWaits;
  stage_ = Stage::kEnded;
}

}  // namespace kaori::update
