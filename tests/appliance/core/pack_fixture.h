// A folder of its own for a test's packs, and a small show to put into one.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "appliance/core/show/pack.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {

inline show::Show SmallShow() {
  show::Show show;
  show.name = "small";
  show.cast = MakeSyntheticCast({.columns = 16, .rows = 12});
  show.cast.textures = {{2, 2, std::vector<std::uint8_t>(16, 200)}};
  show.buttons[3] = {show::CallKind::kFace, 2};
  show.second_buttons[4] = {show::CallKind::kExpression, 1, show::CallMode::kToggle};
  show.stick_buttons[show::kStickButtonCount + 1] = {show::CallKind::kGoTo, 1};
  show.keys = {{0x14, {show::CallKind::kStyle, 1}},
               {0x15, {show::CallKind::kFace, 1, show::CallMode::kMomentary}}};
  show.face_fades = {{}, {.in_s = 0, .out_s = 90, .curve = show::FadeCurve::kSlowEnd}};
  show.scenes.resize(1);
  show.scenes[0].name = "opening";
  show.scenes[0].backdrop = {{0.1F, 0.2F, 0.3F}, {}, scene::BackdropKind::kPicture, {0.5F, 0.4F, 0.3F}, 0};
  show.cast.faces[2].surface.print = 0.75F;
  show.cast.faces[2].surface.folds = 0.5F;
  show.cast.faces[2].eye_surface.white = {0.1F, 0.2F, 0.3F};
  show.cast.faces[2].eye_surface.glow = 0.5F;
  show.cast.faces[2].outgrowth_kind = 1;
  show.cast.faces[2].withdrawn = {{0, 0.01F, 0}};
  show.cast.faces[2].hang_arms_m = {{0.02F, 0.03F}};
  show.cast.topology.outgrowth = {7};
  show.motions = {{"nod", 0x1E, {{show::MotionTarget::kHeadPitch, 0, {{0, 0}, {0.5F, 0.3F}, {1, 0}}}}}};
  show.motions[0].sound = {2, {1, -1, 32767, -32768}};
  show.channels.brow_frown = 4;
  show.gaze_targets = {{show::kHouseName, {0, 0, 5}}, {"seat 12", {1, -0.5F, 6}}};
  show.scenes[0].life = {0.5F, 0, 1, 1, 2};
  show.scenes[0].gaze = 1;
  show.cue_list.goto_s = 2;
  show.cue_list.cues = {
      {.number = "1", .name = "opening", .notes = "with the drum", .scene = show::CueCall{0, 3.0F}},
      {.number = "1.5",
       .pre_wait_s = 0.5F,
       .light = show::CueLevel{0.25F, 1.0F},
       .motion = 0,
       .life = show::LifeAmounts{show::kKeepsLife, 0.5F, show::kKeepsLife, 1, 0},
       .gaze = show::kNoTarget,
       .lock = true,
       .wait = {show::CuePerson::kVoiceQuiet, 1, 20}}};
  show.lobby = show::Lobby{.cue = 1,
                           .greetings = {{"ja", 0}, {"en-GB", 0}},
                           .stays = {{"", 0}},
                           .goodbyes = {{"fr", 0}},
                           .visitor = 1,
                           .arrive_s = 0.5F,
                           .leave_s = 5,
                           .stuck_s = 900,
                           .stay_s = 30,
                           .sleep_s = 90,
                           .sleep_light = 0.25F,
                           .hand_back_s = 300,
                           .hours = {{600, 900}, {9000, 10'100}}};
  show.roles.handover_s = 0.5F;
  show.roles.mixes = {{show::CallKind::kExpression, 2}};
  show.roles.roles[1].maps[0].points = {{0, 0}, {0.5F, 0.25F}, {1, 1}};
  show.roles.roles[2].maps.back().takeover = show::Takeover::kScale;
  return show;
}

class PackTest : public ::testing::Test {
 protected:
  PackTest() {
    std::string name = (std::filesystem::temp_directory_path() / "kaori-pack-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~PackTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Write(const std::vector<std::uint8_t>& bytes) const {
    std::filesystem::path file = folder_ / "show.kaori";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

  // The name of the show that a pack holds; what is wrong with it, if it cannot be loaded.
  static std::string NameIn(const std::filesystem::path& file) {
    const auto show = show::LoadPack(file);
    return show ? show->name : show.error().message();
  }

  // How many files the folder holds.
  std::ptrdiff_t Files() const { return std::distance(std::filesystem::directory_iterator(folder_), {}); }

  std::filesystem::path folder_;
};

}  // namespace kaori::tests
