// A check of the bench: a sentence that is true of a box, and what shows it.
#pragma once

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/box_programs.h"
#include "hw-sim/hil/setup.h"
#include "hw-sim/hil/target.h"

namespace kaori::hil {

// A check that could not be tried is skipped with its reason, which is no pass.
enum class Verdict { kPassed, kFailed, kSkipped };

// A picture of the report.
struct Picture {
  // In the report's folder.
  std::string file;
  // What people are to see in it: it stands under the picture, and is its text for those who cannot see it.
  std::string caption;
};

// What a check found: its verdict, and what people look at to believe it.
struct Finding {
  // What Skip does not change is a pass, until the runner finds an error.
  Verdict verdict = Verdict::kPassed;
  // Why it failed or was skipped; else what was seen.
  std::string said{};
  // In the report's folder; the first is the one that counts for a list.
  std::vector<Picture> pictures{};
  // For out/boot.json. Of several rounds the greatest of each stands.
  std::map<std::string, double> figures{};
  // For the same: what was counted. Of several rounds they add up.
  std::map<std::string, double> counts{};
  // Name and content: outputs of tools.
  std::vector<std::pair<std::string, std::string>> texts{};
  // Of the check and its control, without the start of the box.
  double took_s = 0;
  // What the control came to, as the end of a sentence; empty where none was tried.
  std::string control{};
  // Of how many rounds of its check this tells; 0: of none yet.
  int rounds = 0;

  // Figures and counts.
  std::map<std::string, double> Measured() const;
  // What was said, with the control, and of which round.
  std::string Said() const;
};

// What a check works with. Made anew for each check and each control; borrows everything.
struct Scene {
  // The box with its devices, as the check finds it.
  Target& target;
  // Gets what the check finds.
  Finding& finding;
  // Of the report.
  std::string folder;
  // How many cables the check of re-plugs pulls.
  int replugs = 20;
  // Of the scenario, from its beginning; 0: all.
  int scenes = 0;
  // Seeded from the command line, the check's name and its round, so that each round can be repeated alone.
  std::mt19937& chance;
  // The scenario that is played.
  std::string play;
  // Of the check, from 0.
  int round = 0;
  // The box's programs as the check found them; none where the box has no agent, or is off.
  std::vector<BoxProgram> programs{};

  // Presses a key (HID page 7) of the box's keyboard for as long as a person does: the input program of an emulated
  // box reads it late. Blocks meanwhile.
  void TapKey(std::uint8_t usage);

  // Adds a picture of the screen to the finding, with the name of the check and a number as its
  // file. Errors: as VideoProtocol::Shoot.
  Result<void> Shoot(const std::string& name, const std::string& caption);

  // The same, of a picture that must show a face. Errors: also invalid_argument (it does not).
  Result<void> ShootFace(const std::string& name, const std::string& caption);

  // Waits until a face is on the screen of output `head`, and moves. Errors: timed_out.
  Result<void> AwaitMovingFace(int head, Duration longest);

  // Asks the agent what only has to be understood; the answer does not matter. Waits as long as a busy machine may take. Errors: as
  // AgentProtocol::Ask.
  Result<void> Tell(const std::string& question);

  // The board once all that was done has arrived: two looks, a second apart, see the same dials and pushes. Errors:
  // those of the board.
  Result<BoardView> SettledBoard();

  // Wants that the stage has not ended since the check began, whatever checks before it did to it. Errors:
  // invalid_argument (it has), as LookAtPrograms.
  Result<void> WantNoRestart();

  // For checks that switch the box on by themselves. Errors: as QemuDriver::On.
  Result<void> SwitchOn(const Setup& setup);

