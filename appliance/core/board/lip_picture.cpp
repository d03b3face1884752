#include "appliance/core/board/lip_picture.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace kaori::board {
namespace {

constexpr std::array<char, 4> kPictureMagic{'K', 'L', 'P', '1'};
constexpr Duration kLipPicturePeriod = std::chrono::milliseconds(100);
constexpr std::size_t kHeadBytes = 24, kEndBytes = 4, kPixelBytes = 4;
constexpr std::size_t kMostBytes =
    kHeadBytes + kEndBytes + kPixelBytes * std::size_t{kLipPictureMost_px} * kLipPictureMost_px;
// The stage and kaori-lips are two users of one group; the umask takes away what others might do.
constexpr mode_t kLipPictureMode = 0660;

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

template <class Number>
void Put(std::vector<std::uint8_t>& bytes, Number number) {
  const auto* at = reinterpret_cast<const std::uint8_t*>(&number);
  bytes.insert(bytes.end(), at, at + sizeof(number));
}

template <class Number>
Number Get(std::span<const std::uint8_t> bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof(number));
  return number;
}

}  // namespace

std::vector<std::uint8_t> LipPictureBytes(const LipPicture& picture, std::uint32_t number) {
  std::vector<std::uint8_t> bytes(kPictureMagic.begin(), kPictureMagic.end());
  bytes.reserve(kHeadBytes + picture.pixels.size() + kEndBytes);
  Put(bytes, number);
  Put(bytes, static_cast<std::uint32_t>(picture.width_px));
  Put(bytes, static_cast<std::uint32_t>(picture.height_px));
  Put(bytes, std::int64_t{picture.at.time_since_epoch().count()});
  bytes.insert(bytes.end(), picture.pixels.begin(), picture.pixels.end());
  Put(bytes, number);
  return bytes;
}

// What lies behind the end is of a larger picture before.
std::optional<LipPicture> ParseLipPicture(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeadBytes + kEndBytes ||
      !std::equal(kPictureMagic.begin(), kPictureMagic.end(), bytes.begin()))
    return std::nullopt;
  const auto width_px = Get<std::uint32_t>(bytes, 8), height_px = Get<std::uint32_t>(bytes, 12);
  if (std::min(width_px, height_px) < 1 || std::max(width_px, height_px) > kLipPictureMost_px)
    return std::nullopt;
  const std::size_t size = std::size_t{width_px} * height_px * kPixelBytes;
  if (bytes.size() < kHeadBytes + size + kEndBytes) return std::nullopt;
  if (Get<std::uint32_t>(bytes, 4) != Get<std::uint32_t>(bytes, kHeadBytes + size)) return std::nullopt;
  const auto pixels = bytes.subspan(kHeadBytes, size);
  return LipPicture{.width_px = static_cast<int>(width_px),
                    .height_px = static_cast<int>(height_px),
                    .at = Time{Duration{std::max<std::int64_t>(0, Get<std::int64_t>(bytes, 16))}},
                    .pixels = {pixels.begin(), pixels.end()}};
}

// Never a link: the folder is the box's own, and a file of another kind there is a mistake.
Result<LipPictureReader> LipPictureReader::Make(const std::string& path) {
  UniqueFd file(::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC,
                       kLipPictureMode));
  if (!file.valid()) return FailErrno("make " + path);
  return LipPictureReader(std::move(file), path);
}

// One that was moved from has no file, and leaves it to the one that has.
LipPictureReader::~LipPictureReader() {
  if (file_.valid()) ::unlink(path_.c_str());
}

std::optional<LipPicture> LipPictureReader::Read() {
  bytes_.resize(kMostBytes);
  const auto read = ::pread(file_.get(), bytes_.data(), bytes_.size(), 0);
  if (read <= 0) return std::nullopt;
  return ParseLipPicture(std::span(bytes_).first(static_cast<std::size_t>(read)));
}

// The file is opened for each picture: one that was removed and made anew is another one.
bool LipPictureWriter::IsDue(Time now) {
  if (now < due_at_) return false;
  due_at_ = now + kLipPicturePeriod;
  file_ = UniqueFd(::open(path_.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  return file_.valid();
}

void LipPictureWriter::Write(const LipPicture& picture) {
  const auto bytes = LipPictureBytes(picture, ++number_);
  [[maybe_unused]] const auto written = ::pwrite(file_.get(), bytes.data(), bytes.size(), 0);
}

}  // namespace kaori::board
