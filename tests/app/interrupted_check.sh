# SIGTERM is answered within a second of processor time while a statement works: a share of what tools/time_commands
# checks for every command. Sanitized builds get ten seconds.
. "$(dirname "$0")/lib.sh"
answer=10
[ -n "${FAILING_NEW:-}" ] && answer=1
python3 "$SOURCE/tools/time_commands" --program "$COASTER" --knots 20000 --answer "$answer" \
  load duplicate make_all_g2 seek >"$OUT/times" 2>&1 || fail "$(cat "$OUT/times")"
finish
