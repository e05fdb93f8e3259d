#!/usr/bin/env bash
# Runs what the README tells a stranger to run, in a bare Debian 12 that is made for it and gone afterwards:
# a clean clone of the last commit, git, the base system and the network, and nothing else of this machine.
#
#   tools/bare-check.sh              ./quickstart, the README's Python, ./test
#   tools/bare-check.sh -R Cone      arguments go to ./test
#
# Runs as root on Debian 12. Where apt and npm get packages from, and through which proxy, is as on this machine. Next to
# the clone lies ../shared, if it is there, read-only. RC_PARAMS and PLANISH_WERROR go in. Logs are kept in build/logs/bare.
# Ends with 1 if a command fails or takes too long, with 75 if the root cannot be made.
set -euo pipefail

# Whoever takes longer has failed.
root_minutes=10
quickstart_minutes=15
test_minutes=60

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs="$top/build/logs/bare"
. /etc/os-release

say() { printf '%s\n' "$*" >&2; }
fail() { say "FAILED: $*"; exit 1; }
cannot() { say "CANNOT: no bare root, so nothing was checked: $*"; exit 75; }  # EX_TEMPFAIL

[ "$(id -u)" -eq 0 ] || cannot "it takes root. On this machine as it is, ./test runs the tests."
[ "${VERSION_CODENAME:-}" = bookworm ] || cannot "this is ${PRETTY_NAME:-no Debian}, and it takes Debian 12."
if ! command -v mmdebstrap >/dev/null; then
  say "Installing mmdebstrap"
  { apt-get -y update && DEBIAN_FRONTEND=noninteractive apt-get -y install --no-install-recommends mmdebstrap; } \
    >/dev/null || cannot "mmdebstrap cannot be installed."
fi
why=$(unshare --mount --pid --fork --kill-child true 2>&1) || cannot "namespaces cannot be made: $why"

# In a folder on a disk: /tmp may be in memory.
folder=$(mktemp -d "${PLANISH_BARE_DIR:-/var/tmp}/planish-bare.XXXXXX")
root="$folder/root"
running="" ender=TERM  # what runs, and the signal that ends it: unshare ignores others than KILL

# Mounts are in the namespace of what runs there, and gone with it.
clean() {
  local status=$?
  trap - EXIT
  trap '' INT TERM HUP
  if [ -n "$running" ]; then
    kill "-$ender" "$running" 2>/dev/null || true
    wait "$running" 2>/dev/null || true
  fi
  keep_logs
  rm -rf --one-file-system "$folder" || say "$folder could not be removed"
  exit "$status"
}

keep_logs() {
  local build="$root/src/planish/build"
  [ ! -d "$build/logs" ] || cp -R "$build/logs/." "$logs/"
  for preset in release no-occt; do
    [ ! -f "$build/$preset/Testing/Temporary/LastTest.log" ] \
      || cp "$build/$preset/Testing/Temporary/LastTest.log" "$logs/LastTest-$preset.log"
  done
}

# Debian's own archives, as apt knows them; others may have what a stranger has not.
list_sources() {
  # shellcheck disable=SC2016
  apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Origin: Debian' 'Identifier: Packages' \
    | sort -u
}

make_root() {
  local sources option options=()
  sources=$(list_sources)
  if [ -z "$sources" ]; then
    apt-get -y update
    sources=$(list_sources)
  fi
  [ -n "$sources" ] || { echo "apt knows no archive of Debian"; return 1; }
  while read -r option; do
    options+=("--aptopt=$option")
  done < <(apt-config dump | grep -E '^Acquire::(https?::|Retries|ForceIPv|Check-)' | grep -Ev '::User-Agent|Auto-?Detect')
  # As in images of Debian: what is thrown away need not survive a power cut.
  mmdebstrap --variant=minbase --include=git,ca-certificates --dpkgopt=force-unsafe-io "${options[@]}" bookworm "$root" - \
    <<<"$sources"
}

# How this machine reaches the network: names, the authorities it trusts, where npm's packages are.
let_reach_network() {
  local name settings=~/.npmrc
  for name in resolv.conf hosts; do
    [ ! -e "/etc/$name" ] || cp -L --remove-destination "/etc/$name" "$root/etc/"
  done
  [ ! -f "$settings" ] || grep -E '^ *(@[^=]*:)?(registry|proxy|https-proxy|noproxy|strict-ssl) *=' "$settings" \
    >"$root/root/.npmrc" || true
  while IFS= read -r name; do
    environment+=("$name=${!name}")
  done < <(compgen -e | grep -iE '^((https?|no|all)_proxy|npm_config_.*)$')
  if [ -f /etc/ssl/certs/ca-certificates.crt ]; then
    cp /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/authorities.pem"
    environment+=(NODE_EXTRA_CA_CERTS=/etc/ssl/authorities.pem)
  fi
}