  // Why this cannot be tried here; for a check to return. The verdict becomes kSkipped.
  Result<void> Skip(std::string why);
};

// One check. Checks do not depend on each other: each finds a box that plays, and leaves it so.
struct Check {
  // One word, for --only and for file names.
  std::string name;
  // What is shown, as a sentence that is true of a box.
  std::string sentence;
  // Of the part that runs each time.
  bool chosen = false;
  // Errors become failures. A check that cannot run says so by Skip.
  std::function<Result<void>(Scene&)> run;
  // Of the box that it finds playing.
  Setup setup{};
  // The negative control, which the long mode tries after the check has passed: the check must fail while
  // this unit of the box is stopped ("kaori-input.service"), or this simulated device is unplugged
  // ("camera").
  std::string fails_without{};
  // The control of a check that needs another one: passes when what is wrong is seen to be wrong.
  std::function<Result<void>(Scene&)> control{};
  // It switches the box on and off by itself; it finds it without power.
  bool powers = false;
  // It kills, stops or replaces programs of the box by itself. Any other check fails where one of them has ended meanwhile: a
  // box that mends itself sooner than a check looks would seem whole.
  bool ends_programs = false;
  // How many rounds of it are run at an effort of 1, and how many a larger one makes at most: each is the whole check, with other chance
  // and its own number, and may begin with what the first one has kept.
  int least_rounds = 1, most_rounds = 1;
  // Of a release alone, since it takes more than a quarter of an hour. Never with `chosen`.
  bool release = false;
  // Which of --sticks it plugs in: where STICK.stick is not there the check is skipped, and says so. Empty: none.
  std::string stick{};
};

// The value that this part of all values, 0 to 1, does not exceed: 0.5 for the median. 0 where there is none.
double Quantile(std::vector<double> values, double part);

// For a control: what was tried must have failed since it found something wrong (ErrorKind::kInput), and not since the machine did
// not start, the agent or QEMU refused something, or a program of this computer failed: those are ErrorKind::kSystem. Errors:
// invalid_argument (it passed; with `passed`), else its own.
Result<void> WantFoundWrong(const Result<void>& tried, const char* passed);

// In the order in which they are run; those that want the same setup stand together.
std::vector<Check> AllChecks();

// The parts of it, one for each file.
std::vector<Check> ScreenChecks();
// Scenarios of input and of faults, played through the box's own drivers.
std::vector<Check> PlayChecks();
// What every input device says arrives on the board, and lamps are lit.
std::vector<Check> InputChecks();
// Surfaces that people own, by their twins.
std::vector<Check> SurfaceChecks();
// The shipped firmware in its emulated chip, as the dial box of the box.
std::vector<Check> ChipChecks();
// Serial dial boxes of 1993, and dials on GPIO lines.
std::vector<Check> SerialBoxChecks();
std::vector<Check> DialLineChecks();
// Dials on lines of the machine's own GPIO controller, where it has one.
std::vector<Check> MachineLineChecks();
// Cables are pulled and plugged in any order.
std::vector<Check> CableChecks();
// The lip camera by our own driver.
std::vector<Check> CameraChecks();
// Foot switch, blackout and tally by a GPIO bridge.
std::vector<Check> LineChecks();
// The machine's own sound card.
std::vector<Check> SoundChecks();
// A sound card on USB.
std::vector<Check> UsbSoundChecks();
// The lip camera by libcamera's handler of USB video.
std::vector<Check> LibcameraChecks();
// A voice in a loop of the kernel.
std::vector<Check> LoopChecks();
// The devices by a Linux USB gadget within the machine.
std::vector<Check> GadgetChecks();
// From an event on the cable to the frame that shows it.
std::vector<Check> LatencyChecks();
// What well-known tools say of the devices.
std::vector<Check> ToolChecks();
// USB devices without a role stay unauthorised.
std::vector<Check> AuthorisationChecks();
// Frames a second where the bench draws for the box.
std::vector<Check> SpeedChecks();
// Without any device.
std::vector<Check> AloneChecks();
// PCs with Secure Boot start what is signed.
std::vector<Check> SecureBootChecks();
// An update by stick, in a PC with UEFI.
std::vector<Check> UpdateChecks();
// Updates to bad versions, which start all the same.
std::vector<Check> BadUpdateChecks();
// The power goes while the firmware keeps which slot is to be tried.
std::vector<Check> TryCutChecks();
// The power goes at any moment, in a PC with UEFI.
std::vector<Check> PowerCycleChecks();
// What a program leaves that crashes.
std::vector<Check> CrashChecks();
std::vector<Check> GivesWayChecks();
// Programs of the box are killed again and again, and its disk is full.
std::vector<Check> StormChecks();
// The disk has spoilt the root's show, or the stage, in such a PC.
std::vector<Check> SpoiltFileChecks();
// The box on a USB stick and on an SD card, as its only disk.
std::vector<Check> MediumChecks();
// A changed root is refused, and UEFI starts the disk.
std::vector<Check> DiskChecks();
// The PC's power button, in a show and in service.
std::vector<Check> PowerChecks();
// A data partition that is ruined is mended, and the journal of an evening is kept.
std::vector<Check> DataChecks();
// A factory reset at the box.
std::vector<Check> ResetChecks();
// Sticks that fail while they bring an update.
std::vector<Check> FailingStickChecks();
// A company's own show, which a stick brings.
std::vector<Check> StickChecks();
// Damaged file systems, as of a stick, before the kernel's drivers.
std::vector<Check> DamagedDiskChecks();
// A box with an address in a network lets a visitor calibrate its lips, while the service key is on.
std::vector<Check> DeskChecks();
// The show report of an evening.
std::vector<Check> ReportChecks();
// A box is kept on a stick, and another one becomes it.
std::vector<Check> BackupChecks();
// The screens that a box may find, and what is on its screen from power to the face.
std::vector<Check> DisplayChecks();
// Screens are plugged in and unplugged, and one shows the box's status.
std::vector<Check> OutputChecks();
// The last face comes back with the power.
std::vector<Check> LastFaceChecks();
// Input sampled late and early, on a screen with real vertical blanks.
std::vector<Check> SamplingChecks();
// Programs that hang are replaced.
std::vector<Check> HangChecks();
// The last picture stays, and a box that hangs starts again.
std::vector<Check> RecoveryChecks();
// How soon the first picture and the first face come.
std::vector<Check> StartChecks();

}  // namespace kaori::hil
