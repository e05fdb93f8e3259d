#!/usr/bin/env bash
# Reports what clang-tidy (14, .clang-tidy) finds in the C++ sources.
#
#   tools/lint.sh [BASE]       in the files that were changed since BASE: origin/main or, where that
#                              is not known, the commit before the last
#   tools/lint.sh --all        in all of src, include, apps, tests, bench and tools
#
# A changed header is checked through its source (a.hpp, a.cpp), else the first that includes it.
# Exits with 1 where something was found; the end says how often each check found something.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
tidy=$(command -v clang-tidy-14 || command -v clang-tidy) || {
  echo "clang-tidy is missing: tools/install-packages.sh develop" >&2
  exit 2
}

# The source through which a header is checked.
source_of() {
  local name found
  name=$(basename "$1" .hpp)
  found=$(git ls-files "*/$name.cpp" | head -n 1)
  [ -n "$found" ] || found=$(git grep -lE "[</\"]$name\\.hpp[>\"]" -- '*.cpp' | head -n 1 || true)
  printf '%s\n' "$found"
}

case "${1:-}" in
  --all)
    files=$(git ls-files -- '*.cpp' '*.hpp')
    sources=$(git ls-files -- '*.cpp')
    ;;
  -*)
    sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
  *)
    base=${1:-$(git rev-parse --quiet --verify origin/main || git rev-parse HEAD~1)}
    files=$(git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp'
      git ls-files --others --exclude-standard -- '*.cpp' '*.hpp')
    sources=$(while read -r file; do
      case $file in *.cpp) echo "$file" ;; *.hpp) source_of "$file" ;; esac
    done <<<"$files")
    ;;
esac

# A build tree of its own, in which each source has a command: sources in groups have none.
cmake --preset lint >/dev/null
known=$(sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/lint/compile_commands.json)
sources=$(sed "/^$/d;s|^|$root/|" <<<"$sources" | sort -u | grep -Fxf - <(echo "$known") || true)
if [ -z "$sources" ]; then
  echo "Nothing to check."
  exit 0
fi

echo "clang-tidy reads $(wc -l <<<"$sources") sources."
found='^([^:]+:[0-9]+:[0-9]+): (warning|error): (.*) \[([^]]*)\]$'
findings=$(xargs -P "$(nproc)" -n 1 "$tidy" -p build/lint --quiet <<<"$sources" 2>/dev/null |
  sed -nE "s#$found#\\1: \\3 [\\4]#p" | sed "s#^$root/##" | sort -u |
  grep -Ff <(sed '/^$/d;s/$/:/' <<<"$files") || true)
[ -n "$findings" ] || exit 0
printf '%s\n\n' "$findings"
sed 's/.*\[//;s/\]$//' <<<"$findings" | sort | uniq -c | sort -rn
exit 1
