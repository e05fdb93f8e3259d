# Sourced by the scripts at the top of the repository: named steps with a log file each.
#
#   step <name> <command>...      runs the command, its output into build/logs/<name>.log; says how
#                                 long it took, and every 20 s how far it is and about how long it
#                                 still takes. Where it fails: names the step, says why, and exits
#                                 with its status.
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
  rm -f "$log.plan"
  "$@" >"$log" 2>&1 </dev/null &
  pid=$!
  # A command in the background does not hear Ctrl-C by itself.
  trap '_ended "$name" "$log" "$pid"' INT TERM
  while kill -0 "$pid" 2>/dev/null; do
    if [ "$announced" = no ] && [ $((SECONDS - started)) -ge "$patience" ]; then
      say "== $name"
      announced=yes
    fi
    if [ "$waited" -ge 100 ]; then
      say "   $((SECONDS - started)) s$(time_left "$log" $((SECONDS - started))): $(tail -n 1 "$log" | cut -c 1-100)"
      waited=0
    fi
    sleep 0.2
    waited=$((waited + 1))
  done
  wait "$pid" || status=$?
  trap - INT TERM
  if [ "$status" -ne 0 ]; then
    say ""
    say "FAILED: $name (exit status $status)"
    why step "$log"
    exit "$status"
  fi
  [ "$announced" = no ] || say "   done in $((SECONDS - started)) s"
}

_ended() {
  kill "$3" 2>/dev/null
  say ""
  say "ENDED from outside: $1. Its last line: $(tail -n 1 "$2" | cut -c 1-200). The whole log: $2"
  exit 130
}

# What stopped a step, or which tests failed and why, on standard error: tools/why_failed.py.
why() {
  if ! /usr/bin/python3 "$root/tools/why_failed.py" "$@" >&2; then
    tail -n 40 "$2" | sed 's/^/  | /' >&2
    say "The whole log: $2"
  fi
}

# ", about 3 min left", once a tenth of what is to be done is done. A step of Ninja's counts by what such
# steps took when they were measured, and a package three times: when it is fetched, unpacked and set up.
#   time_left <log> <seconds so far>
time_left() {
  local plan="$1.plan"
  [ -f "$plan" ] || plan=/dev/null
  awk -v seconds="$2" '
    function weight(step) {
      if (step !~ /Building CXX/) return 0.2
      return step ~ /_headers\.dir/ ? 6 : 20
    }
    FILENAME != ARGV[2] { if (/^\[[0-9]+\/[0-9]+\]/) all += weight($0); next }
    /^\[[0-9]+\/[0-9]+\]/ { done += weight($0) }
    / newly installed, / { packages = $1 + $3; all += 3 * packages }
    packages && /^(Get:|Unpacking |Setting up )/ { ++done }
    END {
      if (done < all / 10 || done >= all) exit
      left = seconds * (all - done) / done
      if (left < 90) printf ", about %d s left", 10 * int(left / 10 + 1)
      else printf ", about %d min left", int(left / 60 + 0.5)
    }' "$plan" "$1" 2>/dev/null || true
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
# Ninja itself, after what it is about to do, for time_left; and not `cmake --build`, which on being ended leaves its Ninja running.
build() {
  local preset=$1
  shift
  # By another name it is no file that Ninja would make again first, and stop there.
  ln -sf build.ninja "$root/build/$preset/plan.ninja"
  ninja -C "$root/build/$preset" -f plan.ninja -n "$@" >"$log.plan" || true
  exec ninja -C "$root/build/$preset" -j "$(nproc)" "$@"
}
