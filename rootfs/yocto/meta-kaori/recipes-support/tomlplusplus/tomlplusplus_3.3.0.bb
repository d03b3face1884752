SUMMARY = "A reader of TOML in headers"
LICENSE = "MIT"
LIC_FILES_CHKSUM = "file://include/toml++/toml.h;beginline=1;endline=4;md5=ccd9c77e53595152aba0218856eeb980"

# Unpacked where S points to by itself, whatever the folder in the archive is called.
SRC_URI = "${DEBIAN_MIRROR}/main/t/tomlplusplus/tomlplusplus_${PV}+ds.orig.tar.xz;subdir=${BP};striplevel=1"
SRC_URI[sha256sum] = "a143f15016090d88d72e018632efa43b1124bb62285d8c72d51d0cdb45ad787b"

do_configure[noexec] = "1"
do_compile[noexec] = "1"
do_install() {
    install -d ${D}${includedir}
    cp -R --no-dereference --preserve=mode ${S}/include/toml++ ${D}${includedir}
}

ALLOW_EMPTY:${PN} = "1"
BBCLASSEXTEND = "native"
