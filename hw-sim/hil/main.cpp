// kaori-bench: starts the box's image in a virtual machine, plugs in simulated devices, and tries what it
// must do.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/hil/trial.h"

namespace {

constexpr std::string_view kHelp =
    R"(kaori-bench: the box's image in a virtual machine, with simulated devices, tried and reported

  --image FOLDER        bzImage, cmdline and kaori.disk (out/image)
  --bench-disk FILE     the disk with the witness and tools
  --bench-kernel FILE   a kernel with simulated hardware of its own, for the checks that want it
  --report FOLDER       where report.html, report.xml and pictures go
  --figures FILE        a JSON object that gets the figures
  --play FILE           the scenario that is played
  --only NAMES          these checks, with commas between
  --chosen              those that run each time
  --list                names the checks, and ends
  --scenes 0            of the scenario, from its beginning; 0 plays all
  --replugs 200         how often cables are pulled and plugged
  --seed 1              of their order
  --size 480x270        of the screen
)";

struct Settings {
  std::string image = "out/image", bench_disk, bench_kernel, report = "out/bench", figures, play, only;
  std::string scenes = "0", replugs = "200", seed = "1", size = "480x270";
  bool chosen = false, list = false;
};

constexpr int kNotTried = 2;  // The exit status where no check could be run at all.

bool Wanted(const kaori::hil::Check& check, const Settings& settings) {
  if (!settings.only.empty())
    return ("," + settings.only + ",").find("," + check.name + ",") != std::string::npos;
  return !settings.chosen || check.chosen;
}

std::vector<kaori::hil::Check> WantedChecks(const Settings& settings) {
  auto checks = kaori::hil::AllChecks();
  std::erase_if(checks, [&](const auto& check) { return !Wanted(check, settings); });
  return checks;
}

std::string_view Sign(kaori::hil::Verdict verdict) {
  if (verdict == kaori::hil::Verdict::kPassed) return "ok  ";
  return verdict == kaori::hil::Verdict::kFailed ? "FAIL" : "skip";
}

// The hash of the root, which stands on the command line before its salt.
std::string RootHash(const std::string& image) {
  std::ifstream file(image + "/cmdline");
  for (std::string word, hash; file >> word; hash = word)
    if (hash == "sha256") return word;
  return {};
}

kaori::Result<std::string> MakeFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "kaori-bench-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) return kaori::FailErrno("make a folder for sockets");
  return pattern;
}

void Tell(const kaori::hil::ReportedCheck& check) {
  const auto& [verdict, said, pictures, figures, texts, took_s] = check.finding;
  fmt::print("{}  {:6.1f} s  {}: {}\n", Sign(verdict), took_s, check.name, said);
  std::fflush(stdout);
}

int TryAll(const Settings& settings, const std::string& sockets, const kaori::Size& size) {
  const kaori::SteadyClock clock;
  auto place = kaori::hil::Place::Open({.image = settings.image,
                                        .bench_disk = settings.bench_disk,
                                        .bench_kernel = settings.bench_kernel,
                                        .folder = sockets,
                                        .width_px = size.width_px,
                                        .height_px = size.height_px},
                                       clock);
  if (!place) return kaori::ExitWithError(place.error(), kNotTried);
  kaori::hil::Trial trial(
      {.report = settings.report,
       .play = settings.play,
       .replugs = std::atoi(settings.replugs.c_str()),
       .scenes = std::atoi(settings.scenes.c_str()),
       .seed = static_cast<std::mt19937::result_type>(std::strtoul(settings.seed.c_str(), nullptr, 10))},
      **place);
  kaori::hil::Report report{.image = settings.image, .root_hash = RootHash(settings.image), .checks = {}};
  for (const auto& check : WantedChecks(settings)) {
    report.checks.push_back(trial.Try(check));
    Tell(report.checks.back());
    report.boot_s = trial.boot_s();
    if (auto ok = kaori::hil::WriteReport(report, settings.report); !ok)
      return kaori::ExitWithError(ok.error(), kNotTried);
  }
  trial.End();
  if (!settings.figures.empty())
    if (auto ok = kaori::hil::MergeFigures(report, settings.figures); !ok)
      return kaori::ExitWithError(ok.error(), kNotTried);
  fmt::print("{} passed, {} failed, {} skipped; see {}/report.html\n",
             report.count(kaori::hil::Verdict::kPassed), report.count(kaori::hil::Verdict::kFailed),
             report.count(kaori::hil::Verdict::kSkipped), settings.report);
  return report.count(kaori::hil::Verdict::kFailed) == 0 ? 0 : 1;
}

int List() {
  for (const auto& check : kaori::hil::AllChecks())
    fmt::print("{:16} {}{}\n", check.name, check.sentence, check.chosen ? "" : " (long mode)");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-bench");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--image", settings.image)
      .Text("--bench-disk", settings.bench_disk)
      .Text("--bench-kernel", settings.bench_kernel)
      .Text("--report", settings.report);
  options.Text("--figures", settings.figures).Text("--play", settings.play).Text("--only", settings.only);
  options.Switch("--chosen", settings.chosen)
      .Switch("--list", settings.list)
      .Text("--replugs", settings.replugs);
  options.Text("--seed", settings.seed).Text("--size", settings.size);
  options.Text("--scenes", settings.scenes);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (settings.list) return List();
  const auto size = kaori::ParseSize(settings.size);
  if (!size)
    return kaori::ExitWithError(
        kaori::FailInput("--size " + settings.size + ": expected such as 960x540").value(), kNotTried);
  if (WantedChecks(settings).empty())
    return kaori::ExitWithError(kaori::FailInput("no check is called " + settings.only).value(), kNotTried);
  std::filesystem::create_directories(settings.report);
  settings.report = std::filesystem::absolute(settings.report);  // QEMU writes pictures there.
  const auto sockets = MakeFolder();
  if (!sockets) return kaori::ExitWithError(sockets.error(), kNotTried);
  const int status = TryAll(settings, *sockets, *size);
  std::filesystem::remove_all(*sockets);
  return status;
}
