#include "appliance/core/performance/accents.h"

#include <algorithm>

#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/saccade.h"

namespace kaori::performance {
namespace {

// The voice's level is remembered in steps of this length, eleven of them: the newest and the oldest are a
// tenth of a second apart.
constexpr float kStep_s = 0.01F;
// What lies below is the room and not the voice: the first word after a pause rises from here.
constexpr float kFloor_db = -60;
// A rise by the first within a tenth of a second is an accent; one by the second raises the
// brows as far as any does.
constexpr float kRise_db = 6, kGreatRise_db = 18;
constexpr float kSmallBrow = 0.15F, kGreatBrow = 0.35F;
// From the beginning of an accent until the brows are down again, and until they are highest.
constexpr float kBrow_s = 0.3F, kBrowUp_s = 0.1F;
constexpr float kBetweenAccents_s = 0.8F;
constexpr float kNod_rad = 3 * show::kDegree;
constexpr float kNodDown_s = 0.22F, kNod_s = 0.62F;
// A phrase lasts so long at least, and is over when it has been quiet for so long.
constexpr float kPhrase_s = 0.6F, kPhraseOver_s = 0.25F;

// Up within up_s, and down again until `whole_s`; 0 before and after. Level at all three.
float Bump(float since_s, float up_s, float whole_s) {
  return since_s < up_s ? SmoothStep(since_s / up_s) : 1 - SmoothStep((since_s - up_s) / (whole_s - up_s));
}

// The level counts for all steps that the frame has ended, so that a tenth of a second is one at any rate of
// frames.
void Remember(AccentLife& life, float level_db, float dt_s) {
  life.step_s += dt_s;
  for (std::size_t n = 0; life.step_s >= kStep_s && n < life.levels_db.size(); ++n) {
    life.step_s -= kStep_s;
    std::shift_right(life.levels_db.begin(), life.levels_db.end(), 1);
    life.levels_db.front() = level_db;
  }
  life.step_s = std::min(life.step_s, kStep_s);
}

// How much louder the voice is than a tenth of a second ago.
float Rise_db(const AccentLife& life) {
  return life.levels_db.front() - life.levels_db.back();
}

// Moves a clock on. It stops at kLongSince_s, which IsValidLife asks for.
void Count(float& clock_s, float dt_s) {
  clock_s = std::min(kLongSince_s, clock_s + dt_s);
}

// Whether a phrase has just ended.
bool PhraseEnds(AccentLife& life, bool speaks, float dt_s) {
  const float quiet_before_s = life.quiet_s;
  if (speaks) {
    life.quiet_s = 0;
    Count(life.spoken_s, dt_s);
    return false;
  }
  Count(life.quiet_s, dt_s);
  if (life.quiet_s < kPhraseOver_s) return false;
  const bool ends = quiet_before_s < kPhraseOver_s && life.spoken_s >= kPhrase_s;
  life.spoken_s = 0;
  return ends;
}

}  // namespace

// A microphone that is gone counts as silence, which ends the phrase that it was in. How far the brows go is
// decided where the accent begins: a voice that rises further meanwhile does not lift them more.
Accent Accentuate(AccentLife& life, const board::Stamped<board::Voice>& voice, float dt_s) {
  const bool live = voice.source == board::SourceState::kLive;
  const bool speaks = live && voice.value.speaking != 0;
  Count(life.brow_s, dt_s);
  Count(life.nod_s, dt_s);
  Remember(life, live ? std::clamp(voice.value.level_db, kFloor_db, 0.0F) : kFloor_db, dt_s);
  if (speaks && Rise_db(life) >= kRise_db && life.brow_s >= kBetweenAccents_s) {
    const float force = (Rise_db(life) - kRise_db) / (kGreatRise_db - kRise_db);
    life.brow = Mix(kSmallBrow, kGreatBrow, std::min(1.0F, force));
    life.brow_s = 0;
  }
  if (PhraseEnds(life, speaks, dt_s)) life.nod_s = 0;
  return {life.brow * Bump(life.brow_s, kBrowUp_s, kBrow_s),
          -kNod_rad * Bump(life.nod_s, kNodDown_s, kNod_s)};
}

}  // namespace kaori::performance
