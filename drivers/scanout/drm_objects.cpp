#include "drivers/scanout/drm_objects.h"

#include <fmt/format.h>

#include <cstring>

namespace kaori::scanout {

Result<DrmValue> FindProperty(int card, DrmObject object, const char* name) {
  // Names are compared once for each object and property: KmsKernel keeps the ids.
  const DrmProperties all(drmModeObjectGetProperties(card, object.id, object.kind));
  for (std::uint32_t i = 0; all && i < all->count_props; ++i) {
    const DrmProperty property(drmModeGetProperty(card, all->props[i]));
    if (property && std::strcmp(property->name, name) == 0)
      return DrmValue{all->props[i], all->prop_values[i]};
  }
  return Fail(std::errc::not_supported,
              fmt::format("find the property {} of the screen's object {}", name, object.id));
}

}  // namespace kaori::scanout
