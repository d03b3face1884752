// How a backup differs from the box, in the order in which somebody has to know it who agrees to the backup.
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/restore/kept.h"
#include "appliance/programs/shows/restoration.h"
#include "appliance/programs/shows/restore_disk.h"
#include "appliance/programs/shows/settings_text.h"
#include "drivers/base/folder.h"
#include "drivers/base/utf8.h"

namespace kaori::shows {
namespace {

constexpr std::size_t kIdDigitsShown = 8;
constexpr std::size_t kPathShown = 60;

std::string ShortId(const std::string& show) {
  return show == store::kRootShow ? "the box's own one" : show.substr(0, kIdDigitsShown);
}

bool IsKey(const std::string& path) {
  return path.ends_with(".pub");
}

std::string Line(std::string_view word, const std::string& path, const std::string& behind = {}) {
  return fmt::format("{:8}{}{}", word, utf8::Printable(path, kPathShown), behind);
}

}  // namespace

// Whose shows would play is agreed to by what the key is, and not by its file's name.
std::string Restoration::FingerprintOf(const std::string& path) const {
  if (!IsThere(Staged(path))) return {};
  const auto key = show::ReadPublicKey(Staged(path));
  return key ? "  " + show::Fingerprint(*key) : "  no key";
}

// Each setting by itself: one of them may be a profile that authorises everything. A change of comments alone is a changed file.
std::vector<std::string> Restoration::DifferencesOfSettings() const {
  const std::string path(restore::kSettings);
  if (std::ranges::find(plan_.put, path) == plan_.put.end()) return {};
  auto lines = SettingsDifferences(ContentOf(terms_.data / path), ContentOf(Staged(path)));
  return lines.empty() ? std::vector{Line("changed", path)} : lines;
}

// The show first, which everybody sees; then whom the box would trust, how it would be set, what is lost or changed, and what
// comes. A key is never among what is left out without a word.
std::vector<std::string> Restoration::Differences(std::size_t most) const {
  std::vector<std::string> lines, others;
  if (!plan_.show.empty())
    lines.push_back("show " + ShortId(plan_.show) + " in place of " +
                    ShortId(store::ReadChoice(terms_.data / "shows").current));
  else if (!plan_.put.empty() && plan_.put.back() == pack_)
    lines.push_back("show " + ShortId(reader_->contents().show) + " anew");
  const std::size_t before_keys = lines.size();
  const std::array groups{std::pair("changed", &changed_), std::pair("gone", &plan_.removed),
                          std::pair("new", &fresh_)};
  for (const auto& [word, paths] : groups)
    for (const std::string& path : *paths) {
      if (IsKey(path)) lines.push_back(Line(word, path, FingerprintOf(path)));
      if (!IsKey(path) && path != restore::kSettings) others.push_back(Line(word, path));
    }
  const std::size_t keys_end = lines.size();
  std::ranges::move(DifferencesOfSettings(), std::back_inserter(lines));
  if (std::ranges::find(plan_.removed, restore::kSettings) != plan_.removed.end())
    lines.push_back(Line("gone", std::string(restore::kSettings)));
  std::ranges::move(others, std::back_inserter(lines));
  if (lines.size() <= most) return lines;
  const std::size_t more = lines.size() - most,
                    keys = keys_end - std::max(std::min(keys_end, most), before_keys);
  lines.resize(most);
  lines.push_back(fmt::format("and {} more{}", more, keys > 0 ? fmt::format(", {} of them keys", keys) : ""));
  return lines;
}

}  // namespace kaori::shows
