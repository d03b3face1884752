#include "appliance/programs/editor/caption.h"

#include <array>
#include <iterator>

#include <fmt/format.h>

namespace kaori::editor {
namespace {

constexpr float kMillimetresPerMetre = 1000;

// Short lines: the caption keeps to the left of the face. They name what input.cpp reads; whoever changes a
// key changes both.
constexpr const char* kHelp[] = {"arrows choose   dials 2-6 pull", "M mirror  S smooth  Z undo  Y redo",
                                 "Backspace zero  C before  0 neutral",
                                 "P in play  Enter save  Shift: as new", "N name  Delete  Tab close  H less"};
constexpr const char* kLittleHelp = "H help   Tab close";

// As written in files: outwards from the middle is positive u on both sides.
std::string HandleLine(const Session& session, int chosen) {
  if (chosen < 0) return "no needle is chosen";
  const auto point = static_cast<std::size_t>(chosen);
  const float side = session.points().OnTheRight(point) ? -1.0F : 1.0F;
  const glm::vec3 pull_mm = session.work().pulls_m[point] * kMillimetresPerMetre;
  // Adding 0 takes the sign off a zero.
  return fmt::format("{}   u {:+.1f}  v {:+.1f}  out {:+.1f} mm", session.points().names[point],
                     side * pull_mm.x + 0.0F, pull_mm.y + 0.0F, pull_mm.z + 0.0F);
}

// Lids are said only where they are shut at all.
std::string SpreadLine(const Session& session) {
  std::string line = fmt::format("mirror {}   smooth {}", session.spread.mirror ? "on" : "off",
                                 session.spread.smooth ? "on" : "off");
  const std::array<float, 2>& lids = session.work().lids;
  if (lids != std::array<float, 2>{}) line += fmt::format("   lids {:.2f} {:.2f}", lids[0], lids[1]);
  return line;
}

// What the work is called, or where it came from while it has no name.
std::string NameOf(const Work& work) {
  if (!work.name.empty()) return work.name;
  return work.origin.empty() ? "new" : "new, from " + work.origin;
}

// A star marks work that is not saved, as editors do.
std::string WorkLine(const Session& session, bool comparing) {
  if (comparing) return NameOf(session.work()) + ", as it was before";
  std::string line =
      fmt::format("{}{}   {} undo", NameOf(session.work()), session.unsaved() ? "*" : "", session.undoable());
  if (session.redoable() > 0) line += fmt::format(", {} redo", session.redoable());
  return line;
}

}  // namespace

// What went wrong comes first. While a name is typed nothing else is said, since no other key means anything
// then.
std::vector<std::string> CaptionLines(const CaptionFacts& facts) {
  std::vector<std::string> lines;
  if (!facts.trouble.empty()) lines.push_back("not on the disk: " + facts.trouble);
  if (!facts.message.empty()) lines.push_back(facts.message);
  if (facts.typing) {
    lines.push_back(fmt::format("name: {}|", facts.typing->text));
    lines.emplace_back("Enter takes it   Esc leaves it");
    return lines;
  }
  lines.push_back(HandleLine(facts.session, facts.chosen));
  lines.push_back(SpreadLine(facts.session));
  lines.push_back(WorkLine(facts.session, facts.comparing));
  if (!facts.own.empty()) lines.push_back("own: " + facts.own);
  if (!facts.help) lines.emplace_back(kLittleHelp);
  if (facts.help) lines.insert(lines.end(), std::begin(kHelp), std::end(kHelp));
  return lines;
}

}  // namespace kaori::editor
