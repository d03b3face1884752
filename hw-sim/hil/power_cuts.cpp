#include "hw-sim/hil/power_cuts.h"

#include <random>

namespace kaori::hil {

// By chance behind any of them, the last one too: then all of it is kept.
std::size_t CutPoint(Scene& scene, std::size_t first, std::size_t end, int number, int of) {
  const std::size_t even =
      first + (end - first) * static_cast<std::size_t>(number + 1) / static_cast<std::size_t>(of + 1);
  return number % 2 == 0 ? even : std::uniform_int_distribution<std::size_t>(first + 1, end)(scene.chance);
}

Result<void> WantFaceOf(Scene& scene, const UpdatedPc& pc, const char* when, Duration longest) {
  auto ok = pc.Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, when, longest);
  scene.target.machine().Off();
  return ok;
}

// The slot's root is spoilt, and its name is the loader's default.
Result<void> ASpoiltSlotIsSeen(Scene& scene) {
  constexpr Duration kNoFace = std::chrono::seconds(60);  // So long no face may come.
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  if (auto ok = pc->SpoilSlotB(); !ok) return ok;
  if (auto ok = pc->NameDefault('b'); !ok) return ok;
  if (pc->Default() != 'b') return FailInput("another default is not seen");
  if (auto ok = pc->Start(scene); !ok) return ok;
  const auto seen = AwaitUpdateFace(scene, "of a spoilt slot", kNoFace);
  scene.target.machine().Off();
  return seen ? FailInput("a spoilt slot shows its face") : Result<void>{};
}

}  // namespace kaori::hil
