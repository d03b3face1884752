#include "hw-sim/console/editor_watch.h"

#include <utility>

namespace kaori::console {

void EditorWatch::Follow(const Seen& now) {
  const Seen before = std::exchange(before_, now);
  const bool died = before.screen_drawn && !now.screen_drawn && now.screen_plugged;
  // Nobody hears Tab where no program has the keyboard open.
  const bool pushed = now.tab_held && !before.tab_held && now.keyboard_heard;
  if (died) {
    open_ = false;
  } else if (pushed) {
    open_ = !open_;
  }
}

}  // namespace kaori::console
