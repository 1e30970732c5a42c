# The settings file: kept from run to run, garbage set aside, keys reassigned, and none of it in scripts that do not
# request it.
. "$(dirname "$0")/lib.sh"
run() {
  expect_code "$1" --headless --script "$OUT/$2.coaster" --config "$OUT/home" --out "$OUT" --size 800x600 "${@:3}"
}
mkdir -p "$OUT/home"
settings=$OUT/home/settings.json

# Changes by the user are kept for the next start.
script change 'ui.menu "View/Light theme"
key Ctrl+,
ui.click "Settings/Scale/125 %"
ui.check "Settings/Shadows" off
ui.type "Settings/Autosave every (s)" "12"
ui.click "Settings/Keys/Undo"
key Ctrl+U
expect visible "Settings/Keys/Undo"
ui.click "Settings/Close"
key L
frames 90'
run 0 change
grep -q '"theme": "light"' "$settings" || fail "the theme is not kept: $(cat "$settings")"
grep -q '"Undo": "Ctrl+U"' "$settings" || fail "the key is not kept"
script again 'expect theme == "light"
expect shadows == off
expect scale == 1.25
append at 0 5 0
expect dirty == on
key Ctrl+Z
expect dirty == on
key Ctrl+U
expect dirty == off'
run 0 again
grep -q '"laboratory": true' "$settings" || fail "the laboratory is not kept"
script reset 'expect scale == 1
expect theme == "light"
expect panels == on'
run 0 reset --reset-layout
cp "$settings" "$OUT/kept.json"

# Without --config a script does not read it, in any location.
script plain 'expect theme == "dark"
expect scale == 1'
cp "$settings" "$OUT/home/coaster.json"
mkdir -p "$OUT/xdg/coaster" && cp "$settings" "$OUT/xdg/coaster/settings.json"
XDG_CONFIG_HOME="$OUT/xdg" expect_code 0 --headless --script "$OUT/plain.coaster" --out "$OUT/plain"

# Any garbage is set aside; an invalid member affects only itself.
script garbage 'expect theme == "dark"
expect toast ~ "set aside as settings.json.bad"'
for garbage in 'no json' '' '{"format": "coaster-track"}' '[]'; do
  printf '%s' "$garbage" >"$settings"
  [ -n "$garbage" ] || printf ' ' >"$settings"
  cp "$settings" "$OUT/garbage"
  run 0 garbage
  cmp "$OUT/garbage" "$settings.bad" || fail "garbage is lost: $garbage"
  rm -f "$settings.bad"
done
# The file of a newer version, and a second one: neither is overwritten.
script newer 'expect toast ~ "newer than this program supports (1); set aside as settings.json.bad"
theme light
frames 90'
for suffix in bad bad2; do
  printf '{"format": "coaster-settings", "version": 2, "of": "%s"}' "$suffix" >"$settings"
  run 0 newer
  grep -q "\"of\": \"$suffix\"" "$settings.$suffix" || fail "the file of a newer version is lost"
  grep -q '"version": 1' "$settings" || fail "no settings are kept beside it"
done
rm -f "$settings".bad*
printf '{"format": "coaster-settings", "version": 1, "theme": 5, "ui_scale": 1.5, "later": {"a": 1}}' >"$settings"
script partly 'expect toast ~ "theme: expected"
expect theme == "dark"
expect scale == 1.5
panels off
frames 90'
run 0 partly
grep -q '"later"' "$settings" || fail "unknown members are lost"
grep -q '"panels": false' "$settings" || fail "the panels are not kept"

# Keys: unknown actions and keys, and keys assigned twice, are reported in one notice; menus and tooltips show the keys
# in effect.
cat >"$settings" <<'END'
{"format": "coaster-settings", "version": 1, "keys": {
  "Undo": "Ctrl+U", "Undoo": "F3", "Redo": "Ctrl+U", "Save": "Splat", "Frame all": "R", "Add curve": ""}}
END
script keys 'expect toast ~ "There is no action \"Undoo\"; did you mean \"Undo\"?"
expect toast ~ "Ctrl+U is assigned to both Undo and Redo."
expect toast ~ "Save keeps its default keys because \"Splat\" is not a key."
expect toast ~ "R now belongs to Frame all, not to Rotate."
append at 0 5 0
append at 20 5 0
key C
expect knots == 2
key Ctrl+U
expect knots == 1
key Ctrl+Y
expect knots == 2'
run 0 keys
grep -q '"Undoo"' "$settings" || fail "keys of unknown actions are lost"

# A folder that cannot be written: reported once, and the program continues.
rm -rf "$OUT/home"
: >"$OUT/home"
script unwritable 'theme light
wait toast ~ "settings are not kept" max 200 frames
theme dark
frames 100
append at 0 5 0
expect dirty == on'
run 0 unwritable
rm "$OUT/home"

# The desktop's own dialog, if there is one: started with the folder, polled without waiting, its answer used or not.
mkdir -p "$OUT/bin" "$OUT/home"
cat >"$OUT/bin/zenity" <<FAKE
#!/bin/sh
printf '%s\n' "\$@" >"$OUT/arguments"
[ -e "$OUT/cancel" ] && exit 1
sleep 0.5
echo "$SOURCE/tracks/loop.json"
FAKE
chmod +x "$OUT/bin/zenity"
script dialog 'key Ctrl+O
ui.click "Open/System dialog"
frames 1
expect visible "Open/Waiting"
wait track_file == "loop.json" max 20000 frames
expect not visible "Open/Cancel"'
PATH="$OUT/bin:$PATH" run 0 dialog
grep -qx -- "--file-selection" "$OUT/arguments" || fail "zenity's arguments: $(cat "$OUT/arguments")"
: >"$OUT/cancel"
script cancel 'key Ctrl+O
ui.click "Open/System dialog"
frames 1000
expect visible "Open/Show all files"
expect knots == 0'
PATH="$OUT/bin:$PATH" run 0 cancel
script none 'key Ctrl+O
expect not visible "Open/System dialog"'
PATH=/nowhere run 0 none
finish
