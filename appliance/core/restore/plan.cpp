#include "appliance/core/restore/plan.h"

#include "appliance/core/restore/kept.h"
#include "appliance/core/store/choice.h"
#include "drivers/base/checksum.h"

namespace kaori::restore {
namespace {

constexpr std::string_view kHead = "kaori-restore 1\n", kSum = "sum ", kShow = "show ", kPut = "put ",
                           kRemove = "remove ";

// Without its word, and false for a line that no plan has.
bool AddLine(std::string_view line, Plan& plan) {
  const auto after = [&](std::string_view word) { return std::string(line.substr(word.size())); };
  if (line.starts_with(kShow)) {
    plan.show = after(kShow);
    return plan.show == store::kRootShow || store::IsId(plan.show);
  }
  const bool puts = line.starts_with(kPut);
  if (!puts && !line.starts_with(kRemove)) return false;
  std::string path = after(puts ? kPut : kRemove);
  if (!IsRestored(path) && !IsPack(path)) return false;
  (puts ? plan.put : plan.removed).push_back(std::move(path));
  return true;
}

}  // namespace

// One line for each path, so that a person can read what a box that does not start was about to do.
std::string Format(const Plan& plan) {
  std::string text(kHead);
  if (!plan.show.empty()) text += std::string(kShow) + plan.show + "\n";
  for (const std::string& path : plan.put) text += std::string(kPut) + path + "\n";
  for (const std::string& path : plan.removed) text += std::string(kRemove) + path + "\n";
  return text + std::string(kSum) + std::to_string(Fnv1a(text)) + "\n";
}

// The checksum first, so that nothing of a torn text is believed.
std::optional<Plan> ParsePlan(std::string_view text) {
  const auto sum_at = text.rfind(kSum);
  if (!text.starts_with(kHead) || sum_at == std::string_view::npos) return std::nullopt;
  const std::string_view lines = text.substr(0, sum_at);
  if (text.substr(sum_at) != std::string(kSum) + std::to_string(Fnv1a(lines)) + "\n") return std::nullopt;
  Plan plan;
  for (std::string_view rest = lines.substr(kHead.size()); !rest.empty();) {
    const auto end = rest.find('\n');
    if (end == std::string_view::npos || !AddLine(rest.substr(0, end), plan)) return std::nullopt;
    rest.remove_prefix(end + 1);
  }
  return plan;
}

}  // namespace kaori::restore
