#include "appliance/programs/update/service.h"

#include <array>
#include <utility>

#include "appliance/programs/update/trial.h"
#include "drivers/base/log.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

constexpr float kThousandths = 1000;

Answer AnswerOf(const Progress& progress) {
  return {progress.message, progress.version, static_cast<std::uint32_t>(progress.done * kThousandths),
          progress.detail};
}

}  // namespace

void UpdateService::Step(Time now) {
  if (!client_.valid()) {
    auto peer = AcceptPeer(listener_.get());
    if (peer) client_ = std::move(*peer);
  }
  if (client_.valid()) Hear();
  if (installation_) StepInstallation();
  if (client_.valid() || !busy_at_) busy_at_ = now;
}

// A client that is gone ends what it asked for: the key was turned back, or kaori-shows has ended.
void UpdateService::Hear() {
  std::array<std::uint8_t, kLongestPacket_bytes> bytes{};
  auto packet = ReceivePacket(client_.get(), bytes);
  if (packet)
    return Handle({reinterpret_cast<const char*>(bytes.data()), packet->bytes},
                  std::move(packet->descriptor));
  if (packet.error().cause == std::errc::resource_unavailable_try_again) return;
  if (installation_) LogWarning("the update is given up: whoever asked for it is gone");
  installation_.reset();
  disk_.reset();
  client_.reset();
}

void UpdateService::Handle(std::string_view request, UniqueFd file) {
  said_.reset();
  if (request == kLook) return Look(std::move(file));
  if (request == kInstall) return Begin(std::move(file));
  if (request == kRestart) return Restart();
  const auto choice = box_.open_choice();
  if (!choice) return Say({Message::kOtherLayout, 0, 0, choice.error().message()});
  const Outcome found = AfterStart(**choice, notes_);
  Say({found.message, found.version, 0, found.detail});
}

void UpdateService::Look(UniqueFd file) {
  const auto source = SourceOf(std::move(file));
  if (!source) return Say({MessageOf(source.error()), 0, 0, source.error().message()});
  const auto manifest = ReadManifest(**source);
  if (!manifest) return Say({MessageOf(manifest.error()), 0, 0, manifest.error().message()});
  const Message judged = Judge(*manifest, box_.running, box_.keys());
  Say({judged, manifest->version, 0, judged == Message::kFits ? manifest->news : ""});
}

// Nothing is written while the running system is tried itself: the other slot is the one that it falls back to.
void UpdateService::Begin(UniqueFd file) {
  installation_.reset();
  disk_.reset();
  auto source = SourceOf(std::move(file));
  if (!source) return Say({MessageOf(source.error()), 0, 0, source.error().message()});
  const auto choice = box_.open_choice();
  const auto trial = choice ? ports::IsTrial(**choice) : Result<bool>(tl::unexpected(choice.error()));
  if (!trial) return Say({Message::kOtherLayout, 0, 0, trial.error().message()});
  if (*trial) return Say({Message::kTrialRuns});
  auto disk = box_.open_disk();
  if (!disk) return Say({Message::kOtherLayout, 0, 0, disk.error().message()});
  disk_ = std::move(*disk);
  installation_.emplace(
      std::move(*source), box_.keys(), box_.running,
      OtherSlot{*disk_->root, *disk_->verity, *disk_->boot, disk_->kernel_at, disk_->kernel_bytes}, notes_);
  Say(AnswerOf(installation_->progress()));
}

void UpdateService::Restart() {
  const auto choice = box_.open_choice();
  if (!choice) return Say({Message::kOtherLayout, 0, 0, choice.error().message()});
  const Outcome begun = TryWhatIsThere(**choice, notes_, box_.running);
  Say({begun.message, begun.version, 0, begun.detail});
  if (begun.message == Message::kRestarts) box_.restart();
}

void UpdateService::StepInstallation() {
  if (box_.may_work && !box_.may_work()) return;
  Say(AnswerOf(installation_->Step()));
  if (!installation_->ended()) return;
  installation_.reset();
  disk_.reset();
}

// A message that is new is logged; how far the work is, is not. An answer that the client does not read in time is
// followed by the next one.
void UpdateService::Say(const Answer& answer) {
  if (said_ == answer) return;
  const bool is_new = !said_ || said_->message != answer.message;
  said_ = answer;
  if (is_new) {
    const std::string line = update::Say(answer.message, Language::kEnglish, answer.version, answer.detail);
    IsRefusal(answer.message) ? LogWarning("{}", line) : Log("{}", line);
  }
  if (auto sent = SendPacket(client_.get(), AsBytes(Format(answer))); !sent && answer.is_last())
    LogWarning("{}", sent.error().message());
}

}  // namespace kaori::update
