#!/usr/bin/env bash
# test-hooks.sh LIBRARY WITHOUT…: QuickHull is compiled with its hook and
# without. With it, it calls through a pointer; without, no such call is left
# in its machine code.
set -euo pipefail
library=$1
shift

# The parts that tell of events.
parts='hull|horizon|cavity|outside|simplex'

# n_calls ARCHIVE: calls through pointers in those parts
n_calls() {
  objdump --disassemble --no-show-raw-insn "$1" | awk -v parts="(^|/)($parts)[.]c[.]o:" '
    /file format/ { is_part = $1 ~ parts }
    is_part && /\t(call *\*|callq *\*|blr )/ { n += 1 }
    END { print n + 0 }'
}

# n_builds ARCHIVE: how many times it holds them
n_builds() {
  objdump --file-headers "$1" | grep -cE "^(.*/)?hull[.]c[.]o: "
}

# say NUMBER SENTENCE CONDITION…
say() {
  local number=$1 sentence=$2
  shift 2
  if "$@"; then
    echo "ok $number - $sentence"
  else
    echo "not ok $number - $sentence"
    status=1
  fi
}

status=0
echo 1..3
n_without=0 n_builds_without=0
for archive in "$@"; do
  n_without=$((n_without + $(n_calls "$archive")))
  n_builds_without=$((n_builds_without + $(n_builds "$archive")))
done
n_all=$(n_calls "$library")
echo "# $n_all calls through pointers in all builds, $n_without without hook"
say 1 "builds with the hook and without are looked at" \
  test "$n_builds_without" -eq $# -a "$(n_builds "$library")" -gt $#
say 2 "with its hook the engine calls it" test "$n_all" -gt 0
say 3 "without its hook the engine calls nothing in its place" \
  test "$n_without" -eq 0
exit "$status"
