#!/bin/sh
# Installs the Debian packages that building, testing and checking arris need; quick when they are
# all there. docs/dependencies.md says what each is for.
set -eu

build="g++ cmake ninja-build make libcgal-dev libgmp-dev libmpfr-dev libboost-dev
  nlohmann-json3-dev libnanoflann-dev libeigen3-dev libcli11-dev libembree-dev libpng-dev"
tests="libgtest-dev librapidcheck-dev"
checks="clang libclang-rt-14-dev clang-format clang-tidy"

command -v dpkg-query >/dev/null || {
  echo "install-deps: this is not a Debian system; see docs/dependencies.md" >&2
  exit 0
}

bench="python3"

missing=""
for package in $build $tests $checks $bench; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" = 0 ]; then
  run=""
elif command -v sudo >/dev/null; then
  run="sudo"
else
  echo "install-deps: as root, please: apt-get install$missing" >&2
  exit 1
fi
echo "install-deps: installing$missing"
$run apt-get update -qq
# shellcheck disable=SC2086  # the list is split on purpose
DEBIAN_FRONTEND=noninteractive $run apt-get install -y -qq --no-install-recommends $missing
