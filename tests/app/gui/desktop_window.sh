#!/usr/bin/env bash
# The real window, on a display of its own that nobody sees: start, open the demo by the palette, scrub, change the theme,
# resize, quit. What it leaves behind tells whether all of that arrived.   desktop_window.sh NADIR
set -euo pipefail
program=$(realpath "$1")
for tool in Xvfb xdotool; do
  command -v "$tool" >/dev/null || { echo "SKIPPED: $tool is not installed"; exit 0; }
done
folder=$(mktemp -d)
export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
cleanup() { kill "${window:-}" "${screen:-}" 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$folder"; }
trap cleanup EXIT
fail() { echo "FAILED: $1"; cat "$folder/said"; exit 1; }
until_true() {  # until_true SECONDS COMMAND...
  local left=$(($1 * 10)); shift
  until "$@" >/dev/null 2>&1; do left=$((left - 1)); [ $left -gt 0 ] || return 1; sleep 0.1; done
}
# The server says which display it found free.
mkfifo "$folder/number"
Xvfb -displayfd 4 -screen 0 1280x800x24 4>"$folder/number" 2>/dev/null &
screen=$!
read -r number <"$folder/number"
export DISPLAY=:$number
unset WAYLAND_DISPLAY

"$program" gui >"$folder/said" 2>&1 &
window=$!
until_true 20 xdotool search --name Nadir || fail 'no window came up'
sleep 1
# Quicker than any hand: a frame by software takes its time, and what goes down and up meanwhile has to arrive all the same.
command_by_palette() { xdotool key --delay 1 ctrl+p type --delay 1 "$1"; xdotool key --delay 1 Return; }
command_by_palette 'open the demo'
until_true 180 xdotool search --name 'run' || fail 'the demo was not opened'
sleep 2
xdotool mousemove 500 650 mousedown 1 mousemove 600 650 mousemove 700 650 mousemove 800 650 mouseup 1 mousemove 640 300
command_by_palette 'light theme'
sleep 1
xdotool windowsize "$(xdotool search --name Nadir | head -1)" 1000 640; sleep 1
kill -0 "$window" 2>/dev/null || fail 'the window is gone'
xdotool key --delay 1 ctrl+q
wait "$window" || fail "it ended with status $?"
window=
grep -q 'theme = "light"' "$folder/config/nadir/preferences.toml" || fail 'the palette did not change the theme'
awk -F' = ' '$1 == "time_s" {exit !($2 > 40 && $2 < 70)}' "$folder/config/nadir/session.toml" ||
  fail "scrubbing to the middle left $(grep time_s "$folder/config/nadir/session.toml")"
echo 'the window came, listened and left'
