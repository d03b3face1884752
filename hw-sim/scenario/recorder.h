// Writes down what is done on a rig, as a scenario that does the same again.
#pragma once

#include <functional>
#include <vector>

#include "hw-sim/links/local/rig.h"
#include "hw-sim/scenario/scenario.h"

namespace kaori::sim {

// Watches the rig from construction to destruction, whoever acts on it: a page, a scenario, a test.
// Borrows it. Begin with a rig at rest: what is already held down is not written.
class Recorder {
 public:
  // `note`, if given, is called for each action as it happens, within that action.
  explicit Recorder(Rig& rig, std::function<void(const TimedAction&)> note = {});
  ~Recorder() { rig_.Watch({}); }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Everything so far; nothing where a `note` was given.
  Scenario scenario() const;

 private:
  // The watcher that the rig calls.
  void Notify(const OperatorAction& action);

  // Told of nothing any more once the recorder has gone.
  Rig& rig_;
  // The scenario's zero.
  Time start_;
  std::function<void(const TimedAction&)> note_;
  std::vector<TimedAction> actions_;
};

}  // namespace kaori::sim
