#include "appliance/programs/stage/service_modes.h"

namespace kaori::stage {

const board::Snapshot& ServiceModes::Step(const LineChecker::Frame& frame, performance::InputEvents& events) {
  if (!learner_.running()) {
    const board::Snapshot& left = checker_.Step(frame, events);
    if (checker_.running() || &left != &frame.snapshot) return left;
  }
  return learner_.Step({frame.live, frame.snapshot, frame.show, frame.now}, events);
}

}  // namespace kaori::stage
