#!/usr/bin/env bash
# Installs what is missing of the Debian 12 packages that Planewright is built, run and tested with.
# Nothing is fetched at build time. Does nothing, and needs no network and no rights, when all are there.
set -euo pipefail

packages=(
  # build
  g++ cmake ninja-build pkg-config ccache git ca-certificates
  # meshes, linear algebra, optimisation
  libeigen3-dev libexpected-dev libopenmesh-dev coinor-libipopt-dev libmumps-seq-dev libopenblas0
  libcgal-dev
  # command line, JSON
  libcli11-dev nlohmann-json3-dev
  # workshop: nesting, drawings, solids, and the readers that check them
  libnest2d-dev libpolyclipping-dev libnlopt-dev libnlopt-cxx-dev libcairo2-dev libpugixml-dev lib3mf-dev libtinygltf-dev
  libdime-dev libxml2-dev libqpdf-dev libtinyobjloader-dev libassimp-dev libminizip-dev
  # window and pictures
  libglfw3-dev libimgui-dev libglm-dev libepoxy-dev libfreetype-dev libstb-dev libegl1 libegl-mesa0 libgl1-mesa-dri
  fonts-inter fonts-roboto-unhinted fonts-font-awesome
  # tests
  libgtest-dev xvfb xauth xdotool python3 python3-ezdxf
)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ "${#missing[@]}" -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "deps.sh: these packages are missing and there is no apt-get to install them: ${missing[*]}" >&2
  exit 1
fi
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "deps.sh: run as root (or install sudo): apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${#missing[@]} packages: ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
