// kaori-bench: starts the box's image in a virtual machine, plugs in simulated devices, and runs checks. It
// also starts the image for a person to look at (--boot), and prints QEMU's command line for other programs
// (--command).
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "drivers/base/checksum.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/read_file.h"
#include "hw-sim/hil/boot_command.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/check_runner.h"
#include "hw-sim/hil/image_files.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/hil/rounds.h"

namespace {

constexpr std::string_view kHelp =
    R"(kaori-bench: the box's image in a virtual machine, with simulated devices, tried and reported

  --image FOLDER        kernel, cmdline and kaori.disk (out/image)
  --arch amd64          the image's processor: amd64 or arm64
  --bench-disk FILE     the disk with the in-guest agent and tools
  --bench-kernel FILE   a kernel with simulated hardware of its own, for the checks that want it
  --report FOLDER       where report.html, report.xml and pictures go
  --figures FILE        a JSON object that gets the figures
  --play FILE           the scenario that is played
  --only NAMES          these checks, with commas between
  --chosen              those that run each time
  --release             those of a release too, which take more than a quarter of an hour each
  --go-on               rounds that have passed in the report's folder, on this very image and bench, are not tried again
  --list                names the checks, and ends
  --scenes 0            of the scenario, from its beginning; 0 plays all
  --replugs 200         how often cables are pulled and plugged
  --seed 1              of their order
  --effort 1            how many rounds those checks have that cut the power or end the stage again and again; a release: 10
  --controls            each check is followed by its negative control
  --usual-image FILE    the program that makes an image which starts in the usual way (tests/hil/usual_image)
  --sticks FOLDER       images of sticks that are plugged in (out/sticks)
  --chip FOLDER         the dial box's shipped image and the emulator of its chip (tests/firmware/chip.py)
  --size 480x270        of the screen
  --memory 512          of the machine, in MiB
  --box-draws           the machine's processor draws in every check, and not the bench for it, as a graphics card would

kaori-bench --boot: starts the image, with a window where there is a display
  --trace               prints where the time goes until the first face, and ends
  --shot FILE.png       writes a picture of the screen once the first face is there, and ends

kaori-bench --command FOLDER: prints QEMU's program and arguments, one a line, for a machine without a graphics card. Its
log and its monitor are FOLDER/console.log and FOLDER/qmp
  --disk FILE           another disk than the image's
  --keep-disk           what the machine writes to its disk is kept
)";

// The command line as it was given; numbers are texts, which are read where they are used.
struct Settings {
  std::string image = "out/image", bench_disk, bench_kernel, report = "out/bench", figures, play, only;
  std::string scenes = "0", replugs = "200", seed = "1", effort = "1", size = "480x270", memory = "512",
              usual_image = "tests/hil/usual_image", sticks = "out/sticks", chip;
  std::string shot, command, disk, arch = "amd64";
  bool chosen = false, release = false, go_on = false, list = false, controls = false, boot = false,
       trace = false;
  bool keep_disk = false, box_draws = false;
};

constexpr int kNotTried = 2;  // The exit status where no check could be run at all.

// Where the bench itself cannot work: no box was tried.
int Exit(const kaori::Error& error) {
  return kaori::ExitWithError(error, kNotTried);
}

// --only names checks and counts alone; else --chosen leaves those that take long out, and only --release has all.
bool Wanted(const kaori::hil::Check& check, const Settings& settings) {
  if (!settings.only.empty())
    return ("," + settings.only + ",").find("," + check.name + ",") != std::string::npos;
  return settings.chosen ? check.chosen : settings.release || !check.release;
}

std::vector<kaori::hil::Check> WantedChecks(const Settings& settings) {
  auto checks = kaori::hil::AllChecks();
  std::erase_if(checks, [&](const auto& check) { return !Wanted(check, settings); });
  return checks;
}

std::string_view Mark(kaori::hil::Verdict verdict) {
  if (verdict == kaori::hil::Verdict::kPassed) return "ok  ";
  return verdict == kaori::hil::Verdict::kFailed ? "FAIL" : "skip";
}

