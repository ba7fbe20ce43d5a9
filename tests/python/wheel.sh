#!/bin/sh
# The wheel, built and installed in an empty virtual environment, works without the clone and without a
# network: ten lines of Python say what the command says.
#   wheel.sh PYTHON SOURCE_FOLDER BUILD_FOLDER
set -eu
python=$1 source=$2 build=$3
folder=$(mktemp -d "${TMPDIR:-/tmp}/umbra-wheel-XXXXXX")
trap 'rm -rf "$folder"' EXIT
unset UMBRA_DATA UMBRA_LIBRARY LD_LIBRARY_PATH PYTHONPATH || true
export PYTHONDONTWRITEBYTECODE=1 PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore
fail() { echo "wheel: $*" >&2; exit 1; }

# A clone that may be written into.
mkdir -p "$folder/clone/library"
cp -r "$source/python" "$source/CMakeLists.txt" "$folder/clone"
cp "$source/library/umbra.h" "$folder/clone/library"

# numpy, xarray, pandas and cffi are the system's: nothing is downloaded.
"$python" -m venv --system-site-packages "$folder/environment"
cd "$folder"
UMBRA_BUILD=$build environment/bin/pip wheel -q --no-build-isolation --no-deps --wheel-dir wheels clone/python >log 2>&1 ||
  { cat log; fail "no wheel is built"; }
wheel=$(echo wheels/*.whl)
case "$wheel" in
*-py3-none-linux_*.whl) ;;
*) fail "$wheel is not py3-none-PLATFORM" ;;
esac
environment/bin/pip install -q --no-deps "$wheel" >log 2>&1 || { cat log; fail "the wheel is not installed"; }
rm -r clone

where=$(environment/bin/python -c 'import umbra; print(umbra.__file__)')
case "$where" in
"$folder"/environment/*) ;;
*) fail "umbra is imported from $where" ;;
esac
environment/bin/python "$source/examples/python/lightcurve.py" sphere >by_python.csv || fail "the example in Python"
"$build/umbra" run "$source/scenarios/sphere" --no-plots --out of_command >/dev/null
[ "$(($(wc -l <by_python.csv)))" = "$(($(wc -l <of_command/lightcurve.csv)))" ] || fail "not as many rows as the command"

# What is not there is said.
mv "$(dirname "$where")/libumbra.so" gone
if environment/bin/python -c 'import umbra' 2>said; then fail "imported without a library"; fi
grep -q "libumbra is not found" said && grep -q UMBRA_LIBRARY said || fail "no advice: $(cat said)"
echo "wheel: all well"
