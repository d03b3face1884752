#include "appliance/authoring/import/role_table.h"

#include <array>

namespace kaori::import {
namespace {

using enum NameStyle;

// Apple, ARFaceAnchor.BlendShapeLocation: 52 names, in alphabetical order. Left and right
// are the character's.
constexpr std::array<std::string_view, 52> kArkitNames{
    "browDownLeft",      "browDownRight",      "browInnerUp",         "browOuterUpLeft",
    "browOuterUpRight",  "cheekPuff",          "cheekSquintLeft",     "cheekSquintRight",
    "eyeBlinkLeft",      "eyeBlinkRight",      "eyeLookDownLeft",     "eyeLookDownRight",
    "eyeLookInLeft",     "eyeLookInRight",     "eyeLookOutLeft",      "eyeLookOutRight",
    "eyeLookUpLeft",     "eyeLookUpRight",     "eyeSquintLeft",       "eyeSquintRight",
    "eyeWideLeft",       "eyeWideRight",       "jawForward",          "jawLeft",
    "jawOpen",           "jawRight",           "mouthClose",          "mouthDimpleLeft",
    "mouthDimpleRight",  "mouthFrownLeft",     "mouthFrownRight",     "mouthFunnel",
    "mouthLeft",         "mouthLowerDownLeft", "mouthLowerDownRight", "mouthPressLeft",
    "mouthPressRight",   "mouthPucker",        "mouthRight",          "mouthRollLower",
    "mouthRollUpper",    "mouthShrugLower",    "mouthShrugUpper",     "mouthSmileLeft",
    "mouthSmileRight",   "mouthStretchLeft",   "mouthStretchRight",   "mouthUpperUpLeft",
    "mouthUpperUpRight", "noseSneerLeft",      "noseSneerRight",      "tongueOut"};
// VRM 1.0, VRMC_vrm, expressions.preset, in the specification's order.
constexpr std::array<std::string_view, 18> kVrm1Names{
    "happy", "angry", "sad",       "relaxed",    "surprised", "aa",       "ih",       "ou",        "ee",
    "oh",    "blink", "blinkLeft", "blinkRight", "lookUp",    "lookDown", "lookLeft", "lookRight", "neutral"};
// VRM 0.x, blendShapeMaster, presetName.
// Its word "unknown" is left out: it marks a preset that means nothing.
constexpr std::array<std::string_view, 17> kVrm0Names{
    "neutral", "a",   "i",      "u",        "e",        "o",         "blink",   "joy",    "angry",
    "sorrow",  "fun", "lookup", "lookdown", "lookleft", "lookright", "blink_l", "blink_r"};
// Oculus (Meta) lip sync, in the order of its visemes: silence first. Spelled as avatars of VRChat and Ready
// Player Me spell them.
constexpr std::array<std::string_view, 15> kVisemeNames{
    "viseme_sil", "viseme_PP", "viseme_FF", "viseme_TH", "viseme_DD", "viseme_kk", "viseme_CH", "viseme_SS",
    "viseme_nn",  "viseme_RR", "viseme_aa", "viseme_E",  "viseme_I",  "viseme_O",  "viseme_U"};
// Words that artists use where they follow nobody's standard, spelled as this project's roles are
// where one fits.
constexpr std::array<std::string_view, 26> kPlainNames{"blink_left",
                                                       "blink_right",
                                                       "blink",
                                                       "brow_up_left",
                                                       "brow_up_right",
                                                       "brow_up",
                                                       "brow_down",
                                                       "brow_frown",
                                                       "eyes_wide",
                                                       "lids_up",
                                                       "lids_down",
                                                       "jaw_open",
                                                       "mouth_open",
                                                       "tongue_out",
                                                       "smile",
                                                       "smile_left",
                                                       "smile_right",
                                                       "frown",
                                                       "angry",
                                                       "sad",
                                                       "surprised",
                                                       "happy",
                                                       "pucker",
                                                       "a",
                                                       "o",
                                                       "e"};

// What each shape does for a role. Weights below 1 are for shapes that help others, or would overdo:
// browInnerUp is both brows at once, so each brow gets half of it; an ARKit jaw wide open is more than any
// vowel, so "a" is 0.7 of it.
//
// Roles that are missing for a style cannot be made of it: VRM has no brows or lids of their own.
constexpr std::array kTable{
    RoleEntry{"blink_left", kArkit, "eyeBlinkLeft", 1},
    RoleEntry{"blink_left", kVrm1, "blinkLeft", 1},
    RoleEntry{"blink_left", kVrm0, "blink_l", 1},
    RoleEntry{"blink_left", kPlain, "blink_left", 1},
    RoleEntry{"blink_right", kArkit, "eyeBlinkRight", 1},
    RoleEntry{"blink_right", kVrm1, "blinkRight", 1},
    RoleEntry{"blink_right", kVrm0, "blink_r", 1},
    RoleEntry{"blink_right", kPlain, "blink_right", 1},
    RoleEntry{"brow_up_left", kArkit, "browOuterUpLeft", 1},
    RoleEntry{"brow_up_left", kArkit, "browInnerUp", 0.5F},
    RoleEntry{"brow_up_left", kPlain, "brow_up_left", 1},
    RoleEntry{"brow_up_right", kArkit, "browOuterUpRight", 1},
    RoleEntry{"brow_up_right", kArkit, "browInnerUp", 0.5F},
    RoleEntry{"brow_up_right", kPlain, "brow_up_right", 1},
    RoleEntry{"brow_frown", kArkit, "browDownLeft", 1},
    RoleEntry{"brow_frown", kArkit, "browDownRight", 1},
    RoleEntry{"brow_frown", kPlain, "brow_frown", 1},
    RoleEntry{"brow_frown", kPlain, "brow_down", 1},
    RoleEntry{"lids_up", kArkit, "eyeWideLeft", 1},
    RoleEntry{"lids_up", kArkit, "eyeWideRight", 1},
    RoleEntry{"lids_up", kPlain, "lids_up", 1},
    RoleEntry{"lids_up", kPlain, "eyes_wide", 1},
    RoleEntry{"lids_down", kArkit, "eyeLookDownLeft", 1},
    RoleEntry{"lids_down", kArkit, "eyeLookDownRight", 1},
    RoleEntry{"lids_down", kPlain, "lids_down", 1},
    RoleEntry{"jaw_open", kArkit, "jawOpen", 1},
    RoleEntry{"jaw_open", kPlain, "jaw_open", 1},
    RoleEntry{"jaw_open", kPlain, "mouth_open", 1},
    RoleEntry{"tongue_out", kArkit, "tongueOut", 1},
    RoleEntry{"tongue_out", kPlain, "tongue_out", 1},
    RoleEntry{"smile", kArkit, "mouthSmileLeft", 1},
    RoleEntry{"smile", kArkit, "mouthSmileRight", 1},
    RoleEntry{"smile", kArkit, "cheekSquintLeft", 0.5F},
    RoleEntry{"smile", kArkit, "cheekSquintRight", 0.5F},
    RoleEntry{"smile", kVrm1, "happy", 1},
    RoleEntry{"smile", kVrm0, "joy", 1},
    RoleEntry{"smile", kPlain, "smile", 1},
    RoleEntry{"angry", kArkit, "browDownLeft", 1},
    RoleEntry{"angry", kArkit, "browDownRight", 1},
    RoleEntry{"angry", kArkit, "noseSneerLeft", 0.6F},
    RoleEntry{"angry", kArkit, "noseSneerRight", 0.6F},
    RoleEntry{"angry", kArkit, "mouthFrownLeft", 0.5F},
    RoleEntry{"angry", kArkit, "mouthFrownRight", 0.5F},
    RoleEntry{"angry", kArkit, "mouthPressLeft", 0.6F},
    RoleEntry{"angry", kArkit, "mouthPressRight", 0.6F},
    RoleEntry{"angry", kVrm1, "angry", 1},
    RoleEntry{"angry", kVrm0, "angry", 1},
    RoleEntry{"angry", kPlain, "angry", 1},
    RoleEntry{"sad", kArkit, "mouthFrownLeft", 1},
    RoleEntry{"sad", kArkit, "mouthFrownRight", 1},
    RoleEntry{"sad", kArkit, "browInnerUp", 1},
    RoleEntry{"sad", kVrm1, "sad", 1},
    RoleEntry{"sad", kVrm0, "sorrow", 1},
    RoleEntry{"sad", kPlain, "sad", 1},
    RoleEntry{"surprised", kArkit, "browInnerUp", 1},
    RoleEntry{"surprised", kArkit, "browOuterUpLeft", 1},
    RoleEntry{"surprised", kArkit, "browOuterUpRight", 1},
    RoleEntry{"surprised", kArkit, "eyeWideLeft", 1},
    RoleEntry{"surprised", kArkit, "eyeWideRight", 1},
    RoleEntry{"surprised", kArkit, "jawOpen", 0.4F},
    RoleEntry{"surprised", kVrm1, "surprised", 1},
    RoleEntry{"surprised", kPlain, "surprised", 1},
    // The five vowels, in the order of the Japanese syllabary.
    RoleEntry{"a", kVrm1, "aa", 1},
    RoleEntry{"a", kVrm0, "a", 1},
    RoleEntry{"a", kViseme, "viseme_aa", 1},
    RoleEntry{"a", kArkit, "jawOpen", 0.7F},
    RoleEntry{"a", kPlain, "a", 1},
    RoleEntry{"i", kVrm1, "ih", 1},
    RoleEntry{"i", kVrm0, "i", 1},
    RoleEntry{"i", kViseme, "viseme_I", 1},
    RoleEntry{"i", kArkit, "mouthStretchLeft", 0.8F},
    RoleEntry{"i", kArkit, "mouthStretchRight", 0.8F},
    RoleEntry{"i", kArkit, "jawOpen", 0.1F},
    RoleEntry{"u", kVrm1, "ou", 1},
    RoleEntry{"u", kVrm0, "u", 1},
    RoleEntry{"u", kViseme, "viseme_U", 1},
    RoleEntry{"u", kArkit, "mouthPucker", 0.9F},
    RoleEntry{"u", kArkit, "jawOpen", 0.1F},
    RoleEntry{"e", kVrm1, "ee", 1},
    RoleEntry{"e", kVrm0, "e", 1},
    RoleEntry{"e", kViseme, "viseme_E", 1},
    RoleEntry{"e", kArkit, "mouthStretchLeft", 0.5F},
    RoleEntry{"e", kArkit, "mouthStretchRight", 0.5F},
    RoleEntry{"e", kArkit, "jawOpen", 0.35F},
    RoleEntry{"e", kPlain, "e", 1},
    RoleEntry{"o", kVrm1, "oh", 1},
    RoleEntry{"o", kVrm0, "o", 1},
    RoleEntry{"o", kViseme, "viseme_O", 1},
    RoleEntry{"o", kArkit, "mouthFunnel", 0.7F},
    RoleEntry{"o", kArkit, "jawOpen", 0.4F},
    RoleEntry{"o", kPlain, "o", 1},
    // Lips that touch (p, b, m), and a lower lip under the upper teeth (f, v): VRM has no presets for
    // consonants.
    RoleEntry{"m", kViseme, "viseme_PP", 1},
    RoleEntry{"m", kArkit, "mouthPressLeft", 0.8F},
    RoleEntry{"m", kArkit, "mouthPressRight", 0.8F},
    RoleEntry{"f", kViseme, "viseme_FF", 1},
    RoleEntry{"f", kArkit, "mouthRollLower", 0.8F},
    RoleEntry{"f", kArkit, "mouthUpperUpLeft", 0.3F},
    RoleEntry{"f", kArkit, "mouthUpperUpRight", 0.3F},
    // The corners of a mouth's range, how far open by how wide: no other style has shapes for all of them.
    RoleEntry{"mouth_shut_narrow", kArkit, "mouthPucker", 0.7F},
    RoleEntry{"mouth_shut_narrow", kPlain, "pucker", 1},
    RoleEntry{"mouth_shut_wide", kArkit, "mouthStretchLeft", 0.9F},
    RoleEntry{"mouth_shut_wide", kArkit, "mouthStretchRight", 0.9F},
    RoleEntry{"mouth_open_narrow", kArkit, "mouthFunnel", 0.6F},
    RoleEntry{"mouth_open_narrow", kArkit, "jawOpen", 0.7F},
    RoleEntry{"mouth_open_wide", kArkit, "jawOpen", 0.7F},
    RoleEntry{"mouth_open_wide", kArkit, "mouthStretchLeft", 0.7F},
    RoleEntry{"mouth_open_wide", kArkit, "mouthStretchRight", 0.7F},
};

}  // namespace

std::span<const RoleEntry> RoleTable() {
  return kTable;
}

std::span<const std::string_view> NamesOf(NameStyle style) {
  switch (style) {
    case kArkit:
      return kArkitNames;
    case kVrm1:
      return kVrm1Names;
    case kVrm0:
      return kVrm0Names;
    case kViseme:
      return kVisemeNames;
    case kPlain:
      return kPlainNames;
  }
  return {};
}

}  // namespace kaori::import
