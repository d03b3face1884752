SUMMARY = "A reader of Wavefront's OBJ in one header"
LICENSE = "MIT"
LIC_FILES_CHKSUM = "file://LICENSE;md5=198a1c5dbf47927de8033bfac553cdd0"

# Unpacked where S points to by itself, whatever the folder in the archive is called.
SRC_URI = "${DEBIAN_MIRROR}/main/t/tinyobjloader/tinyobjloader_2.0.0~rc10+dfsg.orig.tar.xz;subdir=${BP};striplevel=1"
SRC_URI[sha256sum] = "a20c0b2aac17d91e84cd40a302d93c0c26020952269c389cdf32d8529eb8d829"

do_configure[noexec] = "1"
do_compile[noexec] = "1"
do_install() {
    install -Dm644 ${S}/tiny_obj_loader.h ${D}${includedir}/tiny_obj_loader.h
}

ALLOW_EMPTY:${PN} = "1"
BBCLASSEXTEND = "native"
