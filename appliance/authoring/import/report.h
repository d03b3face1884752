// What an import made of what it was given, for people.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/shape_fit.h"

namespace kaori::import {

struct ReportedShape {
  std::string name;
  std::string meaning;  // "ARKit eyeBlinkLeft"; empty: not known.
  FitError error;
};
struct ReportedRole {
  std::string name;
  std::string made_of;  // "ARKit: 1 x jawOpen"; "the show's own, carried over"; empty: nothing.
  FitError error;
};

struct Report {
  std::vector<std::string> remarks;
  std::vector<ReportedShape> shapes;
  std::vector<ReportedRole> roles;
  std::vector<ReportedShape> on_show;  // The artist's shapes on the show's own reference face.
};

// Names of what has no meaning, and of what nothing was there for.
std::vector<std::string> UnmappedShapes(const Report& report);
std::vector<std::string> UnmappedRoles(const Report& report);

// For people: tables of shapes with what they mean and how well control points say them, of roles with what
// they are made of, and what was not mapped.
std::string Text(const Report& report);

// The same for programs: an object with remarks, shapes, roles, shapes_on_show, shapes_not_mapped,
// roles_not_mapped.
std::string JsonText(const Report& report);

}  // namespace kaori::import
