// Structures of libdrm with one owner each, and properties by their names.
#pragma once

#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstdint>
#include <memory>

#include "drivers/base/result.h"

namespace kaori::scanout {

// Calls a libdrm free function: an owner costs no more than the pointer. libdrm's structures are copies
// that the library allocated; freeing one changes nothing on the card.
template <auto kFree>
struct DrmFree {
  template <class T>
  void operator()(T* object) const {
    kFree(object);
  }
};

// Each is null where the card did not answer, as after its last file was
// closed or the driver was unbound.
using DrmResources = std::unique_ptr<drmModeRes, DrmFree<drmModeFreeResources>>;
using DrmConnector = std::unique_ptr<drmModeConnector, DrmFree<drmModeFreeConnector>>;
using DrmEncoder = std::unique_ptr<drmModeEncoder, DrmFree<drmModeFreeEncoder>>;
using DrmCrtc = std::unique_ptr<drmModeCrtc, DrmFree<drmModeFreeCrtc>>;
using DrmPlanes = std::unique_ptr<drmModePlaneRes, DrmFree<drmModeFreePlaneResources>>;
using DrmPlane = std::unique_ptr<drmModePlane, DrmFree<drmModeFreePlane>>;
using DrmProperties = std::unique_ptr<drmModeObjectProperties, DrmFree<drmModeFreeObjectProperties>>;
using DrmProperty = std::unique_ptr<drmModePropertyRes, DrmFree<drmModeFreeProperty>>;
using DrmAtomic = std::unique_ptr<drmModeAtomicReq, DrmFree<drmModeAtomicFree>>;

// A connector, a CRTC or a plane: its id and its kind (DRM_MODE_OBJECT_...). Ids are unique on a
// card and stay the same while it is there.
struct DrmObject {
  // KMS's number of the object, above 0.
  std::uint32_t id = 0;
  // DRM_MODE_OBJECT_CONNECTOR and the like.
  std::uint32_t kind = 0;
};

// A property of an object, as KMS has them: 64 bits, whose meaning the property's kind says (a
// number, an enumerator, an object's or a blob's id). KMS knows properties by ids that differ
// from card to card, and people by names.
struct DrmValue {
  std::uint32_t property = 0;  // The property's id.
  std::uint64_t value = 0;     // Its value now.
};

// Looks a property up by its name, which asks the kernel for every property of the object: not for the frame
// path. Errors: not_supported (the object has no property of this name).
Result<DrmValue> FindProperty(int card, DrmObject object, const char* name);

}  // namespace kaori::scanout
