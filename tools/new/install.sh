#!/bin/sh
# Installs, on Debian 12 as root, the packages of oncard in this folder and what the project needs besides.
# Where ONCARD_PACKAGES is the address of a .tar.gz with the packages, it is fetched first.
set -eu
cd "$(dirname "$0")"
export DEBIAN_FRONTEND=noninteractive

if [ -n "${ONCARD_PACKAGES:-}" ]; then
  apt-get update
  apt-get install --yes --no-install-recommends ca-certificates curl
  curl --fail --silent --show-error --location --output packages.tar.gz "$ONCARD_PACKAGES"
  tar -xzf packages.tar.gz
fi
if ! ls ./*.deb > /dev/null 2>&1; then
  echo "packages/ holds no .deb files of oncard: put them there, or set ONCARD_PACKAGES (README.md)" >&2
  echo "packages/ 中没有 oncard 的 .deb 文件：请放入该文件夹，或设置 ONCARD_PACKAGES（README.md）" >&2
  exit 1
fi
apt-get update
apt-get install --yes --no-install-recommends ./*.deb @PACKAGES@
