#include "appliance/programs/shows/offers.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/update/bundle.h"
#include "appliance/core/update/pending.h"
#include "appliance/programs/shows/choice_files.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

constexpr std::size_t kRoomForKeys = 2;  // In a list that has more shows than it has numbers.

// As people compare it with what a stick holds: decimal, without a fraction.
std::string Megabytes(std::uint64_t bytes) {
  return fmt::format("{:.0f} MB", static_cast<double>(bytes) * 1e-6);
}

// Of its header, which is signed by somebody: whether it is trusted is said when it is taken.
std::string WordsOf(const Offer& offer) {
  const auto head = ReadBeginning(offer.file, update::kHeader_bytes);
  const auto manifest = update::ReadHeader(AsBytes(head.value_or("")), offer.bytes);
  if (!manifest) return "no update that can be read";
  return fmt::format("version {}{}{}", manifest->version, manifest->news.empty() ? "" : ", ", manifest->news);
}

}  // namespace

// A pack that was removed to make room is no show to go back to.
std::vector<Choosable> WaysBack(const Folder& shows) {
  const store::Choice choice = ReadChoice(shows);
  std::vector<Choosable> ways;
  const auto offer = [&](const char* name, std::string id) {
    ways.push_back({.kind = Choosable::Kind::kBack,
                    .offer = {.file = {}, .name = name},
                    .remark = {},
                    .id = std::move(id)});
  };
  if (choice.previous != choice.current && shows.BytesOf(store::PackName(choice.previous)) > 0)
    offer("back to the show before", choice.previous);
  if (choice.current != store::kRootShow) offer("back to the box's own show", std::string(store::kRootShow));
  return ways;
}

std::vector<Choosable> WaysOn(const std::filesystem::path& pending, const std::filesystem::path& before) {
  const auto restart = [](std::string name) -> std::vector<Choosable> {
    return {
        {.kind = Choosable::Kind::kRestart, .offer = {.file = {}, .name = std::move(name)}, .remark = {}}};
  };
  if (const auto waits = update::ReadPending(pending))
    return restart("restart the box to try " +
                   (waits->version == 0 ? "its other system" : fmt::format("version {}", waits->version)));
  if (const auto was = update::ReadPending(before))
    return restart(fmt::format("restart the box to go back to version {}", was->version));
  return {};
}

// Shows first, so that their numbers do not depend on the keys beside them; of many shows some have to give
// their numbers to keys, without which they might not be trusted. A file that holds no key is not offered. Updates
// come behind the shows.
Result<Offered> OffersOf(const std::filesystem::path& stick, const std::vector<Choosable>& below) {
  const auto packs = ListShows(stick), updates = ListUpdates(stick), backups = ListBackups(stick),
             settings = ListSettings(stick), keys = ListKeys(stick);
  for (const auto* list : {&packs, &updates, &backups, &settings, &keys})
    if (!*list) return tl::unexpected(list->error());
  std::vector<Choosable> choices, of_keys;
  for (const auto& offer : *packs) choices.push_back({Choosable::Kind::kShow, offer, Megabytes(offer.bytes)});
  for (const auto& offer : *updates) choices.push_back({Choosable::Kind::kUpdate, offer, WordsOf(offer)});
  for (const auto& offer : *backups)
    choices.push_back({Choosable::Kind::kRestore, offer, Megabytes(offer.bytes)});
  for (const auto& offer : *settings) choices.push_back({Choosable::Kind::kSettingsFile, offer, {}});
  for (const auto& offer : *keys)
    if (const auto key = show::ReadPublicKey(offer.file))
      of_keys.push_back({Choosable::Kind::kKey, offer, show::Fingerprint(*key), *key});
  // The ways that are `below` always have their numbers: shows and keys share what is left.
  const std::size_t all = choices.size() + of_keys.size(), numbers = kMostChoices - below.size();
  choices.resize(std::min(choices.size(), numbers - std::min(of_keys.size(), kRoomForKeys)));
  of_keys.resize(std::min(of_keys.size(), numbers - choices.size()));
  choices.insert(choices.end(), of_keys.begin(), of_keys.end());
  const std::size_t of_stick = choices.size();
  choices.insert(choices.end(), below.begin(), below.end());
  return Offered{std::move(choices), of_stick, all - of_stick};
}

}  // namespace kaori::shows
