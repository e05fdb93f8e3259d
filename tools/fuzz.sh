#!/usr/bin/env bash
# Damaged inputs under sanitizers (build/debug), on all cores; CONTRIBUTING.md says more.
#
#   tools/fuzz.sh COUNT [SEED [FOLDER...]]
#
# Inputs that broke something are kept in build/fuzz. Ends with 1 if there are any.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
count=${1:?how many inputs}
seed=${2:-$(date +%s)}
shift $(($# < 2 ? $# : 2))
program=$root/build/debug/tests/fuzz_inputs
kept=$root/build/fuzz
mkdir -p "$kept"

# A report goes to the parent of the process that it is about, which reads it.
export ASAN_OPTIONS=detect_leaks=0:detect_container_overflow=0:handle_abort=0:exitcode=99
export UBSAN_OPTIONS=print_stacktrace=1

jobs=${JOBS:-$(nproc)}
share=$(((count + jobs - 1) / jobs))
echo "$count damaged inputs from seed $seed on"
for ((i = 0; i < jobs; ++i)); do
  nice -n 15 "$program" --seed $((seed + i * share)) --count "$share" --keep "$kept" \
    "$root/examples" "$root/tests/fuzz" "$@" >"$kept/log-$i.txt" &
  running[i]=$!
done
status=0
for ((i = 0; i < jobs; ++i)); do
  wait "${running[i]}" || status=1
  cat "$kept/log-$i.txt"
done
exit $status
