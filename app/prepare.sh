# SPDX-FileCopyrightText: 2026 the Stratascope authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by app/run and tests/run. Sets `repository`; installs what is missing, and asks no network if nothing is.

export LC_ALL=C.UTF-8
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The packages of app/packages.txt that are not installed.
missing_packages() {
  local wanted installed package
  wanted=$(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$repository/app/packages.txt")
  # One query for all; it exits 1 if it does not know one of them. Multi-arch packages show once an architecture.
  # shellcheck disable=SC2086
  installed=" $(dpkg-query -W -f '${db:Status-Status}=${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed=//p' | tr '\n' ' ') " || true
  for package in $wanted; do
    [[ $installed == *" $package "* ]] || echo "$package"
  done
}

install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "This script installs packages on Debian only; going on with what is here. Needed: see app/packages.txt" >&2
    return 0
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "Missing packages, and neither root nor sudo to install them: ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}" >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q update </dev/null >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 install -y --no-install-recommends \
    "${missing[@]}" </dev/null >&2
}

# Runs a command on a screen of its own, drawn in software.
on_virtual_screen() {
  env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
    xvfb-run -a -s "-screen 0 1600x1000x24 -dpi 96" "$@"
}
