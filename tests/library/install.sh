#!/bin/sh
# The installed library works wherever its tree is moved to: the examples in C, by pkg-config and by
# CMake, and in Python run from there, and say what the command says.
#   install.sh CMAKE BUILD_FOLDER C_COMPILER CXX_COMPILER PYTHON SOURCE_FOLDER
set -eu
cmake=$1 build=$2 cc=$3 cxx=$4 python=$5 source=$6
folder=$(mktemp -d "${TMPDIR:-/tmp}/umbra-library-XXXXXX")
trap 'rm -rf "$folder"' EXIT
unset UMBRA_DATA LD_LIBRARY_PATH
fail() { echo "library: $*" >&2; exit 1; }

DESTDIR=$folder/stage "$cmake" --install "$build" --prefix /opt/umbra >"$folder/log" 2>&1 ||
  { cat "$folder/log"; fail "cmake --install failed"; }
tree="$folder/built against"
mv "$folder/stage/opt/umbra" "$tree"
pc=$(dirname "$(find "$tree" -name umbra.pc)")
libraries=$(dirname "$pc")
cp -r "$source/examples" "$folder/examples"

# One header, that stands alone; names of umbra alone.
printf '#include <umbra.h>\nint main(void) { struct umbra_settings s = UMBRA_SETTINGS; return (int)s.threads; }\n' >"$folder/one.c"
"$cc" -std=c17 -Wall -Wextra -Wpedantic -Werror -I"$tree/include" -fsyntax-only "$folder/one.c" || fail "umbra.h as C17"
"$cxx" -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -I"$tree/include" -fsyntax-only "$folder/one.c" || fail "umbra.h as C++17"
if nm -D --defined-only "$libraries/libumbra.so" | awk '{print $3}' | grep -v '^umbra_'; then fail "libumbra.so exports other names"; fi
if nm -g --defined-only "$libraries/libumbra.a" | awk 'NF == 3 {print $3}' | grep -v '^umbra_'; then fail "libumbra.a exports other names"; fi
grep -o 'umbra_[a-z_]*(' "$tree/include/umbra.h" | tr -d '(' | sort -u >"$folder/declared"
nm -D --defined-only "$libraries/libumbra.so" | awk '{print $3}' | sort -u | diff "$folder/declared" - || fail "header and library differ"
readelf -d "$libraries/libumbra.so" | grep -q 'SONAME.*libumbra\.so\.[0-9]' || fail "no version in the name of libumbra.so"
if readelf -d "$libraries/libumbra.so" | grep -qE 'RPATH|RUNPATH'; then fail "libumbra.so looks into the folder it was built in"; fi

# Built against the tree, in three ways.
PKG_CONFIG_PATH=$pc
export PKG_CONFIG_PATH
# shellcheck disable=SC2046
eval "$cc" -std=c17 "'$folder/examples/c/lightcurve.c'" $(pkg-config --cflags --libs umbra) -o "'$folder/by_pkgconfig'"
eval "$cc" -std=c17 "'$folder/examples/c/lightcurve.c'" $(pkg-config --cflags umbra) "'$libraries/libumbra.a'" \
  $(pkg-config --static --libs umbra | sed 's/-lumbra//') -o "'$folder/static'"
"$cmake" -S "$folder/examples/c" -B "$folder/made" -DCMAKE_C_COMPILER="$cc" -DCMAKE_PREFIX_PATH="$tree" \
  -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON >"$folder/log" 2>&1 && "$cmake" --build "$folder/made" >>"$folder/log" 2>&1 ||
  { cat "$folder/log"; fail "the example is not built by CMake"; }

moved="$folder/moved to another place"
mv "$tree" "$moved"
libraries="$moved${libraries#"$tree"}"
sphere=$moved/share/umbra/scenarios/sphere
cd "$folder"
"$moved/bin/umbra" run "$sphere" --no-plots --out of_command >/dev/null
rows=$(($(wc -l <of_command/lightcurve.csv)))

LD_LIBRARY_PATH=$libraries
export LD_LIBRARY_PATH
./by_pkgconfig "$sphere" >by_pkgconfig.csv || fail "the program that pkg-config built"
made/lightcurve "$sphere" >by_cmake.csv || fail "the program that CMake built"
PYTHONPATH=$source/python UMBRA_LIBRARY=$libraries/libumbra.so "$python" -B examples/python/lightcurve.py "$sphere" >by_python.csv || fail "the example in Python"
unset LD_LIBRARY_PATH
UMBRA_DATA=$moved/share/umbra ./static "$sphere" >by_static.csv || fail "the program that is linked with libumbra.a"
[ "$(($(wc -l <by_pkgconfig.csv)))" = "$rows" ] || fail "not as many rows as the command"
for way in cmake python static; do cmp by_pkgconfig.csv by_$way.csv || fail "$way"; done
[ "$(wc -l <"$source/examples/python/lightcurve.py")" -le 10 ] || fail "more than ten lines of Python"

# Its own records: they are missed when they are gone.
mv "$moved/share/umbra/materials" "$moved/share/umbra/gone"
if LD_LIBRARY_PATH=$libraries ./by_pkgconfig "$sphere" >said 2>&1; then fail "materials of another tree are used"; fi
grep -q "UMBRA_DATA names a folder that holds materials/" said || fail "no advice: $(cat said)"
echo "library: all well"
