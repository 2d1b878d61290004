#!/usr/bin/env bash
# test-hooks.sh LIBRARY BATCH: QuickHull is compiled twice. With its hook it
# calls through a pointer; without, no such call is left in its machine code.
set -euo pipefail
library=$1 batch=$2

# The parts that tell of events.
parts='hull|horizon|cavity|outside|simplex'

# n_calls ARCHIVE: calls through pointers in those parts
n_calls() {
  objdump --disassemble --no-show-raw-insn "$1" | awk -v parts="(^|/)($parts)[.]c[.]o:" '
    /file format/ { is_part = $1 ~ parts }
    is_part && /\t(call *\*|callq *\*|blr )/ { n += 1 }
    END { print n + 0 }'
}

# n_parts ARCHIVE: how many of them it holds
n_parts() {
  objdump --file-headers "$1" | grep -cE "^(.*/)?($parts)[.]c[.]o: "
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
n_batch=$(n_calls "$batch")
n_both=$(n_calls "$library")
echo "# $n_both calls through pointers in both builds, $n_batch in the batch"
say 1 "both builds are looked at" \
  test "$(n_parts "$batch")" -ge 3 -a "$(n_parts "$library")" -ge 7
say 2 "with its hook the engine calls it" test "$n_both" -gt 0
say 3 "without its hook the engine calls nothing in its place" \
  test "$n_batch" -eq 0
exit "$status"
