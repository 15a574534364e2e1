#!/bin/sh
# Installs what a machine without a desktop needs to show the inspector to nobody: a virtual
# screen, a software OpenGL, and tools that click, copy and take pictures. Debian or Ubuntu; may be run
# again at any time. A machine with a desktop needs none of it.
set -eu

packages="xvfb xauth xdotool xclip imagemagick libgl1-mesa-dri libgl1 libx11-6 libx11-xcb1 libxcursor1
libxi6 libxkbcommon-x11-0"

missing=
for package in $packages; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "everything is there"
    exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null; then
    as_root=sudo
else
    echo "error: root or sudo is needed to install:$missing" >&2
    exit 2
fi
$as_root apt-get update
# shellcheck disable=SC2086 # a list of words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
