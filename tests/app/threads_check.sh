# A system that refuses every thread: the work of threads is done in the frames, and nothing hangs or ends.
# In, besides: FAILING_THREADS (a library for LD_PRELOAD, failing_threads.cpp; empty in sanitized builds).
. "$(dirname "$0")/lib.sh"
[ -n "${FAILING_THREADS:-}" ] || finish
unset LP_NUM_THREADS # the driver's threads, too
script threads "env size 64x36
env home \"\$OUT/home\"
load \"$SOURCE/tests/tracks/two_knots.json\"
shot \"\$OUT/before.png\"
drop \"$SOURCE/tests/tracks/hills.csv\"
wait knots > 2 max 100 frames
movie.start \"\$OUT/movie\"
ticks 40
movie.stop"
LD_PRELOAD=$FAILING_THREADS timeout 60 "$COASTER" --headless --script "$OUT/threads.coaster" --out "$OUT/run" \
  >"$OUT/stdout" 2>"$OUT/stderr"
check_code $? 0 "a script without threads"
[ "$(ls "$OUT"/run/movie/frame-*.png | wc -l)" = 10 ] || fail "pictures are missing: $(ls "$OUT/run/movie")"
finish
