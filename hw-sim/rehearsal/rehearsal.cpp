#include "hw-sim/rehearsal/rehearsal.h"

#include <filesystem>

#include "drivers/audio/local_loudspeaker.h"
#include "drivers/audio/local_microphone.h"
#include "drivers/camera/local_camera.h"
#include "drivers/gpio/local_lines.h"
#include "drivers/scanout/local_screen.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

constexpr Duration kTick = 1ms;  // A simulated millisecond: reports leave no more often.
// In ticks: a simulated second for a device to get its slot, or for a picture to come.
constexpr int kPatience = 1000;
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
  std::unique_ptr<Rehearsal> rehearsal(new Rehearsal(std::move(*board), std::move(*bus)));
  if (auto ok = rehearsal->OpenParts(options, studio); !ok) return tl::unexpected(ok.error());
  if (auto ok = rehearsal->Settle(); !ok) return tl::unexpected(ok.error());
  return rehearsal;
}

// The programs of the box in this process, each on the same board, as their mains put them together. Each
// gets the writers of its own sections: two programs that wanted one section would fail here as on a box.
Result<void> Rehearsal::OpenParts(const RehearsalOptions& options, stage::Studio& studio) {
  links_ = options.folder + "/links";
  auto rig = Rig::Open({.folder = links_,
                        .screen_width_px = options.width_px,
                        .screen_height_px = options.height_px,
                        .screen_period = FromSeconds(1 / options.hz),
                        .camera_period = FromSeconds(1 / options.camera_hz)},
                       clock_);
  if (!rig) return tl::unexpected(rig.error());
  rig_ = std::move(*rig);
  auto input_writers = input::InputWriters::Acquire(board_);
  if (!input_writers) return tl::unexpected(input_writers.error());
  input_ = std::make_unique<input::InputService>(
      board_, std::move(*input_writers), input::InputSources{{bus_.get()}, [this] { return OpenLines(); }},
      input::InputSettings{}, clock_);
  auto lip_writer = board_.AcquireWriter<board::Lips>();
  if (!lip_writer) return tl::unexpected(lip_writer.error());
  lips_ = std::make_unique<lips::LipReader>([links = links_] { return camera::LocalCamera::Open(links); },
                                            board_, std::move(*lip_writer), lips::LipSettings{}, clock_);
  if (auto ok = OpenVoice(options, studio.show()); !ok) return ok;
  auto stage_writers = stage::StageWriters::Acquire(board_);
  if (!stage_writers) return tl::unexpected(stage_writers.error());
  stage_ = std::make_unique<stage::Stage>(board_, std::move(*stage_writers), studio, clock_);
  return {};
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

Result<void> Rehearsal::OpenVoice(const RehearsalOptions& options, const show::Show& show) {
  voice::VoiceServiceSettings settings{{}, {options.sound_delay, {}}};
  for (const show::Motion& motion : show.motions) settings.speaker.clips.push_back(motion.sound);
  auto service =
      voice::VoiceService::Acquire({[this] { return audio::LocalMicrophone::Open(links_); },
                                    [this] { return audio::LocalLoudspeaker::Open(links_, clock_); }},
                                   std::move(settings), board_, clock_);
  if (!service) return tl::unexpected(service.error());
  voice_ = std::move(*service);
  return {};
}

// The stage gets its screen last, so that its first picture is of devices that are there.
Result<void> Rehearsal::Settle() {
  auto screen = scanout::LocalScreen::Open(links_);
  if (!screen) return tl::unexpected(screen.error());
  stage_->SetScreen(std::move(*screen));
  const auto ready = [this] {
    return input_->attached_devices() == kHidDevices && rig_->screen().frames_shown() > 0 &&
           board_.Read<board::Lips>().source == board::SourceState::kLive;
  };
  // Input is empty: nobody plays before the first picture.
  for (int i = 0; i < kPatience && !ready(); ++i) Tick({});
  began_ = clock_.now();
  if (!ready()) return Fail(std::errc::timed_out, "wait until every device has its slot");
  return {};
}

// Ticks the simulated clock until the screen has flipped; a stage that never draws is given up after kPatience
// ticks.
Result<Shown> Rehearsal::NextPicture(const Input& input) {
  const auto before = rig_->screen().frames_shown();
  for (int i = 0; i < kPatience; ++i) {
    Tick(input);
    // A screen that went dark in the meantime has shown nothing that could be given.
    if (rig_->screen().frames_shown() != before && rig_->screen().latest()) return *rig_->screen().latest();
  }
  return Fail(std::errc::timed_out, "wait for a picture");
}

// Devices speak first, then the programs in the order in which their values travel.
void Rehearsal::Tick(const Input& input) {
  clock_.Advance(kTick);
  if (input) input(clock_.now());
  rig_->Pump();
  input_->Step();
  lips_->Step();
  voice_->Step();
  stage_->Step();
}

}  // namespace kaori::sim
