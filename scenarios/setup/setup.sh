# Sourced by scenarios/run, tests/run, perf/run and .ci/run: installs what is missing, configures, builds.
# All it says goes to standard error; standard output belongs to the command that is run.
# shellcheck shell=bash

repository=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
build_directory=$repository/build
packages_changed=0 # 1: what configuring found before may not be all there is now

say() { printf '%s\n' "$*" >&2; }

# packages_of SECTION...: the names in packages.txt, one a line.
packages_of() {
  awk -v wanted=" $* " '
    { sub(/#.*/, "") }
    /^\[/ { gsub(/[][ \t]/, ""); inside = index(wanted, " " $0 " "); next }
    inside && NF { print $1 }' "$repository/scenarios/setup/packages.txt"
}

# missing_packages SECTION...: those that are not installed.
missing_packages() {
  local names
  mapfile -t names < <(packages_of "$@")
  # dpkg-query fails if it has never heard of a name; those it knows are listed all the same.
  { dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${names[@]}" 2>/dev/null || true; } |
    awk -v names="${names[*]}" '
      $1 == "installed" { there[$2] = 1 }
      END { n = split(names, name, " "); for (i = 1; i <= n; i++) if (!(name[i] in there)) print name[i] }'
}

# apt_install PACKAGE...: as root or through sudo. Package lists are fetched only if the ones at hand do not do.
apt_install() {
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300) log status=0
  local install=(install -y --no-install-recommends "$@")
  if [[ $(id -u) != 0 ]]; then
    apt=(sudo -n "${apt[@]}")
  fi
  log=$(mktemp)
  say "Installing: $*"
  "${apt[@]}" "${install[@]}" </dev/null >"$log" 2>&1 ||
    { "${apt[@]}" update && "${apt[@]}" "${install[@]}"; } </dev/null >"$log" 2>&1 || status=$?
  if [[ $status != 0 ]]; then
    tail -n 30 "$log" >&2
  fi
  rm -f "$log"
  return "$status"
}

# require_packages SECTION...: installs what is missing, or prints the one line to type and exits 2.
require_packages() {
  local missing line
  if ! command -v dpkg-query >/dev/null; then
    return 0 # not Debian: configuring names what it does not find
  fi
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} == 0 ]]; then
    return 0
  fi
  line="apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
  if [[ $(id -u) == 0 ]] || sudo -n true 2>/dev/null; then
    if apt_install "${missing[@]}"; then
      packages_changed=1
      return 0
    fi
    say "Installing failed (above). Once that is solved, as root:"
  elif command -v sudo >/dev/null; then
    say "Packages are missing, and installing them needs your password. Type:"
    line="sudo sh -c '$line'"
  else
    say "Packages are missing, and only root can install them. Type:"
    line="su -c '$line'"
  fi
  say "$line"
  exit 2
}

# cached DIRECTORY LINE: does the configuration hold this line?
cached() { [[ -f $1/CMakeCache.txt ]] && grep -qx -- "$2" "$1/CMakeCache.txt"; }

# ours DIRECTORY: is it a finished configuration of this very checkout, which may have been moved?
ours() {
  [[ -f $1/build.ninja || -f $1/Makefile ]] &&
    grep -qxF -- "CMAKE_HOME_DIRECTORY:INTERNAL=$repository" "$1/CMakeCache.txt"
}

# configured DIRECTORY PART...: is it ours, optimised, and with these parts?
configured() {
  local part
  ours "$1" && cached "$1" 'CMAKE_BUILD_TYPE:[A-Z]*=Release' || return 1
  for part in "${@:2}"; do
    cached "$1" "$part:BOOL=ON" || return 1
  done
}

# configure DIRECTORY [cmake options...]: a Release build unless the options say otherwise.
configure() {
  local directory=$1 log=$1/configure.log
  local options=(-DCMAKE_BUILD_TYPE=Release "${@:2}")
  if ! ours "$directory"; then
    options+=(--fresh)
    if command -v ninja >/dev/null; then
      options+=(-G Ninja)
    fi
  fi
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  mkdir -p "$directory"
  say "Configuring ${directory#"$repository"/}"
  if ! cmake -S "$repository" -B "$directory" "${options[@]}" >"$log" 2>&1; then
    cat "$log" >&2
    say "Configuring failed (above, and in $log)."
    return 1
  fi
}

# Of a build's output, show how far it is: in place on a terminal, else every tenth of the way.
show_progress() {
  local line last=-1 shown=0 tenth
  while IFS= read -r line; do
    if [[ ! $line =~ ^\[\ *([0-9]+)/([0-9]+)\] || $line == *globbed* || $line == *Re-running* ]]; then
      continue
    fi
    if [[ -t 2 ]]; then
      printf '\r\033[K%s' "${line:0:79}" >&2
      shown=1
      continue
    fi
    tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
    if [[ $tenth != "$last" ]]; then
      say "Building: ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
      last=$tenth
    fi
  done
  if [[ $shown == 1 ]]; then
    printf '\r\033[K' >&2
  fi
}

# build DIRECTORY TARGET...: prints what the compiler said if it fails.
build() {
  local directory=$1 log=$1/build.log
  local command=(cmake --build "$directory" --target "${@:2}")
  if [[ -z ${CMAKE_BUILD_PARALLEL_LEVEL-} ]]; then
    command+=(--parallel "$(nproc)")
  fi
  if ! "${command[@]}" 2>&1 | tee "$log" | show_progress; then
    { grep -m 1 -A 80 -E '^FAILED:|^CMake Error|error:|Error [0-9]' "$log" || tail -n 80 "$log"; } >&2
    say "Building failed (above; all of it in $log)."
    return 1
  fi
}

# prepare TARGET [PART...]: installs what these parts (BALLPARK_TESTS, BALLPARK_PERF) need and builds the target in
# build/, for one caller at a time. Parts that nobody asked for yet stay out, so that their packages may be missing.
prepare() {
  local target=$1 part sections=(build) options=()
  for part in BALLPARK_TESTS BALLPARK_PERF; do
    if [[ " ${*:2} " == *" $part "* ]]; then
      sections+=("$(tr '[:upper:]' '[:lower:]' <<<"${part#BALLPARK_}")")
      options+=("-D$part=ON")
    elif cached "$build_directory" "$part:BOOL=ON"; then
      options+=("-D$part=ON")
    else
      options+=("-D$part=OFF")
    fi
  done
  require_packages "${sections[@]}"
  mkdir -p "$build_directory"
  if command -v flock >/dev/null; then
    exec 9>"$build_directory/.lock"
    flock 9
  fi
  if [[ $packages_changed == 1 ]] || ! configured "$build_directory" "${@:2}"; then
    configure "$build_directory" "${options[@]}" || exit 2
  fi
  build "$build_directory" "$target" || exit 2
  exec 9>&-
}
