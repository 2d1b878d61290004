#!/usr/bin/env bash
# Runs a command on a screen, a session bus and a home of its own, and takes
# all of them away again: headless.sh COMMAND…
# HULL2VD_SCREEN is the size of the screen, HULL2VD_SCALE its pixels to a px,
# HULL2VD_TIMEOUT its seconds, HULL2VD_LANG the locale,
# HULL2VD_LANGUAGE its languages.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
server=
clean_up() {
  [ -z "$server" ] || kill "$server" 2>/dev/null || :
  rm -rf "$folder" 2>/dev/null || :
}
trap clean_up EXIT

export HOME=$folder XDG_RUNTIME_DIR=$folder/run
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache
export XDG_DATA_HOME=$folder/data
mkdir -m 700 "$folder/run"
unset WAYLAND_DISPLAY DBUS_SESSION_BUS_ADDRESS AT_SPI_BUS_ADDRESS GTK_THEME
export LC_ALL=${HULL2VD_LANG:-C.UTF-8} LANGUAGE=${HULL2VD_LANGUAGE:-} GSETTINGS_BACKEND=memory
export GDK_BACKEND=x11 GDK_SCALE=${HULL2VD_SCALE:-1} LIBGL_ALWAYS_SOFTWARE=1
export HULL2VD_ANIMATIONS=${HULL2VD_ANIMATIONS:-0} # pictures stand still
export GTK_USE_PORTAL=0 NO_AT_BRIDGE=0 GIO_USE_VFS=local

# The accessibility bus is started quietly: what is printed is the test's.
mkdir "$folder/services"
sed 's|^Exec=\(.*\)|Exec=/bin/sh -c "exec \1 >/dev/null 2>\&1"|' \
  /usr/share/dbus-1/services/org.a11y.Bus.service \
  >"$folder/services/org.a11y.Bus.service"
sed "s|@folder@|$folder|g" "$here/session.conf" >"$folder/session.conf"

Xvfb -displayfd 6 -screen 0 "${HULL2VD_SCREEN:-1440x900}x24" -dpi 96 \
  +extension GLX -noreset -nolisten tcp \
  6>"$folder/display" >"$folder/server.log" 2>&1 &
server=$!
for _ in $(seq 1200); do
  [ -s "$folder/display" ] && break
  kill -0 "$server" 2>/dev/null || break
  sleep 0.05
done
[ -s "$folder/display" ] || {
  cat "$folder/server.log" >&2
  exit 1
}
DISPLAY=:$(cat "$folder/display")
export DISPLAY HULL2VD_SERVER=$server

timeout "${HULL2VD_TIMEOUT:-240}" \
  dbus-run-session --config-file="$folder/session.conf" -- "$@"
