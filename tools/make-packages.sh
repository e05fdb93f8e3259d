#!/usr/bin/env bash
# Makes the Debian packages of Planish, on Debian 12.
#
#   tools/make-packages.sh OUTDIR        puts the .deb files into OUTDIR
#
# Installs the Debian packages that this takes and builds in build/package, without tests. Debian
# packages that have nothing to hold (the Python module, say, where it is not built) are left out
# and named. The same commit gives the same bytes (docs/packages.md). PLANISH_WERROR=ON makes
# warnings errors. On standard output are the names of what was made.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [ $# -ne 1 ] || [[ $1 == -* ]]; then
  echo "usage: $0 OUTDIR" >&2
  exit 2
fi
mkdir -p -- "$1"
out=$(cd -- "$1" && pwd)
. "$root/tools/steps.sh"

tree="$root/build/package"
# As Debian's own tools take it.
maintainer="${DEBFULLNAME:-Planish maintainers} <${DEBEMAIL:-planish@packages.invalid}>"
# Root may pack what belongs to someone else.
git=(git -c "safe.directory=$root" -C "$root")

# The version is that of the project, and of the commit where it is not the one that was released:
# 0.2.0, before it 0.2.0~git646.g3d44c98, after it 0.2.0+git650.g0123abc; "changed" where files
# differ from the commit. Without git, SOURCE_DATE_EPOCH and the project's version say it.
read_version() {
  local project commit tag
  project=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")
  if ! "${git[@]}" rev-parse --verify --quiet HEAD >/dev/null; then
    version=$project
    export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(stat -c %Y "$root"/CHANGELOG.md)}"
    note="Made from the sources of $project."
    return
  fi
  tag="v$project"
  commit=$("${git[@]}" rev-list --count HEAD).g$("${git[@]}" rev-parse --short=7 HEAD)
  if [ "$("${git[@]}" rev-parse --verify --quiet "$tag^{commit}")" = "$("${git[@]}" rev-parse HEAD)" ]; then
    version=$project
  elif "${git[@]}" merge-base --is-ancestor "$tag" HEAD 2>/dev/null; then
    version="$project+git$commit"
  else
    version="$project~git$commit"
  fi
  [ -z "$("${git[@]}" status --porcelain --untracked-files=no)" ] || version="$version.changed"
  export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$("${git[@]}" log -1 --format=%ct)}"
  note="Made from the commit $("${git[@]}" rev-parse HEAD)."
}

# Every run, so that a new module or workbench is noticed; what has not changed is not built again.
build_tree() {
  cmake -S "$root" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" -DCMAKE_INSTALL_PREFIX=/usr -DPLANISH_TESTS=OFF \
    -DPLANISH_ZSH_DIR=share/zsh/vendor-completions "-DPLANISH_WERROR=${PLANISH_WERROR:-OFF}"
  # Pages carry the day of the commit.
  rm -f "$tree/written/stamp"
  ninja -C "$tree" -j "$(nproc)"
}

# Debian packages whose component installs nothing.
find_empty() {
  local package probe="$tree/probe"
  empty=()
  while read -r package; do
    rm -rf "$probe"
    mkdir -p "$probe"
    DESTDIR="$probe" cmake --install "$tree" --component "$package" >/dev/null
    [ -n "$(find "$probe" ! -type d -print -quit)" ] || empty+=("$package")
  done < <(sed -n 's/^Package: //p' "$root/packaging/debian/control")
  rm -rf "$probe"
}

make_debs() {
  local made="$tree/debian" profiles=nocheck package
  rm -rf "$made"
  mkdir -p "$made"
  cp -R "$root/packaging/debian" "$made/planish"
  mkdir "$made/source"
  mv "$made/planish" "$made/source/debian"
  sed -i "s|@MAINTAINER@|$maintainer|" "$made/source/debian/control"
  printf 'planish (%s-1~deb12) bookworm; urgency=medium\n\n  * %s\n\n -- %s  %s\n' "$version" "$note" \
    "$maintainer" "$(date --utc --rfc-email --date "@$SOURCE_DATE_EPOCH")" >"$made/source/debian/changelog"
  for package in "${empty[@]}"; do profiles+=",pkg.planish.no-$package"; done
  (cd "$made/source" && PLANISH_TREE="$tree" PLANISH_SOURCE="$root" PLANISH_LOADED=libcairo2 \
    dpkg-buildpackage --build=binary --unsigned-changes "--build-profiles=$profiles")
}

quiet_step "install packages" "$root/tools/install-packages.sh" package
read_version
quiet_step "build for packages" build_tree
find_empty
quiet_step "make packages" make_debs
for package in "${empty[@]}"; do
  say "$package is left out: nothing of it is in the sources, or built from them"
done
rm -f -- "$out"/{planish,libplanish1,libplanish-dev,python3-planish,freecad-planish}_*.deb
for deb in "$tree"/debian/*.deb; do
  install -m 644 -- "$deb" "$out/"
  printf '%s\n' "$out/$(basename "$deb")"
done
