#include "drivers/base/graphics_cards.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "drivers/base/folder.h"

namespace kaori {
namespace {

constexpr std::string_view kCard = "card";

// The number of the card whose connector this is: 1 of "card1-HDMI-A-2". None of "card1" and "renderD128".
std::optional<unsigned> CardOfConnector(const std::string& name) {
  const auto dash = name.find('-');
  if (!name.starts_with(kCard) || dash == std::string::npos) return std::nullopt;
  unsigned number = 0;
  const char* const end = name.data() + dash;
  const auto [stop, failed] = std::from_chars(name.data() + kCard.size(), end, number);
  return failed == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace

// The kernel names a connector after its card and puts both into one list.
std::optional<std::string> CardWithScreens(const std::filesystem::path& cards) {
  std::optional<unsigned> first;
  for (const auto& entry : ListFolder(cards).value_or(std::vector<std::filesystem::path>{}))
    if (const auto number = CardOfConnector(entry.filename().string()))
      first = std::min(*number, first.value_or(*number));
  return first ? std::optional(std::string(kCard) + std::to_string(*first)) : std::nullopt;
}

std::string CardFile(const std::string& told) {
  if (told != kCardWithScreens) return told;
  const auto name = CardWithScreens("/sys/class/drm");
  return name ? "/dev/dri/" + *name : std::string();
}

}  // namespace kaori
