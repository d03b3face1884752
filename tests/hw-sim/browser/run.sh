#!/bin/sh
# Runs browser tests: run.sh PROGRAMS_FOLDER MODULES_FOLDER TEST.mjs... Exits 77 with a reason when they cannot run.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
programs=$1
modules=$2
shift 2

skip() {
  echo "SKIPPED: $1. The console's page was NOT tested in a browser."
  exit 77
}
chromium=${CHROMIUM:-$(command -v chromium || true)}
[ -n "$chromium" ] || skip "Chromium is missing (apt install chromium)"
command -v node >/dev/null || skip "Node is missing (apt install nodejs)"
command -v npm >/dev/null || skip "npm is missing (apt install npm)"

# The driver is installed beside the build, never into the tree, and again only when the lock file changes.
mkdir -p "$modules"
if ! cmp -s "$here/package-lock.json" "$modules/installed.json" 2>/dev/null; then
  cp "$here/package.json" "$here/package-lock.json" "$here/.npmrc" "$modules/"
  (cd "$modules" && npm ci --silent) || skip "npm ci could not fetch playwright-core"
  cp "$here/package-lock.json" "$modules/installed.json"
fi
KAORI_PROGRAMS=$programs KAORI_BROWSER_MODULES=$modules CHROMIUM=$chromium exec node --test "$@"
