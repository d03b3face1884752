#include <fmt/format.h>

#include "hw-sim/bench/check.h"

namespace kaori::bench {

Result<void> Scene::Shoot(const std::string& name, const std::string& caption) {
  const std::string file = fmt::format("{}-{}.png", name, finding.pictures.size());
  if (auto ok = place.machine().Shoot(0, folder + "/" + file); !ok) return ok;
  finding.pictures.push_back({file, caption});
  return {};
}

std::vector<Check> AllChecks() {
  std::vector<Check> all;
  for (auto& part : {ScreenChecks(), HandChecks(), LatencyChecks(), SourceChecks(), CableChecks(),
                     GadgetChecks(), ToolChecks()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace kaori::bench