# Of HEAD, without what lies about in this checkout.
clone() {
  mkdir -p "$root/src"
  printf '[safe]\n\tdirectory = *\n' >"$folder/gitconfig"
  GIT_CONFIG_GLOBAL="$folder/gitconfig" git clone --quiet --no-hardlinks "$top" "$root/src/planish"
  [ ! -d "$top/../shared" ] || mkdir "$root/src/shared"
}

# Runs in namespaces of mounts and processes: "$0" is the root, "$1" the folder beside the clone. Its first process is a
# shell that waits, as someone has to for processes whose parent is gone.
enter='
set -e
root=$0 shared=$1
shift
mount --bind "$root" "$root"
mount -t proc proc "$root/proc"
mount -t sysfs -o ro sysfs "$root/sys"
if [ -d /sys/fs/cgroup ]; then  # which Slurm looks at
  mount --rbind /sys/fs/cgroup "$root/sys/fs/cgroup"
  for name in $(findmnt -rno TARGET -R "$root/sys/fs/cgroup"); do mount -o remount,bind,ro "$name"; done
fi
mount -t tmpfs -o mode=755 dev "$root/dev"
cp -a /dev/{null,zero,full,random,urandom,tty} "$root/dev/"
ln -s /proc/self/fd "$root/dev/fd"
for name in stdin=0 stdout=1 stderr=2; do ln -s "/proc/self/fd/${name#*=}" "$root/dev/${name%=*}"; done
mkdir "$root/dev/pts" "$root/dev/shm"
mount -t devpts -o newinstance,ptmxmode=666,mode=620,gid=5 devpts "$root/dev/pts"
ln -s pts/ptmx "$root/dev/ptmx"
mount -t tmpfs -o mode=1777 shm "$root/dev/shm"
if [ -d "$root/src/shared" ]; then
  mount --bind "$shared" "$root/src/shared"
  mount -o remount,bind,ro "$root/src/shared"
fi
set +e
chroot "$root" env -i "$@"
exit $?
'

# Runs a command in the clone: fails where it does, or takes longer than it may.
#   inside <name> <minutes> <command>...
inside() {
  local name=$1 minutes=$2 log="$logs/${1//[!a-z]/}.log" began=$SECONDS status=0 took out writer
  shift 2
  say ""
  say "#### $name (bare Debian 12, at most $minutes min)"
  exec {out}> >(tee "$log")
  writer=$!
  # Told to end, ./test still says what it was at.
  unshare --mount --pid --fork --kill-child=KILL bash -c "$enter" "$root" "$(realpath -m "$top/../shared")" \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "${environment[@]}" \
    timeout --kill-after=60 "${minutes}m" sh -c 'cd /src/planish && exec "$@"' sh "$@" \
    </dev/null >&"$out" 2>&1 &
  running=$! ender=KILL
  wait "$running" || status=$?
  running=""
  exec {out}>&-
  wait "$writer"
  took="$(((SECONDS - began) / 60)) min $(((SECONDS - began) % 60)) s"
  if [ "$status" -eq 0 ]; then
    say "#### $name took $took"
  elif [ $((SECONDS - began)) -ge $((60 * minutes)) ]; then
    fail "$name takes longer than the $minutes min that it may, and was ended after $took. Its log: $log"
  else
    fail "$name ended with $status after $took, in a bare Debian 12. Its log: $log"
  fi
}

rm -rf "$logs"
mkdir -p "$logs"
trap clean EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

environment=()
for name in RC_PARAMS PLANISH_WERROR; do
  [ -z "${!name:-}" ] || environment+=("$name=${!name}")
done
say "#### A bare Debian 12 in $root"
began=$SECONDS
export -f make_root list_sources
export root
timeout --kill-after=30 "${root_minutes}m" bash -c 'set -euo pipefail; make_root' >"$logs/root.log" 2>&1 &
running=$!
wait "$running" || { tail -n 20 "$logs/root.log" >&2; cannot "mmdebstrap failed. Its log: $logs/root.log"; }
running=""
let_reach_network
clone
[ -z "$(git -c "safe.directory=$top" -C "$top" status --porcelain)" ] \
  || say "What is changed here and not committed is not checked."
say "#### made in $((SECONDS - began)) s, with commit $(git -C "$root/src/planish" log -1 --format='%h %s')"

example=$(cd "$root/src/planish" && sed -n '/^```python$/,/^```$/{//!p}' README.md)
inside ./quickstart "$quickstart_minutes" ./quickstart
inside 'import planish' 1 env PYTHONPATH=build/release/python python3 -c "$example"
inside ./test "$test_minutes" ./test "$@"