// The hash of the root, which is on the command line before its salt: "... blake2b-512 HASH
// SALT", as dm-mod.create has it. It tells in a report which image was tried.
std::string RootHash(const std::string& image) {
  std::istringstream line(kaori::hil::ReadCommandLine(image).value_or(""));
  for (std::string word, hash; line >> word; hash = word)
    if (hash == "blake2b-512") return word;
  return {};
}

// All that a finding depends on but the number of its rounds: the image, this program and the agent that was built with it, and how much is tried.
std::string TrialOf(const Settings& settings, const kaori::hil::Report& report) {
  const std::filesystem::path bench = std::filesystem::read_symlink("/proc/self/exe");
  std::uint64_t sum = kaori::kFnvBasis;
  for (const std::string file : {bench, bench.parent_path() / "kaori-hil-agent"})
    if (const auto bytes = kaori::ReadFile(file, {.most_bytes = std::size_t{1} << 30U}))
      sum = kaori::Fnv1a(*bytes, sum);
  std::uint64_t files = kaori::kFnvBasis;
  for (const auto& [name, hash] : report.files) files = kaori::Fnv1a(hash, kaori::Fnv1a(name, files));
  return fmt::format("image {}, files {:016x}, bench {:016x}, {} scenes, {} replugs, seed {}{}{}",
                     report.root_hash, files, sum, settings.scenes, settings.replugs, settings.seed,
                     settings.controls ? ", controls" : "", settings.box_draws ? ", the box draws" : "");
}

// For sockets, whose paths have 108 bytes at most (unix(7)): the report's folder may lie too deep.
kaori::Result<std::string> MakeFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "kaori-bench-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) return kaori::FailErrno("make a folder for sockets");
  return pattern;
}

// One line for each round, as it ends: a run takes long.
void Tell(const kaori::hil::ReportedCheck& check, int wanted, bool before) {
  const kaori::hil::Finding& found = check.finding;
  fmt::print("{}  {:6.1f} s  {}{}: {}{}\n", Mark(found.verdict), found.took_s, check.name,
             wanted > 1 ? fmt::format(" {}/{}", found.rounds, wanted) : "", before ? "before: " : "",
             found.Said());
  std::fflush(stdout);
}

// A window only for a person who looks: with --shot the picture alone counts. A memory
// that is no number is the least one.
kaori::hil::QemuOptions MachineOf(const Settings& settings, const std::string& folder,
                                  const kaori::Size& size) {
  return {
      .architecture = kaori::hil::ParseArchitecture(settings.arch).value_or(kaori::hil::Architecture::kAmd64),
      .image = settings.image,
      .bench_disk = settings.bench_disk,
      .bench_kernel = settings.bench_kernel,
      .usual_image = settings.usual_image,
      .sticks = std::filesystem::absolute(settings.sticks),
      .chip = settings.chip,
      .folder = folder,
      .width_px = size.width_px,
      .height_px = size.height_px,
      .memory_mib = std::max(64, std::atoi(settings.memory.c_str())),
      .window = settings.boot && settings.shot.empty() && std::getenv("DISPLAY") != nullptr,
      .draws = !settings.boot && !settings.box_draws};
}

// Starts nothing: who runs the command decides when, and where it ends.
int PrintCommand(const Settings& settings, const kaori::Size& size) {
  const auto line = kaori::hil::ReadCommandLine(settings.image);
  if (!line) return Exit(line.error());
  const std::string disk = settings.disk.empty() ? settings.image + "/kaori.disk" : settings.disk;
  // For others' machines: no graphics card, no agent, and the folder of the caller.
  const kaori::hil::Setup setup{
      .agent = false, .keeps_disk = settings.keep_disk, .graphics = kaori::hil::Graphics::kNone};
  const auto machine = MachineOf(settings, settings.command, size);
  for (const std::string& word :
       kaori::hil::QemuCommand(machine, setup, kaori::hil::LoggedCommandLine(machine, *line), disk))
    fmt::print("{}\n", word);
  return 0;
}

int BootImage(const Settings& settings, const std::string& folder, const kaori::Size& size) {
  const kaori::SteadyClock clock;
  const std::string shot = settings.shot.empty() ? "" : std::filesystem::absolute(settings.shot).string();
  const auto ok =
      kaori::hil::Boot(MachineOf(settings, folder, size), {.trace = settings.trace, .shot = shot}, clock);
  return ok ? 0 : Exit(ok.error());
}

