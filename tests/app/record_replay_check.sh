# A replayed recording has the same hashes after every tick and the same document at the end.
. "$(dirname "$0")/lib.sh"

cat >"$OUT/original.coaster" <<SCRIPT
coaster-script 1
env size 960x540
load "$SOURCE/tracks/gentle.json"
ride.start
frames 20
select @k2
aim.drag @k2 by 1 12 -1
ticks 77
ui.click "Track/Add curve"
evaluator horner
ticks 13
key Ctrl+Z
select @s2 at 0.3
ui.click "Track/Insert point"
gesture
move @k3 to 1.5 9.25 -7.75
roll @k3 to 12.5
end
ticks 240
log hash document
log hash motion
save "\$OUT/end.json"
SCRIPT
expect_code 0 --headless --script "$OUT/original.coaster" --out "$OUT/a" --record "$OUT/recorded.coaster" --hash-log
cp "$OUT/stdout" "$OUT/original.log"
cat >"$OUT/replay.coaster" <<'SCRIPT'
coaster-script 1
include "recorded.coaster"
log hash document
log hash motion
save "$OUT/end.json"
SCRIPT
expect_code 0 --headless --script "$OUT/replay.coaster" --out "$OUT/b" --hash-log
cp "$OUT/stdout" "$OUT/replay.log"
cmp "$OUT/original.log" "$OUT/replay.log" || fail "the hashes differ"
cmp "$OUT/a/end.json" "$OUT/b/end.json" || fail "the documents differ"
[ "$(grep -c '^tick ' "$OUT/original.log")" -gt 300 ] || fail "too few ticks were logged"
[ "$(cut -d' ' -f6 "$OUT/original.log" | sort -u | wc -l)" -gt 300 ] || fail "the motion stood still"
# Switching evaluators changes no hash.
sed 's/^evaluator horner$/evaluator forward_differences/' "$OUT/recorded.coaster" >"$OUT/switched.coaster"
cmp -s "$OUT/recorded.coaster" "$OUT/switched.coaster" && fail "the recording has no evaluator command"
sed 's/recorded/switched/' "$OUT/replay.coaster" >"$OUT/replay-switched.coaster"
expect_code 0 --headless --script "$OUT/replay-switched.coaster" --out "$OUT/c" --hash-log
cmp "$OUT/original.log" "$OUT/stdout" || fail "the evaluator changed a hash"
finish
