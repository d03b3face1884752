// The library tinygltf, without pictures: those are decoded by what the project trusts with foreign bytes.
//
// Every file that includes the library does so through here, so that all see it with the same settings. Its
// warnings are its own.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop
