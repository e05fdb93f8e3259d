#!/usr/bin/env bash
# Installs the Debian 12 packages that Planish needs and this machine does not have.
#
#   tools/install-packages.sh build        what it takes to build the program
#   tools/install-packages.sh package      that, and what it takes to make Debian packages of it
#   tools/install-packages.sh test         that, and what the tests use
#   tools/install-packages.sh develop      that, and benchmarks, clang and clang-tidy
#
# Where nothing is missing it says nothing and needs neither network nor root.
set -euo pipefail

build=(
  g++ cmake ninja-build ccache
  libexpected-dev libfmt-dev libeigen3-dev libgeos-dev libdxflib-dev nlohmann-json3-dev libcli11-dev
  libceres-dev libnanoflann-dev libccd-dev libxxhash-dev zlib1g-dev libcairo2-dev fonts-dejavu-core
  libnest2d-dev libpolyclipping-dev libboost-dev
  libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev
  libocct-ocaf-dev libocct-data-exchange-dev
  libcpp-httplib-dev pkg-config
  python3-dev python3-numpy pybind11-dev
)
# Where node came from elsewhere, npm came with it, and Debian's package would not go with that.
command -v npm >/dev/null || build+=(nodejs npm)
package=(git build-essential dpkg-dev debhelper dh-python python3)
test=(libgtest-dev libgmock-dev librapidcheck-dev coinor-libcbc-dev python3 python3-ezdxf
  python3-jsonschema poppler-utils clang-format slurmctld slurmd slurm-client munge
  mypy python3-shapely
  lintian mmdebstrap man-db mandoc zsh fish desktop-file-utils appstream shared-mime-info libglib2.0-bin
  librsvg2-bin freecad freecad-python3 xvfb xauth)
command -v chromium >/dev/null || test+=(chromium)
develop=(libbenchmark-dev clang clang-tidy)

case "${1:-}" in
  build) wanted=("${build[@]}") ;;
  package) wanted=("${build[@]}" "${package[@]}") ;;
  test) wanted=("${build[@]}" "${package[@]}" "${test[@]}") ;;
  develop) wanted=("${build[@]}" "${package[@]}" "${test[@]}" "${develop[@]}") ;;
  *) echo "usage: $0 build|package|test|develop" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This is no Debian system; these have to be there some other way (names of Debian 12):" >&2
  printf '  %s\n' "${wanted[@]}" >&2
  exit 1
fi

# dpkg-query also knows packages that were removed; only "installed" counts.
present=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "${wanted[@]}" \
  2>/dev/null | sed -n 's/^installed //p' || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF -- "$package" <<<"$present" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo >/dev/null; then
    as_root=(sudo)
  else
    echo "These packages are missing, and installing them needs root or sudo. As root, run:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
fi

echo "Installing ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o Dpkg::Use-Pty=0)
"${apt[@]}" update
"${apt[@]}" install --no-install-recommends "${missing[@]}"
