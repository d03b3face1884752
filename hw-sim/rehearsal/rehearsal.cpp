#include "hw-sim/rehearsal/rehearsal.h"

#include <filesystem>

#include "drivers/audio/local_loudspeaker.h"
#include "drivers/audio/local_microphone.h"
#include "drivers/base/log.h"
#include "drivers/camera/local_camera.h"
#include "drivers/gpio/local_lines.h"
#include "drivers/scanout/local_screen.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPatience = 1s;  // For a device to get its slot, or for a picture to come.
// As often as stage::ScreenSession looks for a screen, and steps a stage that has none.
constexpr Duration kScreenLook = 250ms, kUnseenPeriod = 33ms;
constexpr int kHidDevices = 5;  // Dial box, two sticks, keyboard, pointer.

Result<void> MakeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder);
  return {};
}

}  // namespace

Rehearsal::~Rehearsal() = default;

Result<std::unique_ptr<Rehearsal>> Rehearsal::Open(const RehearsalOptions& options, stage::Studio& studio) {
  if (auto ok = MakeFolder(options.folder); !ok) return tl::unexpected(ok.error());
  const std::string board_file = options.folder + "/board";
  std::error_code ignored;
  std::filesystem::remove(board_file, ignored);  // A rehearsal begins from nothing.
  auto board = board::Board::Create(board_file);
  if (!board) return tl::unexpected(board.error());
  auto bus = hid::LocalHidBus::Watch(options.folder + "/links");
  if (!bus) return tl::unexpected(bus.error());
  std::unique_ptr<Rehearsal> rehearsal(new Rehearsal(options, studio, std::move(*board), std::move(*bus)));
  if (auto ok = rehearsal->OpenParts(); !ok) return tl::unexpected(ok.error());
  if (auto ok = rehearsal->Settle(); !ok) return tl::unexpected(ok.error());
  return rehearsal;
}

// The programs of the box in this process, each on the same board, as their mains put them together. Each
// gets the writers of its own sections: two programs that wanted one section would fail here as on a box.
Result<void> Rehearsal::OpenParts() {
  links_ = options_.folder + "/links";
  auto rig = Rig::Open({.folder = links_,
                        .screen_width_px = options_.width_px,
                        .screen_height_px = options_.height_px,
                        .screen_period = FromSeconds(1 / options_.hz),
                        .camera_width_px = options_.camera_width_px,
                        .camera_height_px = options_.camera_height_px,
                        .camera_period = FromSeconds(1 / options_.camera_hz)},
                       clock_);
  if (!rig) return tl::unexpected(rig.error());
  rig_ = std::move(*rig);
  for (const Program program : {Program::kInput, Program::kLips, Program::kStage})
    if (auto started = Start(program); !started) return started;
  return {};
}

void Rehearsal::End(Program program) {
  if (program == Program::kInput) input_.reset();
  if (program == Program::kStage) stage_.reset();
  if (program != Program::kLips) return;
  voice_.reset();
  lips_.reset();
}

Result<void> Rehearsal::Start(Program program) {
  switch (program) {
    case Program::kInput:
      return input_ ? Result<void>() : StartInput();
    case Program::kLips:
      return lips_ ? Result<void>() : StartLips();
    case Program::kStage:
      return stage_ ? Result<void>() : StartStage();
  }
  return {};
}

Result<void> Rehearsal::StartInput() {
  auto writers = input::InputWriters::Acquire(board_);
  if (!writers) return tl::unexpected(writers.error());
  input_ = std::make_unique<input::InputService>(
      board_, std::move(*writers), input::InputSources{{bus_.get()}, [this] { return OpenLines(); }},
      input::InputSettings{}, clock_);
  return {};
}

Result<void> Rehearsal::StartLips() {
  auto writer = board_.AcquireWriter<board::Lips>();
  if (!writer) return tl::unexpected(writer.error());
  lips_ = std::make_unique<lips::LipReader>([links = links_] { return camera::LocalCamera::Open(links); },
                                            board_, std::move(*writer), lips::LipSettings{}, clock_);
  lip_picture_.emplace(board_.path());
  lips_->Watch([this](const decode::Planes& planes, const lips::LipMeter& meter, Time at) {
    lip_picture_->Offer(planes, meter.key(), at, clock_.now());
  });
  return OpenVoice();
}

// The screen is looked for at once, as a session begins.
Result<void> Rehearsal::StartStage() {
  auto writers = stage::StageWriters::Acquire(board_);
  if (!writers) return tl::unexpected(writers.error());
  stage_ = std::make_unique<stage::Stage>(board_, std::move(*writers), studio_, clock_);
  stage_->SetLog(log_);
  stage_->CallAfterFrames(after_frame_);
  LookForScreen();
  return {};
}

void Rehearsal::SetLog(showlog::Recorder* log) {
  log_ = log;
  if (stage_) stage_->SetLog(log);
}

