SUMMARY = "std::expected for compilers that lack it, in one header"
LICENSE = "CC0-1.0"
LIC_FILES_CHKSUM = "file://include/tl/expected.hpp;beginline=1;endline=14;md5=8e1faea3b1a803fd42d8e443df47aa6b"

# Unpacked where S points to by itself, whatever the folder in the archive is called.
SRC_URI = "${DEBIAN_MIRROR}/main/t/tl-expected/tl-expected_${PV}~dfsg.orig.tar.xz;subdir=${BP};striplevel=1"
SRC_URI[sha256sum] = "643b32aea2e13650abd7b187f9623302efaa089d6058ebf8ebcb1996024bcc65"

do_configure[noexec] = "1"
do_compile[noexec] = "1"
do_install() {
    install -Dm644 ${S}/include/tl/expected.hpp ${D}${includedir}/tl/expected.hpp
}

ALLOW_EMPTY:${PN} = "1"
BBCLASSEXTEND = "native"
