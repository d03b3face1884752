// Sound in and out: by the machine's own card, whose loudspeaker the bench hears, and by a loop in the kernel
// through which a voice speaks to the box.
#include <algorithm>
#include <span>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/devices/voice_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/paused_unit.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// For machines that have little of a processor.
constexpr Duration kSoundAnswer = seconds(120);
constexpr Duration kSoundLongest = seconds(120);
constexpr Duration kSilence = seconds(20);  // Longer than a voice needs to move the mouth.
// In the guest.
constexpr const char* kVoice = "/tmp/voice.wav";
constexpr int kVoiceSeconds = 4;
constexpr double kLike = 0.6;   // Of a voice that is heard; what is none stays below a third.
constexpr double kOpen = 0.25;  // How far a mouth must move.

// A card on USB and no other.
const Setup kUsbSound{.sound = false, .usb_sound = true, .width_px = 480, .height_px = 270};

// The numbers of the lines such as " 0 [Intel          ]: HDA-Intel - HDA Intel".
std::vector<std::string> CardsOf(Scene& scene, const std::string& kind) {
  std::vector<std::string> numbers;
  const auto cards = scene.target.agent().Ask("read /proc/asound/cards", kSoundAnswer);
  std::istringstream lines(cards ? *cards : "");
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string number;
    if (line.find("]: " + kind) != std::string::npos && words >> number) numbers.push_back(number);
  }
  return numbers;
}

// What the card's loudspeaker plays from now on. Its record holds all that was played since power came, also by the checks before
// and by this one before its control. Borrows the scene.
class Loudspeaker {
 public:
  explicit Loudspeaker(Scene& scene) : scene_(scene), before_(Played().size()) {}

  // How much it is like the voice (sim::Likeness); 0 where nothing was played.
  double HeardVoice() const {
    const auto played = Played();
    const auto since = std::span(played).subspan(std::min(before_, played.size()));
    return sim::Likeness(sim::SayVowels(seconds(kVoiceSeconds)), since);
  }

 private:
  // None where the card has not been opened yet.
  std::vector<std::int16_t> Played() const {
    return sim::ReadWav(SoundPath(scene_.target.machine().options())).value_or(std::vector<std::int16_t>{});
  }

  Scene& scene_;
  std::size_t before_;
};

// The box's own program hears the microphone: it goes on hearing between two looks.
Result<void> WantHearing(Scene& scene) {
  const auto there = [](const BoardView& board) { return board.voice_live && board.voice_blocks > 0; };
  const auto first = scene.target.UntilBoard(there, kSoundLongest, "see that the box hears its microphone");
  if (!first) return tl::unexpected(first.error());
  const auto more = [&](const BoardView& board) {
    return board.voice_live && board.voice_blocks > first->voice_blocks;
  };
  const auto later = scene.target.UntilBoard(more, kSoundLongest, "see that it hears more");
  if (!later) return tl::unexpected(later.error());
  return {};
}

// The control within each check: before a voice is played none is heard. The finding says how it went. Errors: invalid_argument, it
// is not heard then either.
Result<void> PlayVoice(Scene& scene, const Loudspeaker& loudspeaker, const std::string& card) {
  const double before = loudspeaker.HeardVoice();
  if (before >= kLike) return FailInput("a voice is heard before one speaks");
  // What the loudspeaker's control is called differs from card to card.
  for (const char* const control : {"Master", "PCM", "Speaker"})
    static_cast<void>(scene.Tell(fmt::format("tool amixer -q -c {} sset {} 100% unmute", card, control)));
  for (const std::string& question : {fmt::format("voice {} {}", kVoice, kVoiceSeconds),
                                      // "plughw" converts the voice's one channel to the card's two.
                                      fmt::format("tool aplay -q -D plughw:{},0 {}", card, kVoice)})
    if (auto ok = scene.Tell(question); !ok) return ok;
  const double after = loudspeaker.HeardVoice();
  scene.finding.said = fmt::format(
      "a voice played, and heard at the card's loudspeaker ({:.2f} like it; {:.2f} before)", after, before);
  return after >= kLike ? Result<void>{} : FailInput(scene.finding.said);
}

