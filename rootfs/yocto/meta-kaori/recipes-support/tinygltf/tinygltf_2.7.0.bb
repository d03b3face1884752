SUMMARY = "A reader of glTF in one header"
LICENSE = "MIT"
LIC_FILES_CHKSUM = "file://LICENSE;md5=82f6e601fc2fd27cbf55d6f5f176d017"

DEPENDS = "nlohmann-json"
# Unpacked where S points to by itself, whatever the folder in the archive is called.
SRC_URI = "${DEBIAN_MIRROR}/main/t/tinygltf/tinygltf_${PV}+dfsg.orig.tar.xz;subdir=${BP};striplevel=1"
SRC_URI[sha256sum] = "d55bdecdc258be72041da3d7f5c8fd9faa0a93ad6cb42ff6893c82be713626d2"

do_configure[noexec] = "1"
do_compile[noexec] = "1"
# Debian's archive leaves out the copy of nlohmann-json that the header would read from beside itself.
do_install() {
    install -Dm644 ${S}/tiny_gltf.h ${D}${includedir}/tiny_gltf.h
    sed -i -e 's|#include "json.hpp"|#include <nlohmann/json.hpp>|' ${D}${includedir}/tiny_gltf.h
}

ALLOW_EMPTY:${PN} = "1"
BBCLASSEXTEND = "native"
