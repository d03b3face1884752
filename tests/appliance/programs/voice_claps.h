// Claps of the lips: a mouth that opens the moment its voice sounds, and how far apart picture and
// loudspeaker are in the end. On any clock.
#pragma once

#include <string>
#include <vector>

#include "appliance/programs/stage/studio.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::tests {

// Of one clap, by picture and loudspeaker alone.
struct Clap {
  double picture_ms =
      0;  // From the lips half open to the picture half open, which stands half a period more.
  double first_frame_ms = 0;  // From the lips half open to the first picture that is more than half open.
  double sound_ms = 0;        // From the voice's onset to the loudspeaker's.
  double apart_ms() const { return sound_ms - picture_ms; }
};

struct ClapReport {
  std::vector<Clap> claps;
  double lips_age_ms = 0;
  double delay_ms = 0;
  double mean_apart_ms() const;
  double median_apart_ms() const;
  double worst_apart_ms() const;  // Of either sign, without the sign.
};

// The operator who claps, and the one in the audience who looks and listens. Nothing but the mouth may move
// her.
class Claps {
 public:
  // The first clap is at `begin`. Borrows the rig.
  Claps(sim::Rig& rig, Time begin, int count) : rig_(rig), begin_(begin), count_(count) {}

  // Moves lips and voice to where they are at `now`.
  void Move(Time now);

  // Looks at the screen and listens; once a frame or more often.
  void Watch();

  Time end() const;                    // The last clap has been seen and heard.
  std::vector<Clap> Measured() const;  // Of those that were both seen and heard.

 private:
  struct Frame {
    Time at{};
    double change = 0;  // From the picture of the shut mouth.
  };
  Time At(int number) const;  // When clap `number` is half open, and its voice sounds.
  bool Measure(Time truth, Clap& clap) const;

  sim::Rig& rig_;
  Time begin_;
  int count_;
  bool sounding_ = false;
  std::uint64_t shown_ = 0;
  std::vector<std::uint8_t> shut_;
  std::vector<Frame> frames_;
  std::vector<Time> onsets_;  // Of the loudspeaker's sound, after at least 100 ms of silence.
  Time loud_at_{};
};

struct ClapOptions {
  double camera_hz = 60;
  double screen_hz = 60;
  int claps = 6;
  bool covered = false;  // A hand before the lens: the voice alone moves the mouth.
  double microphone_ppm = 0, loudspeaker_ppm = 0;
};

// In a rehearsal: waits until what is measured stands, and claps. Errors: those of
// the rehearsal.
Result<ClapReport> ClapIn(const std::string& folder, stage::Studio& studio, const ClapOptions& options);

}  // namespace kaori::tests