// By tools of ALSA in the guest, and by a recording of what QEMU's card was given: a card that only pretends
// to play is found.
Result<void> Sound(Scene& scene) {
  const Loudspeaker loudspeaker(scene);
  const auto cards = CardsOf(scene, "HDA-Intel");  // As QemuCommand has them: loudspeaker, microphone.
  if (cards.size() < 2) return scene.Skip("the kernel does not show both sound cards");
  if (auto ok = WantHearing(scene); !ok) return ok;
  // Nobody else may have the cards meanwhile.
  const PausedUnit others(scene, "kaori-lips.service");
  if (auto ok = scene.Tell(
          fmt::format("tool arecord -q -D hw:{},0 -d 1 -f S16_LE -r 48000 -c 2 /tmp/heard.wav", cards[1]));
      !ok)
    return ok;
  if (auto ok = PlayVoice(scene, loudspeaker, cards[0]); !ok) return ok;
  scene.finding.said = "the box hears its microphone; a second recorded; " + scene.finding.said;
  return {};
}

// It is authorised, the box's own program plays through it, and what is played is heard.
Result<void> PlayOnUsb(Scene& scene) {
  const Loudspeaker loudspeaker(scene);
  const auto cards = CardsOf(scene, "USB-Audio");
  if (cards.empty()) return FailInput("the kernel does not show the sound card on USB");
  const auto plays = [&] {
    const auto said = scene.target.agent().Ask(
        "own /usr/bin/journalctl -b --no-pager -o cat -n 200 -u kaori-lips", kSoundAnswer);
    return said && said->find("loudspeaker: playing") != std::string::npos;
  };
  if (!scene.target.Until(plays, kSoundLongest))
    return FailInput("the box plays nothing through a card on USB");
  const PausedUnit others(scene, "kaori-lips.service");
  if (auto ok = PlayVoice(scene, loudspeaker, cards[0]); !ok) return ok;
  scene.finding.said = "the box plays through a card on USB; " + scene.finding.said;
  return {};
}

// A machine of its own, since QEMU's card cannot be plugged in later.
Result<void> UsbSound(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(kUsbSound);
  if (ok) ok = PlayOnUsb(scene);
  if (ok) box.Off();
  return ok;
}

// The control: without the card nothing is played.
Result<void> NothingPlaysWithoutIt(Scene& scene) {
  PlayStrategy box(scene.target);
  Setup silent = kUsbSound;
  silent.usb_sound = false;
  auto ok = box.Play(silent);
  if (ok) ok = scene.Tell("read /proc/asound/cards");  // The agent answers: no card is no silence of its own.
  if (ok) ok = WantFoundWrong(PlayOnUsb(scene), "a card on USB is heard that is not there");
  if (ok) box.Off();
  return ok;
}

// How far the mouth went by the voice while it was watched.
struct Mouth {
  bool spoke = false;
  double least = 1, most = 0, loudest_db = -100;
  // Only while it speaks: at rest the height is that of the lips.
  void See(const BoardView& board) {
    spoke |= board.voice_speaking;
    loudest_db = std::max(loudest_db, board.voice_level_db);
    if (!board.voice_speaking) return;
    least = std::min(least, board.voice_height);
    most = std::max(most, board.voice_height);
  }
};

