# Sourced by ./run and ./check: installs what packages.txt names and the machine lacks.
# needs: $root, the folder of packages.txt

plenum_missing_packages() {
  local package
  while read -r package; do
    case $package in '' | '#'*) continue ;; esac
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      echo "$package"
  done <"$1"
}

plenum_install() {
  local missing as_root=
  missing=$(plenum_missing_packages "$1")
  [ -n "$missing" ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "these Debian packages are missing, and there is no apt-get here:" $missing >&2
    return 1
  fi
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || {
      echo "these Debian packages are missing; install them as root:" $missing >&2
      return 1
    }
    as_root=sudo
  fi
  echo "== installing Debian packages:" $missing
  # One retry after reading the package lists anew: on a fresh machine they are missing or old.
  DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -q --no-install-recommends $missing \
    >/dev/null 2>&1 ||
    { $as_root apt-get update -q >/dev/null &&
      DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -q --no-install-recommends \
        $missing >/dev/null; } || {
      echo "apt-get could not install:" $missing >&2
      return 1
    }
}

# Configures and builds a preset into build/PRESET; further arguments are targets.
plenum_build() {
  local preset=$1
  shift
  local log=$root/build/$preset.log
  mkdir -p "$root/build"
  echo "== building ($preset)"
  (cd "$root" && cmake --preset "$preset" >"$log" 2>&1) || { cat "$log" >&2; return 1; }
  (cd "$root" && cmake --build --preset "$preset" ${1:+--target "$@"} >>"$log" 2>&1) ||
    { tail -40 "$log" >&2; echo "the build failed; its log is $log" >&2; return 1; }
}