// The exit status: 0 where no check failed (skipped ones are no failure), 1 where one did,
// kNotTried where the bench could not work.
int RunChecks(const Settings& settings, const std::string& sockets, const kaori::Size& size) {
  const kaori::SteadyClock clock;
  auto target = kaori::hil::Target::Open(MachineOf(settings, sockets, size), clock);
  if (!target) return Exit(target.error());
  kaori::hil::CheckRunner runner(
      {.report = settings.report,
       .play = settings.play,
       .replugs = std::atoi(settings.replugs.c_str()),
       .scenes = std::atoi(settings.scenes.c_str()),
       .seed = static_cast<std::mt19937::result_type>(std::strtoul(settings.seed.c_str(), nullptr, 10)),
       .controls = settings.controls},
      **target);
  const auto checks = WantedChecks(settings);
  kaori::hil::Report report{.image = settings.image,
                            .root_hash = RootHash(settings.image),
                            .files = kaori::hil::UpdateFileHashes(settings.image, sockets + "/sha256sum.log"),
                            .wanted = checks.size(),
                            .checks = {}};
  const auto run = [&](const kaori::hil::Check& check, int round) {
    auto found = runner.Run(check, round);
    report.boot_s = runner.boot_s();
    return found;
  };
  const auto ok = kaori::hil::RunRounds(checks,
                                        {.report = settings.report,
                                         .figures = settings.figures,
                                         .trial = TrialOf(settings, report),
                                         .effort = std::max(1, std::atoi(settings.effort.c_str())),
                                         .go_on = settings.go_on},
                                        run, Tell, report);
  if (!ok) return Exit(ok.error());
  runner.End();
  fmt::print("{} passed, {} failed, {} skipped; see {}/report.html\n",
             report.count(kaori::hil::Verdict::kPassed), report.count(kaori::hil::Verdict::kFailed),
             report.count(kaori::hil::Verdict::kSkipped), settings.report);
  return report.count(kaori::hil::Verdict::kFailed) == 0 ? 0 : 1;
}

int List() {
  for (const auto& check : kaori::hil::AllChecks())
    fmt::print("{:16} {}{}\n", check.name, check.sentence,
               check.chosen    ? ""
               : check.release ? " (a release)"
                               : " (long mode)");
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
      .Switch("--release", settings.release)
      .Switch("--go-on", settings.go_on)
      .Switch("--list", settings.list)
      .Text("--replugs", settings.replugs);
  options.Text("--effort", settings.effort).Text("--seed", settings.seed).Text("--size", settings.size);
  options.Text("--scenes", settings.scenes).Switch("--controls", settings.controls);
  options.Text("--usual-image", settings.usual_image)
      .Text("--memory", settings.memory)
      .Text("--sticks", settings.sticks)
      .Text("--chip", settings.chip);
  options.Switch("--boot", settings.boot).Switch("--trace", settings.trace).Text("--shot", settings.shot);
  options.Text("--command", settings.command).Text("--disk", settings.disk);
  options.Switch("--keep-disk", settings.keep_disk)
      .Switch("--box-draws", settings.box_draws)
      .Text("--arch", settings.arch);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (settings.list) return List();
  const auto size = kaori::ParseSize(settings.size);
  if (!size) return Exit(kaori::FailInput("--size " + settings.size + ": expected such as 960x540").value());
  if (!kaori::hil::ParseArchitecture(settings.arch))
    return Exit(kaori::FailInput("--arch " + settings.arch + ": expected amd64 or arm64").value());
  if (!settings.command.empty()) return PrintCommand(settings, *size);
  if (WantedChecks(settings).empty())
    return Exit(kaori::FailInput("no check is called " + settings.only).value());
  settings.image = std::filesystem::absolute(settings.image);
  settings.report = std::filesystem::absolute(settings.report);  // QEMU writes pictures there.
  if (!settings.boot) std::filesystem::create_directories(settings.report);
  const auto folder = MakeFolder();
  if (!folder) return Exit(folder.error());
  // Sockets and copies of disks are in this folder, and are gone afterwards.
  const int status =
      settings.boot ? BootImage(settings, *folder, *size) : RunChecks(settings, *folder, *size);
  std::filesystem::remove_all(*folder);
  return status;
}
