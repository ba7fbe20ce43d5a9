#!/bin/sh
# The man pages: umbra.1 is short and names every verb, and the page of a verb has the content of its
# help, word for word.
#   manual.sh UMBRA WRITE_MANUAL
set -eu
umbra=$1 write=$2
folder=$(mktemp -d "${TMPDIR:-/tmp}/umbra-manual-XXXXXX")
trap 'rm -rf "$folder"' EXIT
fail() { echo "manual: $*" >&2; exit 1; }
sh "$write" "$umbra" "$folder/man1"
cd "$folder"
[ "$(wc -l <man1/umbra.1)" -lt 250 ] || fail "umbra.1 has $(wc -l <man1/umbra.1) lines"
for part in SYNOPSIS DESCRIPTION COMMANDS FILES ENVIRONMENT '"EXIT STATUS"'; do
  grep -qx -- ".SH $part" man1/umbra.1 || fail "no $part in umbra.1"
done
count=0
for verb in $("$umbra" help | sed -n 's/^  umbra \([a-z]*\)  .*/\1/p'); do
  count=$((count + 1))
  page=man1/umbra-$verb.1
  [ -s "$page" ] || fail "no $page"
  grep -qF -- "\\fBumbra\\-$verb\\fR(1)" man1/umbra.1 || fail "umbra.1 does not name umbra-$verb"
  # without name, headings and what roff makes of letters
  sed '/^\.SH NAME/,/^\.SH SYNOPSIS/d; /^\.SH "SEE ALSO"/,$d' "$page" |
    sed '/^\./d; s/\\f[BIR]//g; s/\\-/-/g; s/\\&//g; s/\\e/\\/g' | tr -s ' \n' '\n' | sed '/^$/d' >page
  "$umbra" help "$verb" | sed '/^Arguments:$/d; /^Options:$/d; /^Kinds:$/d; /^Examples:$/d; /^Exit status:$/d' |
    tr -s ' \n' '\n' | sed '/^$/d' >help
  diff help page >difference || fail "umbra-$verb.1 has other words than the help: $(head -4 difference)"
  if command -v man >/dev/null && command -v groff >/dev/null; then
    man --warnings -E ascii -l "$page" 2>warnings >/dev/null || :
    [ ! -s warnings ] || fail "$page: $(cat warnings)"
  fi
done
[ "$count" -gt 20 ] || fail "$count verbs"
[ "$(find man1 -type f | wc -l)" -eq $((count + 1)) ] || fail "other files: $(ls man1)"
echo "manual: all well"
