#include "appliance/core/show/pack_cues.h"

namespace kaori::show {
namespace {

// As pack.fbs has it.
constexpr std::int32_t kSetsNoGaze = -2;
constexpr std::int32_t kOwnLayer = -1;

// A cue sets only what it names: what is absent here is absent in the pack.
std::optional<pack::CueCall> Stored(const std::optional<CueCall>& call) {
  if (!call) return std::nullopt;
  return pack::CueCall(call->index, call->in_s);
}

std::optional<pack::CueLevel> Stored(const std::optional<CueLevel>& level) {
  if (!level) return std::nullopt;
  return pack::CueLevel(level->value, level->in_s);
}

std::optional<pack::LifeAmounts> Stored(const std::optional<LifeAmounts>& life) {
  if (!life) return std::nullopt;
  return AsStored<pack::LifeAmounts>(*life);
}

// FlatBuffers' way of a struct that may be absent: a null pointer. Borrows the value.
template <class T>
const T* Address(const std::optional<T>& value) {
  return value ? &*value : nullptr;
}

// The way back, from what FlatBuffers keeps.
std::optional<CueCall> Held(const pack::CueCall* call) {
  if (call == nullptr) return std::nullopt;
  return CueCall{Narrow<std::uint16_t>(call->index()), call->in_s()};
}

std::optional<CueLevel> Held(const pack::CueLevel* level) {
  if (level == nullptr) return std::nullopt;
  return CueLevel{level->value(), level->in_s()};
}

std::optional<LifeAmounts> Held(const pack::LifeAmounts* life) {
  if (life == nullptr) return std::nullopt;
  return AsHeld<pack::LifeAmounts, LifeAmounts>(*life);
}

// The layer is narrowed as all kinds are: CheckShow refuses one that is not known.
MotionUse UseOf(const pack::Cue& stored) {
  MotionUse use{.gain = stored.motion_gain(), .from_s = stored.motion_from_s()};
  if (stored.motion_layer() != kOwnLayer)
    use.layer =
        static_cast<MotionLayer>(Narrow<std::uint8_t>(static_cast<std::uint32_t>(stored.motion_layer())));
  return use;
}

// Texts are made before the table that names them (pack_writer.cpp). A gaze has no struct that could be
// absent: a number of its own says that the cue sets none.
flatbuffers::Offset<pack::Cue> WriteCue(flatbuffers::FlatBufferBuilder& to, const Cue& cue) {
  const auto number = to.CreateString(cue.number);
  const auto name = to.CreateString(cue.name);
  const auto act = to.CreateString(cue.act);
  const auto notes = to.CreateString(cue.notes);
  const auto scene = Stored(cue.scene), face = Stored(cue.face), expression = Stored(cue.expression);
  const auto style = Stored(cue.style);
  const auto light = Stored(cue.light), present = Stored(cue.present);
  const auto life = Stored(cue.life);
  return pack::CreateCue(to, number, name, act, notes, cue.pre_wait_s, Address(scene), Address(face),
                         Address(expression), Address(style), Address(light), Address(present), cue.motion,
                         static_cast<std::uint32_t>(cue.next), static_cast<std::uint32_t>(cue.wait.person),
                         cue.wait.for_s, cue.wait.at_most_s, cue.release, Address(life),
                         cue.gaze.value_or(kSetsNoGaze), cue.lock,
                         cue.use.layer ? static_cast<std::int32_t>(*cue.use.layer) : kOwnLayer, cue.use.gain,
                         cue.use.from_s, cue.wait.target);
}

// Whether indices and numbers mean anything is for CheckShow, which sees the whole show.
Cue ReadCue(Copier& from, const pack::Cue& stored) {
  return {.number = from.Text(stored.number()),
          .name = from.Text(stored.name()),
          .act = from.Text(stored.act()),
          .notes = from.Text(stored.notes()),
          .pre_wait_s = stored.pre_wait_s(),
          .scene = Held(stored.scene()),
          .face = Held(stored.face()),
          .expression = Held(stored.expression()),
          .style = Held(stored.style()),
          .light = Held(stored.light()),
          .present = Held(stored.present()),
          .motion = stored.motion(),
          .use = UseOf(stored),
          .release = stored.release(),
          .life = Held(stored.life()),
          .gaze = stored.gaze() == kSetsNoGaze ? std::nullopt : std::optional(stored.gaze()),
          .lock = stored.lock(),
          .next = static_cast<CueNext>(Narrow<std::uint8_t>(stored.next())),
          .wait = {static_cast<CuePerson>(Narrow<std::uint8_t>(stored.wait_person())), stored.wait_for_s(),
                   stored.wait_at_most_s(), stored.wait_target()}};
}

}  // namespace

// A list that was made of the scenes is not stored: whoever loads the pack makes the same one of the same
// scenes. Tables are written before the vector that names them, as FlatBuffers wants it.
flatbuffers::Offset<pack::CueList> WriteCueList(flatbuffers::FlatBufferBuilder& to, const CueList& list) {
  std::vector<flatbuffers::Offset<pack::Cue>> offsets;
  if (!list.of_scenes)
    for (const Cue& cue : list.cues) offsets.push_back(WriteCue(to, cue));
  const auto cues = to.CreateVector(offsets);
  const pack::CueCall panic(list.panic.index, list.panic.in_s);
  return pack::CreateCueList(to, list.go_guard_s, list.goto_s, &panic, cues);
}

// Packs of before cues have none; `tracked` is computed once the whole show is read.
CueList ReadCueList(Copier& from, const pack::CueList* stored) {
  if (stored == nullptr) return {};
  return {.go_guard_s = stored->go_guard_s(),
          .goto_s = stored->goto_s(),
          .panic = Held(stored->panic()).value_or(CueCall{0, 1.0F}),
          .cues = from.Tables<Cue>(stored->cues(), ReadCue),
          .tracked = {}};
}

}  // namespace kaori::show
