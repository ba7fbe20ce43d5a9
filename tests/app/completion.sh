#!/bin/bash
# The completion for bash, driven as readline does: words and the place of the cursor go in, COMPREPLY
# comes out.
#   completion.sh UMBRA
set -euo pipefail
umbra=$1
folder=$(mktemp -d "${TMPDIR:-/tmp}/umbra-completion-XXXXXX")
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$umbra" completion bash >script
bash -n script
# shellcheck disable=SC1091
source ./script
mkdir scenarios "a b" out
touch scenarios/one.yaml measured.csv other.txt mine.so

fail() { echo "completion: $*" >&2; exit 1; }
# words, the last one under the cursor: what is offered, sorted, on one line
offers() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  _umbra || : # nothing fits
  local IFS=$'\n'
  sorted=$(printf '%s\n' "${COMPREPLY[@]+"${COMPREPLY[@]}"}" | LC_ALL=C sort | tr '\n' '|')
}
expect() { # offered, words...
  local wanted=$1
  shift
  offers "$@"
  [ "$sorted" = "$wanted" ] || fail "'$*' offers '$sorted', expected '$wanted'"
}
holds() { # one that is offered, words...
  local wanted=$1
  shift
  offers "$@"
  case "|$sorted" in *"|$wanted|"*) ;; *) fail "'$*' does not offer '$wanted': $sorted" ;; esac
}

complete -p umbra | grep -q -- '-F _umbra umbra' || fail "not registered"
expect "render|replay|report|retrieve|run|" umbra r
expect "--version|" umbra --v
expect "completion|" umbra help compl
expect "|" umbra effec # an old name
expect "--without|" umbra run --witho
expect "--temperature-sigma|--temperatures|" umbra synth --temp
expect "--json|" umbra list keys --j
expect "albedo|albedo_level|" umbra run x --with alb
expect "panel_extraction|" umbra list effects panel_e
expect "roughness|" umbra fit s m --add rough
expect "minislr|" umbra list sensors mi
expect "johnson_b|johnson_u|johnson_v|" umbra list filters john
expect "hidden-effect/dawn|hidden-effect/dusk|" umbra list --json scenarios hid
expect "effects|filters|keys|materials|scenarios|sensors|" umbra list ""
expect "mli_kapton|mli_kapton_ito|" umbra list materials mli_k
expect "orbit.circular.altitude_km|" umbra list keys orbit.circular.alt
expect "exchange|facets|mesh|network|sky|tdm|temperatures|trajectory|vtu|" umbra export x --as ""
expect "bash|zsh|" umbra completion ""
expect "a b/|out/|scenarios/|" umbra run ""
expect "scenarios/one.yaml|" umbra run scenarios/
expect "a b/|measured.csv|out/|scenarios/|" umbra compare scenarios ""
expect "measured.csv|" umbra compare --set a=b scenarios mea
expect "measured.csv|" umbra compare scenarios --json mea
expect "out/|" umbra run --out o
expect "out/|" umbra run -o o
expect "out/|" umbra run --out = o
expect "mine.so|" umbra run x --effect-file mi
expect "|" umbra run x --threads ""
touch record.json
expect "a b/|out/|record.json|scenarios/|" umbra replay ""
rm record.json
expect "|" umbra run scenarios ""
expect "|" umbra validate x
# Every command offers its options; those of help are those of the completion.
for verb in $("$umbra" help | sed -n 's/^  umbra \([a-z]*\) .*/\1/p'); do
  offered=$(offers umbra "$verb" --; echo "$sorted" | tr '|' '\n' | grep -- '^--' | sort)
  explained=$("$umbra" help "$verb" | sed -n '/^Options:/,/^$/s/^  ..[, ] *\(--[a-z-]*\).*/\1/p' | sort)
  [ "$offered" = "$explained" ] || fail "$verb: '$offered' offered, '$explained' explained"
done
echo "completion: all well"
