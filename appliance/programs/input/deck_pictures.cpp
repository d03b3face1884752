#include "appliance/programs/input/deck_pictures.h"

#include <utility>

#include <fmt/format.h>

#include "drivers/base/log.h"
#include "drivers/base/read_file.h"

namespace kaori::input {
namespace {

// Of one key's picture; a bitmap of 80 x 80 points has 19 KB. ReadFile refuses a larger file.
constexpr std::size_t kMostPictureBytes = 64UL * 1024;
// A page takes a deck some milliseconds. One that needs so long for it is slow, or does not answer.
constexpr Duration kSlowPage = std::chrono::seconds(1);
// A deck that refuses a page is tried again after such a pause.
constexpr Duration kPictureRetry = std::chrono::seconds(5);

}  // namespace

void DeckPictures::Plug(const decode::StreamDeck& deck, std::filesystem::path folder,
                        std::filesystem::path of_show) {
  *this = {};
  folder_ = std::move(folder);
  of_show_ = std::move(of_show);
  if (!folder_.empty()) deck_ = deck;
}

// What the kernel says of a page that failed, it may say of the page after it: all pages of the key are sent anew.
void DeckPictures::Show(const Keys& keys, Time now, ports::HidChannel& device, std::string_view name) {
  if (!has_keys() || now < not_before_ || failures_.are_too_many()) return;
  if (next_page_ == pages_.size() && !Begin(keys)) return;
  const auto sent = device.Write(pages_[next_page_]);
  if (!sent && sent.error().cause != std::errc::resource_unavailable_try_again)
    return HandleFailure(sent.error(), now, name);
  if (!sent) {
    if (!waits_since_) waits_since_ = now;
    if (now - *waits_since_ < kSlowPage || std::exchange(told_slow_, true)) return;
    return LogWarning("{}: the deck at {} takes its pictures slowly; its keys show late what is on", name,
                      device.identity().port);
  }
  waits_since_.reset();
  if (++next_page_ == pages_.size()) shown_[key_] = coming_;
}

// The key after the one before has its turn first, so that one that blinks does not keep the others waiting.
bool DeckPictures::Begin(const Keys& keys) {
  const auto count = static_cast<std::size_t>(deck_.keys);
  for (std::size_t n = 1; n <= count; ++n) {
    const std::size_t key = (key_ + n) % count;
    if (shown_[key] == keys[key]) continue;
    pages_.clear();
    next_page_ = 0;
    const auto picture = Load(key, keys[key]);
    shown_[key] = picture.empty() ? std::optional(keys[key]) : std::nullopt;
    if (picture.empty()) continue;
    key_ = key;
    coming_ = keys[key];
    pages_ = decode::PicturePages(deck_, static_cast<int>(key), picture);
    return true;
  }
  return false;
}

std::vector<std::uint8_t> DeckPictures::Load(std::size_t key, const DeckKey& wanted) {
  const std::string size = std::to_string(deck_.shape.key_px), call = fmt::format("{:016x}", wanted.call);
  std::vector<std::filesystem::path> stems{folder_ / fmt::format("{}", key + 1)};
  for (const std::string& name : {call, std::string("blank")})
    for (const auto& folder : {of_show_, folder_})
      if (!folder.empty()) stems.push_back(folder / size / name);
  for (const auto& stem : stems)
    for (const std::string_view lit : {"-lit", ""}) {
      if (!lit.empty() && !wanted.is_lit) continue;
      if (auto picture = Read(fmt::format("{}{}{}", stem.string(), lit, deck_.shape.suffix())))
        return *picture;
    }
  return {};
}

std::optional<std::vector<std::uint8_t>> DeckPictures::Read(const std::filesystem::path& file) {
  const auto bytes = ReadFile(file, {.most_bytes = kMostPictureBytes});
  if (bytes && !bytes->empty()) return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
  if (!bytes && bytes.error().cause == std::errc::no_such_file_or_directory) return std::nullopt;
  if (told_files_.insert(file).second)
    LogWarning("{}; no key shows it", bytes ? file.string() + " is empty" : bytes.error().message());
  return std::nullopt;
}

// A deck that is gone is noticed when it is read.
void DeckPictures::HandleFailure(const Error& error, Time now, std::string_view name) {
  next_page_ = pages_.size();
  shown_[key_].reset();
  not_before_ = now + kPictureRetry;
  if (failures_.Note(now))
    LogWarning("{}: {}; its keys stay as they are until it is plugged in again", name, error.message());
}

}  // namespace kaori::input
