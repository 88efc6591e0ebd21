#!/bin/sh
# Installs what the benchmark compares arris with; each part is optional, and the benchmark says
# which it found.
#   scripts/install-peers.sh [BUILD_DIRECTORY]    as root or with sudo; needs the network, 2 GB of
#                                                 disk and, for CGAL's part, 3.3 GB of memory
# CGAL's methods are compiled into BUILD_DIRECTORY/cgal_peers, Open3D and PyMeshLab come by pip into
# a virtual environment in BUILD_DIRECTORY/peers.
set -u
build=${1:-build}
venv=$build/peers
status=0

missing() {
  echo "install-peers: no $1" >&2
  status=1
}

root=""
[ "$(id -u)" = 0 ] || root="sudo"
if command -v apt-get >/dev/null; then
  # The libraries are what Open3D and PyMeshLab load on a machine without a display.
  $root apt-get update -qq
  DEBIAN_FRONTEND=noninteractive $root apt-get install -y -qq --no-install-recommends \
    libeigen3-dev python3 python3-venv libusb-1.0-0 libgl1 libegl1 libgomp1 libx11-6 ||
    echo "install-peers: not all Debian packages could be installed" >&2
fi

{ cmake -S . -B "$build" -DARRIS_BUILD_BENCH=ON >/dev/null &&
  cmake --build "$build" --target cgal_peers; } || missing "CGAL"

[ -x "$venv/bin/python" ] || python3 -m venv "$venv" || missing "virtual environment"
for package in open3d pymeshlab; do
  "$venv/bin/python" -m pip install --quiet "$package" || { missing "$package"; continue; }
  "$venv/bin/python" -c "import $package" || missing "$package (installed, but not importable)"
done
exit $status
