// What a show's script becomes when imported heads take the place of its faces.
#pragma once

#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::import {

// Buttons and keys that call a lost face call nothing; scenes show the first face instead. So do levels of
// roles, which keep their numbers. Returns how many buttons and keys have lost their call.
int DropLostFaces(show::Show& show);

// Pictures of backdrops lie among the textures of the cast: those that `to`'s scenes name, which `from` has, are added to
// `to`'s cast, and the scenes name them there. A number that `from` has not stays as it is.
void CarryPictures(const show::Show& from, show::Show& to);

// For people, what has become of the script; `lost_calls` is what DropLostFaces returned.
std::vector<std::string> WhatBecameOf(const show::Show& script, int lost_calls);

}  // namespace kaori::import
