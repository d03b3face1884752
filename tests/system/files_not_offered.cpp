#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "tests/system/file_options.h"

namespace kaori::test {
namespace {

// An option or a program, and why it is not offered what is no file.
struct Reason {
  std::string_view name;
  std::string_view why;
};

// Options of the help texts that name a file and need no row above, each with the reason.
constexpr Reason kNotOffered[] = {
    {"--address-file", "it is written"},
    {"--board", "board_lost_test.cpp spoils it while the programs run"},
    {"--links", "sockets are looked for in it, and nothing is read"},
    {"--shows", "a folder that one program alone writes; stage_chosen_show_test.cpp spoils what is in it"},
    {"kaori-bench --bench-disk", "QEMU opens it as a disk"},
    {"kaori-bench --bench-kernel", "QEMU loads it"},
    {"kaori-bench --chip", "./box firmware makes it; the emulator reads it"},
    {"kaori-bench --command", "it is only printed"},
    {"kaori-bench --disk", "QEMU opens it as a disk"},
    {"kaori-bench --figures", "it is written"},
    {"kaori-bench --play", "QEMU runs by then; kaori-sim --play reads scenarios in the same way"},
    {"kaori-bench --report", "it is written"},
    {"kaori-bench --shot", "it is written"},
    {"kaori-bench --sticks", "QEMU opens what is in it as disks"},
    {"kaori-bench --usual-image", "a program that the bench starts"},
    {"kaori-benchmark --json", "it is written"},
    {"kaori-bundle --to", "it is written"},
    {"kaori-data --notice", "it is written"},
    {"kaori-data --reset", "it is written"},
    {"kaori-data --settings", "kaori-boot leaves it in memory, and no person does"},
    {"kaori-desk --box", "a socket, at which it calls; what is none is refused by the kernel"},
    {"kaori-desk --open", "it is only asked whether it is there"},
    {"kaori-evening --json", "it is written"},
    {"kaori-input --box", "a faulty one is no error: input_roles_test.cpp"},
    {"kaori-input --key", "it is written"},
    {"kaori-input --keys", "kaori-stage leaves it in memory, and no person does"},
    {"kaori-input --kiosk", "it is only asked whether it is there"},
    {"kaori-input --last-good", "it is written, and read as --box"},
    {"kaori-input --midi",
     "the kernel's folder of devices, or a simulator's sockets; browser_playing.test.mjs plays one"},
    {"kaori-input --turns", "it is written, and what is wrong in it is named: input_turns_test.cpp"},
    {"kaori-power --notice", "it is written"},
    {"kaori-power --start", "a damaged one is no error: power_last_start_test.cpp"},
    {"kaori-rehearsal --film", "it is written"},
    {"kaori-rehearsal --monitor", "it is written"},
    {"kaori-rehearsal --own", "it is read as kaori-stage reads it"},
    {"kaori-rehearsal --pictures", "it is written"},
    {"kaori-rehearsal --write-log", "it is written"},
    {"kaori-report --logs", "torn logs in it are named and left: report_test.cpp"},
    {"kaori-report --own", "what cannot be copied out of it is missing"},
    {"kaori-report --pack", "what is no show is that of no log: report_test.cpp"},
    {"kaori-shows --backup", "it is written"},
    {"kaori-shows --journal", "what cannot be read of it is missing in the support file"},
    {"kaori-shows --open", "it is only asked whether it is there"},
    {"kaori-shows --report", "it is written"},
    {"kaori-shows --root-keys", "it is read as --keys"},
    {"kaori-shows --stick", "a stick is mounted there; shows_refusal_test.cpp has what may lie on one"},
    {"kaori-shows --support", "it is written"},
    {"kaori-sim --record", "it is written"},
    {"kaori-stage --card", "it is a device, and what is none is refused by the kernel"},
    {"kaori-stage --chosen", "kaori-shows leaves it in memory, and no person does"},
    {"kaori-stage --keys", "it is written"},
    {"kaori-stage --log", "it is written"},
    {"kaori-stage --looked-at", "it is only asked whether it is there"},
    {"kaori-stage --settled", "it is only asked whether it is there"},
    {"kaori-stage --settings", "kaori-boot leaves it in memory, and no person does"},
    {"kaori-stage --still", "it is written"},
    {"kaori-stage --trial", "it is only asked whether it is there"},
    {"kaori-status --picture", "it is written"},
    {"kaori-update --argument", "it is written"},
    {"kaori-update --disk", "partitions; what is none is refused: box_disk_test.cpp"},
    {"kaori-update --last-face", "a damaged one is no picture: update_looking_test.cpp"},
    {"kaori-update --notes",
     "this program alone writes it, and a power cut may spoil it: update_power_cut_test.cpp"},
    {"kaori-update --other", "kaori-stage leaves it in memory, and no person does"},
    {"kaori-update --picture", "kaori-stage leaves it in memory, and no person does"},
    {"kaori-update --said", "it is written"},
    {"kaori-update --slot", "kaori-boot leaves it in memory, and no person does"},
    {"kaori-update --still", "of the verified root"},
    {"kaori-update --variables", "the firmware's own"},
    {"kaori-update --version", "of the verified root"},
};

// Programs without any such option, each with the reason; of the others the help is read.
constexpr Reason kWithoutFiles[] = {
    {"kaori-boot", "it has no options"},
    {"kaori-fdkeeper", "its one option is a socket"},
    {"kaori-hil-agent", "it has no options: the bench asks it over a serial line"},
    {"kaori-input-latency", "the bench alone starts it, in its own machine"},
    {"kaori-packer", "the build alone starts it, with what kaori-atelier reads"},
};

bool IsOneOf(std::span<const Reason> reasons, std::string_view name) {
  return std::ranges::find(reasons, name, &Reason::name) != reasons.end();
}

}  // namespace

bool NeedsNoRow(const std::string& program, const std::string& option) {
  return IsOneOf(kNotOffered, option) || IsOneOf(kNotOffered, fmt::format("{} {}", program, option));
}

bool NamesNoFile(const std::string& program) {
  return IsOneOf(kWithoutFiles, program);
}

}  // namespace kaori::test
