# shellcheck shell=bash
# Where this machine itself gets Debian from. Read by what unpacks Debian's packages into a folder.

# Lines of a sources.list for the named release, as mmdebstrap takes them: debian_sources bookworm
debian_sources() {
  # shellcheck disable=SC2016  # apt fills these in.
  apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
    grep -E " $1(-updates|-security)? main\$" | sort -u
}
