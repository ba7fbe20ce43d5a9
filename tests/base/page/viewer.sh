#!/bin/sh
# The tests of the viewer of pages, with a page of a run.
#   tests/base/page/viewer.sh UMBRA VIEWER SCENARIO FOLDER
# VIEWER: where tools/build-viewer built it; FOLDER: of the run, made anew and taken away.
set -eu
umbra=$1 viewer=$2 scenario=$3 folder=$4
[ -d "$viewer/node_modules" ] || { echo "the viewer of pages was not built: npm is missing, or could not reach its registry" >&2; exit 1; }
"$umbra" run "$scenario" --out "$folder" --no-plots >/dev/null
cd "$viewer"
code=0
UMBRA_REPORT="$folder" npm test || code=$?
rm -rf "$folder"
exit $code
