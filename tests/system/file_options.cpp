#include "tests/system/file_options.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "tests/system/file_offers.h"

namespace kaori::test {
namespace {

std::vector<std::string> NamesOfOffers() {
  std::vector<std::string> names;
  for (const Offer& offer : Offers()) names.push_back(offer.name);
  return names;
}

// Those that hold text or bytes, which some options take for what they are.
std::vector<std::string> NamesOfRegularFiles() {
  std::vector<std::string> names = NamesOfOffers();
  for (const char* other : {"missing", "folder", "zeroes", "pipe"}) std::erase(names, other);
  return names;
}

// Of the programs that the box runs.
std::vector<FileOption> OptionsOfTheBox() {
  const std::vector<std::string> all = NamesOfOffers();
  std::vector<std::string> all_but_folder = all;  // A file cannot take a folder's name.
  std::erase(all_but_folder, "folder");
  return {
      {"input_settings", "kaori-input", {"--board", "%/board", "--links", "%", "--settings", "@"}, {"empty"}},
      // Without a certificate that can be used the desk makes another one.
      {"desk_certificate",
       "kaori-desk",
       {"--service", "--board", "%/board", "--port", "0", "--local", "--data", "%"},
       all_but_folder,
       "desk.pem"},
      // What was kept is broken: the lips play on with what is usual, and say so.
      {"lips_settings", "kaori-lips", {"--board", "%/board", "--links", "%", "--settings", "@"}, all},
      {"lips_pack", "kaori-lips", {"--board", "%/board", "--links", "%", "--pack", "@"}},
      {"lips_trust",
       "kaori-lips",
       {"--board", "%/board", "--links", "%", "--pack", "%/none", "--trust", "@"}},
      // A device whose file is faulty is not played, and the others are.
      {"input_surfaces",
       "kaori-input",
       {"--board", "%/board", "--links", "%", "--surfaces", "%"},
       all,
       "knob.toml"},
      {"surface_update", "kaori-surface", {"--port", "1-1", "--update", "@"}},
      {"surface_updates", "kaori-surface", {"--updates", "%"}, all, "dial-box.update"},
      // The show's own roles play, and it begins with its first face.
      {"stage_own",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--pack", "#", "--own", "%"},
       all,
       "roles.toml"},
      {"stage_last_face",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--own", "%", "--pack", "#", "--last-face", "@"},
       all},
      {"stage_evening",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--own", "%", "--pack", "#", "--evening", "@", "--without",
        "lips"}},
      {"stage_pack", "kaori-stage", {"--board", "%/board", "--links", "%", "--pack", "@"}},
      {"stage_rehearse", "kaori-stage", {"--rehearse", "@"}},
      {"stage_trust",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--pack", "%/none", "--trust", "@"}},
  };
}

// Of the programs that bring something onto the box, or authorise it.
std::vector<FileOption> OptionsOfWhatComes() {
  const std::vector<std::string> shows{"--shows", "%/shows", "--root-keys", "%/none", "--keys", "%/none"};
  const std::vector<std::string> update{"--version", "%/version", "--slot", "%/slot", "--notes", "%"};
  const auto with = [](std::vector<std::string> words, std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
    return words;
  };
  return {
      {"shows_install", "kaori-shows", with(shows, {"--install", "@"}), {}, "given.kaori"},
      {"shows_keep", "kaori-shows", with(shows, {"--keep", "@"}), {}, "given.kaori"},
      {"shows_diff", "kaori-shows", with(shows, {"--diff", "@"}), {}, "given.kaorishow"},
      {"shows_restore", "kaori-shows", with(shows, {"--restore", "@"}), {}, "given.kaorishow"},
      // A folder of keys is usual, and none that no key was brought to the box.
      {"shows_keys",
       "kaori-shows",
       {"--shows", "%/shows", "--root-keys", "%/none", "--keys", "@", "--install", "%/none"},
       {},
       "house.pub",
       {"missing", "folder"}},
      {"update_install",
       "kaori-update",
       with(update, {"--keys", "%/none", "--install", "@"}),
       {},
       "given.kaoriupdate"},
      // What is no key is named, and the others count.
      {"update_keys",
       "kaori-update",
       with(update, {"--keys", "%", "--install", "%/none"}),
       {},
       "house.pub",
       {"missing"}},
      // It has its answer for udev alone: the device stays out.
      {"usb_descriptors",
       "kaori-usb",
       {"look", "%/1-1", "%", "%/log"},
       {},
       "1-1/descriptors",
       NamesOfOffers()},
  };
}

// Of the programs that make updates, and that try and measure the box.
std::vector<FileOption> OptionsOfTrials() {
  return {
      {"bundle_key", "kaori-bundle", {"--key", "@", "--image", "%", "--to", "%/out"}, {}, "secret"},
      {"bundle_image",
       "kaori-bundle",
       {"--key", "%/key", "--image", "%", "--to", "%/out"},
       {},
       "root/usr/share/kaori/version"},
      {"evening_pack", "kaori-evening", {"--order", "%/play", "--pack", "@"}, {}, "given.kaori"},
      {"evening_order", "kaori-evening", {"--pack", "#", "--order", "@"}, {}, "given.order"},
      // Every text is a command line of a kernel.
      {"bench_image",
       "kaori-bench",
       {"--command", "%", "--image", "%"},
       {},
       "cmdline",
       NamesOfRegularFiles()},
      {"benchmark_pack", "kaori-benchmark", {"--only", "none", "--pack", "@"}, {}, "given.kaori"},
      {"benchmark_builds",
       "kaori-benchmark",
       {"--only", "none", "--pack", "#", "--builds", "@"},
       {},
       "builds.json"},
  };
}

// Of the programs that a maker of shows runs.
std::vector<FileOption> OptionsOfTools() {
  return {
      {"sim_play", "kaori-sim", {"--links", "%/links", "--play", "@"}, {"empty"}},
      {"sim_labels", "kaori-sim", {"--links", "%/links", "--console", "0", "--labels", "@"}},
      {"gadget_play", "kaori-gadget", {"--put", "keyboard=none", "--play", "@"}},
      {"rehearsal_pack", "kaori-rehearsal", {"--play", "%/play", "--pack", "@"}},
      {"rehearsal_play", "kaori-rehearsal", {"--pack", "%/none", "--play", "@"}},
      {"rehearsal_log", "kaori-rehearsal", {"--pack", "%/none", "--log", "@"}},
      {"atelier_report", "kaori-atelier", {"report", "%/none", "@"}},
      {"status_board", "kaori-status", {"--settings", "%", "--board", "@"}},
      {"atelier_info", "kaori-atelier", {"info", "@"}},
      {"atelier_diff", "kaori-atelier", {"diff", "@", "@"}},
      {"atelier_labels", "kaori-atelier", {"labels", "@", "%/labels.json"}},
      {"atelier_keys", "kaori-atelier", {"keys", "@", "%/keys"}},
      {"atelier_sign", "kaori-atelier", {"pack", "%", "%/out", "--sign", "@"}},
      {"atelier_show", "kaori-atelier", {"check", "%"}, {}, "show.toml"},
      {"atelier_cast", "kaori-atelier", {"check", "%"}, {}, "cast.toml"},
      {"atelier_import_gltf", "kaori-atelier", {"import", "@", "--out", "%/out"}, {}, "head.gltf"},
      {"atelier_import_obj", "kaori-atelier", {"import", "@", "--out", "%/out"}, {}, "head.obj"},
  };
}

}  // namespace

std::vector<FileOption> FileOptions() {
  std::vector<FileOption> options = OptionsOfTheBox();
  for (auto more : {OptionsOfWhatComes(), OptionsOfTrials(), OptionsOfTools()})
    std::ranges::move(more, std::back_inserter(options));
  return options;
}

}  // namespace kaori::test
