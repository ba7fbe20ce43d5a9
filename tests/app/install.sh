#!/bin/sh
# An installed tree works wherever it is moved to, from its own files alone: installs under DESTDIR and
# a prefix, moves the tree, and runs the program from there.
#   install.sh CMAKE BUILD_FOLDER C_COMPILER SOURCE_FOLDER
set -eu
cmake=$1 build=$2 cc=$3 source=$4
folder=$(mktemp -d "${TMPDIR:-/tmp}/umbra-install-XXXXXX")
trap 'rm -rf "$folder"' EXIT
unset UMBRA_DATA
fail() { echo "install: $*" >&2; exit 1; }
expect() { # text, command...: the command succeeds and prints the text
  text=$1
  shift
  "$@" >"$folder/said" 2>&1 || { cat "$folder/said"; fail "$* failed"; }
  grep -qF -- "$text" "$folder/said" || { cat "$folder/said"; fail "$* does not print '$text'"; }
}

DESTDIR=$folder/stage "$cmake" --install "$build" --prefix /opt/umbra >"$folder/log" 2>&1 ||
  { cat "$folder/log"; fail "cmake --install failed"; }
[ "$(ls "$folder/stage")" = opt ] || fail "files outside of the prefix: $(ls "$folder/stage")"
tree="$folder/moved to another place"
mv "$folder/stage/opt/umbra" "$tree"
for file in share/umbra/materials/mli_kapton.yaml share/umbra/scenarios/sphere/scenario.yaml share/umbra/sensors/ufo.yaml \
  share/umbra/scenarios/envisat-graz-2016/geometry/bus.obj share/umbra/scenarios/envisat-graz-2016/facets.csv \
  share/doc/umbra/README.md share/doc/umbra/LICENSE \
  share/doc/umbra/docs/files.md share/doc/umbra/examples/effects/pileup.c include/umbra/effects/effect.h \
  share/bash-completion/completions/umbra share/zsh/site-functions/_umbra share/man/man1/umbra.1 \
  share/man/man1/umbra-run.1 share/man/man1/umbra-diagnose.1; do
  [ -s "$tree/$file" ] || fail "$file is not installed"
done

grep -q "complete -F _umbra umbra" "$tree/share/bash-completion/completions/umbra" || fail "no completion"
if grep -rqF -e "$build" -e "$source" "$tree/share/man"; then fail "a man page names the folder it was built in"; fi

PATH="$tree/bin:$PATH"
export PATH
mkdir "$folder/work"
cd "$folder/work"

# Its own records: one that the source tree does not have is found, one that is gone is missed.
sed 's/^name:.*/name: only_installed/' "$tree/share/umbra/materials/black.yaml" >"$tree/share/umbra/materials/only_installed.yaml"
expect only_installed umbra list materials
rm "$tree/share/umbra/materials/only_installed.yaml"
mv "$tree/share/umbra/materials" "$tree/share/umbra/gone"
if umbra list materials >said 2>&1; then fail "materials of another tree are used: $(cat said)"; fi
grep -q "UMBRA_DATA names a folder that holds materials/" said || fail "no advice: $(cat said)"
UMBRA_DATA="$source/materials" # holds no folder materials/
export UMBRA_DATA
if umbra list materials >said 2>&1; then fail "UMBRA_DATA is not heard"; fi
unset UMBRA_DATA
mv "$tree/share/umbra/gone" "$tree/share/umbra/materials"

# A link to it elsewhere on the path works too.
ln -s "$tree/bin/umbra" linked
expect mli_kapton ./linked list materials
expect "They lie in $tree/share/umbra/scenarios; " umbra list scenarios

expect "did you mean '$tree/share/umbra/scenarios/sphere'" sh -c 'umbra check sphere 2>&1 || true'
expect "results in out/sphere" umbra run "$tree/share/umbra/scenarios/sphere" --no-plots --set time.step_s=60 --out out/sphere
[ -s out/sphere/lightcurve.csv ] || fail "no light curve"
expect "umbra run fresh" umbra new fresh
expect "fresh: 2026-03-20T19:27:00.000Z" umbra check fresh
expect "envisat" umbra check "$tree/share/umbra/scenarios/envisat-graz-2016"
umbra validate --thermal >said || { grep MISS said; fail "validate"; }
grep -q " cases within tolerance" said || fail "validate says nothing"

# A user's own effect is compiled with the installed headers alone; each of them stands by itself.
(cd "$tree/include/umbra" && find . -name '*.h') >headers
while read -r header; do
  printf '#include "%s"\n' "$header" >one.c
  "$cc" -std=c17 -Wall -Werror -I"$tree/include/umbra" -fsyntax-only one.c || fail "$header does not stand alone"
done <headers
"$cc" -std=c17 -O2 -shared -fPIC -I"$tree/include/umbra" -o own.so "$tree/share/doc/umbra/examples/effects/pileup.c"
expect "q_m2_W" umbra list effects pileup --effect-file own.so
echo "install: all well"
