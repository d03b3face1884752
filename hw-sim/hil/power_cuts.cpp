#include "hw-sim/hil/power_cuts.h"

#include <algorithm>
#include <random>

namespace kaori::hil {

// Behind the last one, too: then all of it is kept.
std::size_t CutPoint(Scene& scene, std::size_t first, std::size_t end, int number, int of) {
  const auto part_begins = [&](int part) {
    return first + (end - first) * static_cast<std::size_t>(part) / static_cast<std::size_t>(of);
  };
  const std::size_t least = part_begins(number) + 1;
  return std::uniform_int_distribution<std::size_t>(least,
                                                    std::max(least, part_begins(number + 1)))(scene.chance);
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