// Waits until the lips of the check hear the loop; what is on the board before that is the box's own lips',
// which are stopped. Who speaks into the loop before its other side is open finds no way to play into it.
Result<void> AwaitEar(Scene& scene, std::uint32_t blocks_before) {
  const auto hears = [&](const BoardView& board) {
    return board.voice_live && board.voice_blocks != blocks_before;
  };
  if (auto ok = scene.target.UntilBoard(hears, kSoundLongest, "see that the microphone is heard"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// The voice speaks into the loop, or nobody does. Seen on the board: the kernel of the bench shows the face on vkms, of which nobody has a
// picture. Errors: invalid_argument, the mouth or the loudspeaker does not follow.
Result<void> SpeakAndWatch(Scene& scene, const std::string& loop, bool speaks) {
  const Loudspeaker loudspeaker(scene);
  // What is played into one side of the loop is heard at the other.
  Result<std::string> speaker;
  if (speaks)
    speaker = scene.target.agent().Ask(fmt::format("start-tool aplay -q -D plughw:{},0,0 {}", loop, kVoice),
                                       kSoundAnswer);
  if (!speaker) return tl::unexpected(speaker.error());
  Mouth mouth;
  const auto moved = [&](const BoardView& board) {
    mouth.See(board);
    // Likeness is asked last, since it reads a file that grows.
    return mouth.spoke && mouth.most - mouth.least >= kOpen && loudspeaker.HeardVoice() >= kLike;
  };
  const auto heard = scene.target.UntilBoard(moved, speaks ? kSoundLongest : kSilence,
                                             "see the mouth follow the voice, and hear it");
  if (speaks)
    scene.finding.texts.emplace_back(
        "aplay", scene.target.agent().Ask("end " + *speaker, kSoundAnswer).value_or("it said nothing"));
  scene.finding.figures["voice_heard_likeness"] = loudspeaker.HeardVoice();
  scene.finding.said =
      fmt::format("the mouth moved from {:.2f} to {:.2f}, {:.0f} dB; at the loudspeaker {:.2f} like it",
                  mouth.least, mouth.most, mouth.loudest_db, loudspeaker.HeardVoice());
  if (!heard) return FailInput(heard.error().message() + "; " + scene.finding.said);
  return {};
}

// From a voice in the kernel's loop, by the box's own program, to the board and to the card's loudspeaker.
Result<void> VoiceOrSilence(Scene& scene, bool speaks) {
  const auto cards = CardsOf(scene, "HDA-Intel"), loops = CardsOf(scene, "Loopback");
  if (cards.empty() || loops.empty())
    return scene.Skip("this kernel has no loop of sound (snd-aloop) beside its card");
  const PausedUnit others(scene, "kaori-lips.service");
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  // Ten times as long as the voice that is compared, so that it goes on while the box is watched.
  if (auto ok = scene.Tell(fmt::format("voice {} {}", kVoice, 10 * kVoiceSeconds)); !ok) return ok;
  static_cast<void>(scene.Tell(fmt::format("tool amixer -q -c {} sset Master 100% unmute", cards[0])));
  const auto program = scene.target.agent().Ask(
      fmt::format(
          "start /usr/bin/kaori-lips --microphone hw:{},1,0 --loudspeaker hw:{},0 --sound-delay 60 --board "
          "/run/kaori/board",
          loops[0], cards[0]),
      kSoundAnswer);
  if (!program) return tl::unexpected(program.error());
  auto spoken = AwaitEar(scene, before->voice_blocks);
  if (spoken) spoken = SpeakAndWatch(scene, loops[0], speaks);
  const auto said = scene.target.agent().Ask("end " + *program, kSoundAnswer);
  scene.finding.texts.emplace_back("kaori-lips", said ? *said : said.error().message());
  return spoken;
}

Result<void> Voice(Scene& scene) {
  return VoiceOrSilence(scene, true);
}

// The control: the same, but that nobody speaks.
Result<void> SilenceIsNotFollowed(Scene& scene) {
  return WantFoundWrong(VoiceOrSilence(scene, false), "the mouth moves although nobody speaks");
}

}  // namespace

std::vector<Check> SoundChecks() {
  return {{.name = "sound",
           .sentence = "Sound goes in, and what is played is heard",
           .chosen = true,
           .run = Sound,
           .fails_without = "kaori-lips.service",
           .ends_programs = true}};
}

std::vector<Check> UsbSoundChecks() {
  return {{.name = "usb-sound",
           .sentence = "A sound card on USB plays, and what is played is heard",
           .run = UsbSound,
           .setup = kUsbSound,
           .control = NothingPlaysWithoutIt,
           .powers = true}};
}

std::vector<Check> LoopChecks() {
  return {{.name = "voice",
           .sentence = "A voice moves the mouth, and comes from the loudspeaker",
           .run = Voice,
           .setup = {.bench_kernel = true, .graphics = Graphics::kVirtio},
           .control = SilenceIsNotFollowed,
           .ends_programs = true}};
}

}  // namespace kaori::hil
