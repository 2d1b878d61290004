#!/usr/bin/env bash
# test-independence.sh LIBRARY: what certify calls of the core are signs,
# exact centres and memory; nothing that builds what it judges.
set -euo pipefail
library=$1
allowed='orient lift_orient facing site_compare exact_circumcentre memory_new'

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# symbols KIND: of certify's own files, or of the others
symbols() {
  nm --print-file-name --format=posix "$library" | awk -v kind="$1" '
    { is_own = $1 ~ /[[/]certify[a-z-]*[.]c[.]o[]]:$/ }
    kind == "wanted" && is_own && $3 == "U" { print $2 }
    kind == "others" && !is_own && $3 ~ /^[TDBRV]$/ { print $2 }
    kind == "own" && is_own && $3 == "T" { print $2 }' | LC_ALL=C sort -u
}

symbols wanted >"$folder/wanted"
symbols others >"$folder/others"
symbols own >"$folder/own"
tr ' ' '\n' <<<"$allowed" | LC_ALL=C sort >"$folder/allowed"
used=$(LC_ALL=C comm -12 "$folder/wanted" "$folder/others")
forbidden=$(LC_ALL=C comm -23 <(echo "$used") "$folder/allowed" | grep . || true)

status=0
echo 1..2
echo "# certify calls: ${used//$'\n'/ }"
if grep -qx certify_hull "$folder/own" && grep -qx lift_orient <<<"$used"; then
  echo "ok 1 - certify and the signs are looked at"
else
  echo "not ok 1 - certify and the signs are looked at"
  status=1
fi
if [ -z "$forbidden" ]; then
  echo "ok 2 - certify calls nothing that makes what it judges"
else
  echo "# forbidden: ${forbidden//$'\n'/ }"
  echo "not ok 2 - certify calls nothing that makes what it judges"
  status=1
fi
exit "$status"
