#!/bin/sh
# What drafts are worth: run.sh UMBRA SOURCE [NUMBERS]. Each of ten hidden effects is put into the pass of
# scenarios/hidden-effect/dusk with noise of 1 %, the draft is written, compiled and held against
# what had no say: of light another pass over another station, of heat, which is of one time,
# another station. The share of chi-square above its degrees of freedom that it takes away.
set -eu
umbra=$1 source=$2
export UMBRA_DATA="$source"
work=$(mktemp -d) && cd "$work"
dusk=$source/scenarios/hidden-effect/dusk
cc="cc -std=c17 -O2 -Wall -Wextra -Werror -shared -fPIC -I$source"
chi() { "$umbra" compare "$dusk" $where test.csv "$@" --out c --no-plots --force --json 2>/dev/null; }
for n in ${3:-1 2 3 4 5 6 7 8 9 10}; do
  where="--set time.start_utc=2026-03-20T20:18:00Z --set time.stop_utc=2026-03-20T20:32:00Z
    --set observer.station.longitude_deg=-22 --set observer.station.latitude_deg=50"
  [ $n -gt 8 ] && where="--set observer.station.longitude_deg=24 --set observer.station.latitude_deg=42"
  rm -rf draft.c out
  $cc -DHIDDEN=$n -o hidden.so "$source/tests/bench/drafts/hidden.c"
  hide="--effect-file ./hidden.so --with hidden --noise 0.01 --force"
  "$umbra" synth "$dusk" $hide --seed 3 -o seen.csv >/dev/null
  "$umbra" synth "$dusk" $where $hide --seed 4 -o test.csv >/dev/null
  "$umbra" diagnose "$dusk" seen.csv --only background --draft-effect draft.c --out out --no-plots >/dev/null 2>&1
  [ -e draft.c ] || { echo "$n nothing was drafted"; continue; }
  $cc -o draft.so draft.c || { echo "$n does not compile"; continue; }
  chi >before.json
  chi --effect-file ./draft.so --with draft >after.json
  python3 - $n <<'P'
import json, sys
before, after = (json.load(open(f)) for f in ("before.json", "after.json"))
excess = before["chi2"] - before["dof"]
taken = 100 * (before["chi2"] - after["chi2"]) / excess
print(f"{sys.argv[1]} excess {excess:.0f}, taken away {taken:.1f} %:", open("draft.c").readline()[3:].strip())
P
done
cd / && rm -rf "$work"
