// What an import made of what it was given, for people.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/shape_fit.h"

namespace kaori::import {

// One shape of the artist's: what it means, and how well control points alone say it.
struct ReportedShape {
  // As the artist spells it.
  std::string name;
  // "ARKit eyeBlinkLeft"; empty: not known.
  std::string meaning;
  FitError error;
};
// One role of a show and where it came from.
struct ReportedRole {
  // As a show spells it: "jaw_open".
  std::string name;
  // "ARKit: 1 x jawOpen"; "the show's own, carried over"; "by form"; empty: nothing.
  std::string made_of;
  FitError error;
};

// Filled step by step by Import, in the order in which people read it.
struct Report {
  // What was found, counted and done, a sentence each.
  std::vector<std::string> remarks;
  // What an audience would see as wrong, a sentence each; empty where nothing is known to be.
  std::vector<std::string> doubts;
  std::vector<ReportedShape> shapes;
  std::vector<ReportedRole> roles;
  // The artist's shapes on the show's own reference face; empty without a show.
  std::vector<ReportedShape> on_show;
};

// Names of what has no meaning, and of what nothing was there for.
std::vector<std::string> UnmappedShapes(const Report& report);
std::vector<std::string> UnmappedRoles(const Report& report);

// For people: remarks, doubts, then tables of shapes with what they mean and how well control points say them
// (columns in mm: root mean square, largest, how far the shape moves), of roles with what they are made of,
// and what was not mapped.
std::string Text(const Report& report);

// The same for programs: an object with remarks and doubts (strings), shapes, roles and shapes_on_show (objects with
// name, means or made_of, rms_mm, max_mm, moves_mm; null where a name means nothing), shapes_not_mapped and
// roles_not_mapped (strings). Indented, with a newline at the end.
std::string JsonText(const Report& report);

}  // namespace kaori::import
