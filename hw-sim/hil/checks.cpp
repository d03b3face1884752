#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {

Result<void> Scene::Shoot(const std::string& name, const std::string& caption) {
  const std::string file = fmt::format("{}-{}.png", name, finding.pictures.size());
  if (auto ok = place.machine().Shoot(0, folder + "/" + file); !ok) return ok;
  finding.pictures.push_back({file, caption});
  return {};
}

Result<void> Scene::ShootFace(const std::string& name, const std::string& caption) {
  if (auto ok = Shoot(name, caption); !ok) return ok;
  const auto picture = LookAt(folder + "/" + finding.pictures.back().file);
  if (!picture) return tl::unexpected(picture.error());
  if (!ShowsAFace(*picture)) return FailInput("no face is on the screen: " + Words(*picture));
  return {};
}

Result<void> Scene::Skip(std::string why) {
  finding.verdict = Verdict::kSkipped;
  finding.said = std::move(why);
  return {};
}

// Those that want the same setup stand together: another one is a box started anew.
std::vector<Check> AllChecks() {
  std::vector<Check> all;
  for (auto& part : {ScreenChecks(), PlayChecks(), HandChecks(), LatencyChecks(), SourceChecks(),
                     LineChecks(), SoundChecks(), PluginChecks(), CableChecks(), ToolChecks(),
                     StrangerChecks(), AloneChecks(), SpeedChecks(), GadgetChecks(), LoopChecks()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace kaori::hil
