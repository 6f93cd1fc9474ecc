# SPDX-License-Identifier: MIT
# install_packages PACKAGE...: installs those Debian packages that are missing, as root or through sudo, and says
# what it does. Nothing else of the system is touched.
install_packages() {
  local package missing=() as_root=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "these packages are missing, and there is no sudo: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  echo "installing with apt-get: ${missing[*]}"
  "${as_root[@]}" apt-get update -q >/dev/null
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >/dev/null
}

# npm and node, wherever they come from: many machines have them from elsewhere, and Debian's are large.
npm_packages() { command -v npm >/dev/null && command -v node >/dev/null || echo nodejs npm; }

# runs_32_bits: whether this kernel runs x86 programs of 32 bits; some are built or started without. Tries one that only exits.
runs_32_bits() {
  local program status=0
  program=$(mktemp)
  base64 -d >"$program" <<<f0VMRgEBAQAAAAAAAAAAAAIAAwABAAAAVIAECDQAAAAAAAAAAAAAADQAIAABAAAAAAAAAAEAAAAAAAAAAIAECACABAhbAAAAWwAAAAUAAAAAEAAAMduNQwHNgA==
  chmod +x "$program"
  "$program" 2>/dev/null || status=1
  rm "$program"
  return $status
}

# An emulator of such programs, where they do not run.
emulator_packages() { runs_32_bits || echo qemu-user; }

# What a build of the tools takes. zlib1g-dev: libassimp-dev's CMake file links libz.so without depending on it.
build_packages() { echo cmake ninja-build g++ libassimp-dev zlib1g-dev libcli11-dev libmeshoptimizer-dev libgif-dev libimagequant-dev libstb-dev nlohmann-json3-dev libgpiod-dev libdrm-dev catch2; }