void Rehearsal::ShowMonitor(ports::SideDisplay* display, std::time_t began) {
  monitor_display_ = display;
  const auto time_of_day = [this, began, from = clock_.now()] {
    return began + static_cast<std::time_t>((clock_.now() - from) / 1s);
  };
  const std::filesystem::path folder = options_.folder;
  status_ = std::make_unique<stage::StageStatusDisplay>(
      board_, clock_, status::Places{folder / "settings", folder / "screens"});
  monitor_ = std::make_unique<stage::StageMonitor>(board_, clock_, studio_, *status_, time_of_day);
}

// A stage that has ended draws no monitor either.
void Rehearsal::StepMonitor() {
  if (!monitor_ || !stage_ || clock_.now() < monitor_step_) return;
  monitor_step_ = clock_.now() + stage::StageMonitor::kPeriod;
  status_->Step(stage_->screen());
  monitor_->Step(monitor_display_, {stage_->state(), stage_->wakes_at()});
}

void Rehearsal::CallAfterFrames(stage::Stage::AfterFrame after) {
  after_frame_ = std::move(after);
  if (stage_) stage_->CallAfterFrames(after_frame_);
}

// The panel answers in this thread, so that it is asked between connecting and
// greeting: a wait would wait for itself.
Result<std::unique_ptr<ports::GpioLines>> Rehearsal::OpenLines() {
  auto lines = gpio::LocalLines::Connect(links_);
  if (!lines) return tl::unexpected(lines.error());
  rig_->Pump();
  if (auto ok = (*lines)->Greet({}); !ok) return tl::unexpected(ok.error());
  return std::move(*lines);
}

Result<void> Rehearsal::OpenVoice() {
  voice::VoiceServiceSettings settings{{}, {options_.sound_delay, {}}};
  for (const show::Motion& motion : studio_.show().motions) settings.speaker.clips.push_back(motion.sound);
  auto service =
      voice::VoiceService::Acquire({[this] { return audio::LocalMicrophone::Open(links_); },
                                    [this] { return audio::LocalLoudspeaker::Open(links_, clock_); }},
                                   std::move(settings), board_, clock_);
  if (!service) return tl::unexpected(service.error());
  voice_ = std::move(*service);
  return {};
}

Result<void> Rehearsal::Settle() {
  const auto ready = [this] {
    return input_->attached_devices() == kHidDevices && rig_->screen().frames_shown() > 0 &&
           board_.Read<board::Lips>().source == board::SourceState::kLive;
  };
  // Input is empty: nobody plays before the first picture.
  for (const Time end = clock_.now() + kPatience; clock_.now() < end && !ready();) Step({});
  began_ = clock_.now();
  if (!ready()) return Fail(std::errc::timed_out, "wait until every device has its slot");
  return {};
}

// Ticks the simulated clock until the screen has flipped; a stage that never draws is given up after
// kPatience.
Result<Shown> Rehearsal::NextPicture(const Input& input) {
  const auto before = rig_->screen().frames_shown();
  for (const Time end = clock_.now() + kPatience; clock_.now() < end;) {
    Step(input);
    // A screen that went dark in the meantime has shown nothing that could be given.
    if (rig_->screen().frames_shown() != before && rig_->screen().latest()) return *rig_->screen().latest();
  }
  return Fail(std::errc::timed_out, "wait for a picture");
}

// Devices speak first, then the programs in the order in which their values travel.
void Rehearsal::Step(const Input& input) {
  clock_.Advance(options_.tick);
  if (input) input(clock_.now());
  rig_->Pump();
  WatchBoard();
  if (input_) input_->Step();
  if (lips_) lips_->Step();
  if (voice_) voice_->Step();
  if (stage_) StepStage();
  StepMonitor();
}

// None is expected while nobody has plugged one in.
void Rehearsal::LookForScreen() {
  screen_look_ = clock_.now() + kScreenLook;
  if (auto screen = scanout::LocalScreen::Open(links_)) stage_->SetScreen(std::move(*screen));
}

void Rehearsal::StepStage() {
  const Time now = clock_.now();
  if (!stage_->has_screen() && now >= screen_look_) LookForScreen();
  if (stage_->has_screen()) return stage_->Step();
  if (now < unseen_step_) return;
  unseen_step_ = now + kUnseenPeriod;
  stage_->StepUnseen();
}

// All programs share one board object: they are on the new board together.
void Rehearsal::WatchBoard() {
  const Time now = clock_.now();
  if (now < board_look_) return;
  board_look_ = now + board::Board::kHealPeriod;
  const auto healed = board_.Heal();
  if (!healed) LogWarning("{}; it is tried again", healed.error().message());
  if (healed && *healed)
    LogWarning("board {} was lost; playing on with the one that is there now", board_.path());
}

}  // namespace kaori::sim
