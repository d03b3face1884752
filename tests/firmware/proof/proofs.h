// What must hold of a surface, whatever is done to it. No operating system: the host, two Cortex-M machines in QEMU, and
// builds that are wrong on purpose run the same lines.
#pragma once

#include <cstdint>

namespace kaori::proof {

struct DialProof {
  std::uint64_t edges = 0;
  std::uint64_t counts_lost = 0;
  std::uint64_t double_steps_untold = 0;
};
// Turns all dials by chance, some of them trembling on one line, and now and then one by two counts within a look. `edges` in
// all, at least.
DialProof ProveDials(std::uint64_t edges, std::uint32_t seed);

struct ButtonProof {
  std::uint64_t changes = 0;
  std::uint64_t wrong = 0;  // Edges too many or too few, and ghosts.
  std::uint32_t longest_press_looks = 0;
  std::uint32_t longest_release_looks = 0;
};
// Pushes and releases 32 buttons whose switches bounce for up to `bouncing_looks` looks, while the others stay, and spikes of
// one or two looks come by.
ButtonProof ProveButtons(std::uint32_t changes, std::uint32_t bouncing_looks, std::uint32_t seed);

struct AxisProof {
  std::uint64_t wrong =
      0;  // Values beyond the ends, at rest and not 0, or against the way that the stick goes.
  std::uint64_t reports_at_rest = 0;
  std::uint32_t longest_ms = 0;  // Until a step of the stick is told to 95 percent.
};
// Moves a stick whose converter trembles by a code, through values that are known.
AxisProof ProveAxes(std::uint32_t rounds, std::uint32_t seed);

struct ReportProof {
  std::uint64_t reports = 0;
  std::uint64_t wrong = 0;  // Sums of turns, or edges of buttons, that are not what was done.
};
// Plays a whole dial box before a host that polls as it likes.
ReportProof ProveReports(std::uint32_t looks, std::uint32_t seed);

}  // namespace kaori::proof
