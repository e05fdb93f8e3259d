# Sourced by the scripts at the top of the repository: named steps with a log file each.
#
#   step <name> <command>...      runs the command, its output into build/logs/<name>.log; says how
#                                 long it took, and every 20 s how far it is. Where it fails: names
#                                 the step, the log and its last lines, and exits with its status.
#   quiet_step <name> <command>...  the same, but silent when it is over in 3 s.
#
# Everything here is said on standard error.

logs="$root/build/logs"

say() { printf '%s\n' "$*" >&2; }

step() { _step 0 "$@"; }
quiet_step() { _step 3 "$@"; }

_step() {
  local patience=$1 name=$2 log pid status=0 started=$SECONDS announced=no waited=0
  shift 2
  mkdir -p "$logs"
  log="$logs/${name//[^A-Za-z0-9]/-}.log"
  "$@" >"$log" 2>&1 </dev/null &
  pid=$!
  # A command in the background does not hear Ctrl-C by itself.
  trap 'kill "$pid" 2>/dev/null; exit 130' INT TERM
  while kill -0 "$pid" 2>/dev/null; do
    if [ "$announced" = no ] && [ $((SECONDS - started)) -ge "$patience" ]; then
      say "== $name"
      announced=yes
    fi
    if [ "$waited" -ge 100 ]; then
      say "   $((SECONDS - started)) s: $(tail -n 1 "$log" | cut -c 1-100)"
      waited=0
    fi
    sleep 0.2
    waited=$((waited + 1))
  done
  wait "$pid" || status=$?
  trap - INT TERM
  if [ "$status" -ne 0 ]; then
    say ""
    say "FAILED: $name (exit status $status). The whole log: $log"
    say "Its last lines:"
    tail -n 40 "$log" | sed 's/^/  | /' >&2
    exit "$status"
  fi
  [ "$announced" = no ] || say "   done in $((SECONDS - started)) s"
}

# Configures a preset where that has not been done, or its presets file has changed since. All else
# the build notices by itself.
#   configure <preset> <cmake argument>...
configure() {
  local preset=$1 cache="$root/build/$1/CMakeCache.txt"
  shift
  if [ ! -f "$root/build/$preset/build.ninja" ] || [ "$root/CMakePresets.json" -nt "$cache" ]; then
    (cd "$root" && cmake --preset "$preset" "$@" && touch "$cache")
  fi
}

#   build <preset> <target>...
# Ninja itself and not `cmake --build`, which on being ended leaves its Ninja running.
build() {
  local preset=$1
  shift
  exec ninja -C "$root/build/$preset" -j "$(nproc)" "$@"
}
