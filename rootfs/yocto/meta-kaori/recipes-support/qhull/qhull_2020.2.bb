SUMMARY = "Convex hulls and Delaunay triangulations"
LICENSE = "Qhull"
LIC_FILES_CHKSUM = "file://COPYING.txt;md5=484ee0cacf0472e8b40225b116f6296c"
NO_GENERIC_LICENSE[Qhull] = "COPYING.txt"

# Unpacked where S points to by itself, whatever the folder in the archive is called.
SRC_URI = "${DEBIAN_MIRROR}/main/q/qhull/qhull_${PV}.orig.tar.gz;subdir=${BP};striplevel=1"
SRC_URI[sha256sum] = "b5c2d7eb833278881b952c8a52d20179eab87766b00b865000469a45c1838b7e"

inherit cmake

EXTRA_OECMAKE = "-DBUILD_STATIC_LIBS=OFF"

BBCLASSEXTEND = "native"
