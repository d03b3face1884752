#include "appliance/needles/caption.h"

#include <fmt/format.h>

namespace kaori::needles {
namespace {

constexpr float kMillimetresPerMetre = 1000;

constexpr const char* kHelp[] = {
    "arrows choose   dials 2-6: u v out scale lids   M mirror   S smooth   Backspace zero   Z undo   Y redo",
    "hold C before   0 neutral   P from the one in play   Enter save   Shift+Enter as new   N name   Del "
    "delete   "
    "Tab close"};

// As written in files: outwards from the middle is positive u on both sides.
std::string NeedleLine(const Session& session, int chosen) {
  const std::string spread = fmt::format("mirror {}   smooth {}", session.spread.mirror ? "on" : "off",
                                         session.spread.smooth ? "on" : "off");
  if (chosen < 0) return "no needle   " + spread;
  const auto point = static_cast<std::size_t>(chosen);
  const float side = session.points().OnTheRight(point) ? -1.0F : 1.0F;
  const glm::vec3 pull_mm = session.work().pulls_m[point] * kMillimetresPerMetre;
  // Adding 0 takes the sign off a zero.
  return fmt::format("needle {}   u {:+.1f}  v {:+.1f}  out {:+.1f} mm   {}", session.points().names[point],
                     side * pull_mm.x + 0.0F, pull_mm.y + 0.0F, pull_mm.z + 0.0F, spread);
}

std::string NameOf(const Work& work) {
  if (!work.name.empty()) return work.name;
  return work.origin.empty() ? "new" : "new, from " + work.origin;
}

std::string WorkLine(const Session& session, bool comparing) {
  if (comparing) return fmt::format("expression: {}, as it was before", NameOf(session.work()));
  const Work& work = session.work();
  std::string steps = fmt::format("{} undo", session.undoable());
  if (session.redoable() > 0) steps += fmt::format(", {} redo", session.redoable());
  std::string line = fmt::format("expression: {}{} ({})", NameOf(work), session.unsaved() ? "*" : "", steps);
  if (work.lids != std::array<float, 2>{})
    line += fmt::format("   lids {:.2f} {:.2f}", work.lids[0], work.lids[1]);
  return line;
}

}  // namespace

std::vector<std::string> CaptionLines(const CaptionFacts& facts) {
  std::vector<std::string> lines;
  if (!facts.trouble.empty()) lines.push_back("not on the disk: " + facts.trouble);
  if (!facts.message.empty()) lines.push_back(facts.message);
  if (facts.typing) {
    lines.push_back(fmt::format("name: {}|", facts.typing->text));
    lines.emplace_back("letters, digits and _   Enter takes it   Esc leaves it");
    return lines;
  }
  lines.push_back(NeedleLine(facts.session, facts.chosen));
  lines.push_back(WorkLine(facts.session, facts.comparing));
  if (!facts.own.empty()) lines.push_back("own (Shift and digit): " + facts.own);
  for (const char* help : kHelp) lines.emplace_back(help);
  return lines;
}

}  // namespace kaori::needles
