#include "appliance/programs/lips/service/lip_service.h"

#include "appliance/core/board/lines.h"
#include "drivers/base/log.h"

namespace kaori::lips {

// Without service or key there is no socket, so that no desk can connect in a show; keys and the file work always.
Result<std::unique_ptr<LipService>> LipService::Open(const LipServiceOptions& options, LipReader& reader,
                                                     const board::Board& board, const Clock& clock) {
  auto writer = board.AcquireWriter<board::LipsGuide>();
  if (!writer) return tl::unexpected(writer.error());
  std::unique_ptr<LipService> service(new LipService(options, reader, board, std::move(*writer), clock));
  if (!options.service) return service;
  auto connection = DeskConnection::Open(ServicePath(board.path()));
  if (!connection) return tl::unexpected(connection.error());
  service->connection_.emplace(std::move(*connection));
  return service;
}

// The reader calls back with each picture from here on, and is told to stop when the service ends.
LipService::LipService(const LipServiceOptions& options, LipReader& reader, const board::Board& board,
                       board::Writer<board::LipsGuide> writer, const Clock& clock)
    : service_(options.service),
      reader_(reader),
      board_(board),
      writer_(std::move(writer)),
      clock_(clock),
      tuning_(options.now, options.file,
              {.apply = [&reader](const LipSettings& settings) { reader.Use(settings); },
               .free_exposure =
                   [&reader](bool free) { free ? reader.exposure().Free() : reader.exposure().Hold(); }}),
      monitor_picture_(board.path()) {
  reader_.Watch([this](const decode::Planes& planes, const LipMeter& meter, Time at) {
    const Time now = clock_.now();
    if (connection_) connection_->SendPicture(planes, meter.key(), now);
    monitor_picture_.Offer(planes, meter.key(), at, now);
    tuning_.HandlePicture(planes, meter, at, now);  // Last, since it may replace the reader's meter.
  });
}

// The reader outlives the service and must not call it any more.
LipService::~LipService() {
  reader_.Watch(nullptr);
}

// Commands first, then what is due, then the keys, so that the report at the end tells of all of them.
void LipService::Step() {
  const Time now = clock_.now();
  if (!service_) FollowKey();
  if (connection_)
    for (const Command& command : connection_->ReceiveCommands(now)) tuning_.Execute(command, now);
  tuning_.Step(now);
  auto keys = board_.Read<board::Keys>();
  // A stray key begins no calibration in a show that is locked.
  if (board_.Read<board::ShowNow>().value.locked != 0 && !guide_.active())
    keys.source = board::SourceState::kAbsent;
  guide_.Step(keys, board_.Read<board::Surface>(), reader_.meter().lips(), tuning_, now);
  ShowGuide(now);
  if (connection_) connection_->SendReport(tuning_.report(), now);
}

// A desk that was connected when the key is turned back is gone at the next step.
void LipService::FollowKey() {
  if (key_was_on_ == ServiceSwitched()) return;
  key_was_on_ = !key_was_on_;
  connection_.reset();
  if (!key_was_on_) return;
  auto connection = DeskConnection::Open(ServicePath(board_.path()));
  if (!connection) return LogWarning("no desk can calibrate the lips: {}", connection.error().message());
  connection_.emplace(std::move(*connection));
}

// Whether the key switch at the box is on.
bool LipService::ServiceSwitched() const {
  return board::IsServiceKeyOn(board_.Read<board::Lines>());
}

// The section is written at each step of a calibration, so that a reader notices by its age when the lips are
// gone.
void LipService::ShowGuide(Time now) {
  if (guide_.active())
    writer_.Write(guide_.state(service_ || ServiceSwitched()), now, board::SourceState::kLive);
  if (!guide_.active() && shown_) writer_.Write({}, now, board::SourceState::kAbsent);
  shown_ = guide_.active();
}

}  // namespace kaori::lips
