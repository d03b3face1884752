// What is done on the console's page, in the language of a scenario: "dial 1 turn 0.4".
#pragma once

#include <string_view>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::console {

// Reads every line of `text` as hw-sim/scenario/reader.h has it, without times: what is done at once. Empty
// lines are none. All or nothing: a wrong line gives only an Error (invalid_argument) whose attempt names
// line, column and fault of the first one.
Result<std::vector<sim::OperatorAction>> ReadInput(std::string_view text);

}  // namespace kaori::console
