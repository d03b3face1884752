// The library's own code, in a file of its own since it takes long to compile.
#define TINYGLTF_IMPLEMENTATION
#include "appliance/authoring/model/tiny_gltf.h"
