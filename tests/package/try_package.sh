#!/usr/bin/env bash
# try_package.sh BUILD_DIR SOURCE_DIR WORK_DIR CXX_FLAGS: installs; builds and runs the consumer; does what docs/plug-ins.md
# says; then tries plug-ins that must be refused.
set -euo pipefail
build=$1 source=$2 work=$3 flags=$4
rm -rf "$work"
export HOME=$work/home CXXFLAGS=$flags CMAKE_GENERATOR=Ninja
mkdir -p "$HOME/clean"
cmake --install "$build" --prefix "$HOME/oxturn" >/dev/null

for file in share/man/man1/oxturn.1 share/bash-completion/completions/oxturn share/zsh/site-functions/_oxturn \
    share/fish/vendor_completions.d/oxturn.fish; do
  [ -s "$HOME/oxturn/$file" ] || { echo "not installed: $file"; exit 1; }
done

cmake -S "$source/tests/package" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$HOME/oxturn" >/dev/null
cmake --build "$work/consumer"
"$work/consumer/consumer"

# The page's second block of commands, in a clean folder. A template of another build type would be refused.
cd "$HOME/clean"
type=$(sed -n 's/^CMAKE_BUILD_TYPE:[A-Z]*=//p' "$build/CMakeCache.txt")
awk '/^```sh$/ {++block; inside = 1; next} /^```$/ {inside = 0} inside && block == 2' "$source/docs/plug-ins.md" |
  sed "s|-DCMAKE_PREFIX_PATH|-DCMAKE_BUILD_TYPE=$type -DCMAKE_PREFIX_PATH|" >commands
bash -euo pipefail commands >/dev/null
python3 - <<'END'
import csv, json
rows = {(row["planner"], row["map_family"]): row for row in csv.DictReader(open("out/runs.csv"))}
assert len(rows) == 4, sorted(rows)
for (planner, family), row in rows.items():
    assert row["outcome"] in ("ok", "partial"), row
    assert float(row["legs"]) >= 1, row
session = json.load(open("out/session.json"))
assert [p["planner"] for p in session["programs"]] == ["perimeter"], session["programs"]
assert [m["metric"] for m in session["plugin_metrics"]] == ["legs"], session["plugin_metrics"]
END

# refused EXPECTED ARGUMENTS...: exit code 2 and one line with EXPECTED in it
refused() {
  local expected=$1 said
  shift
  if said=$(oxturn "$@" 2>&1); then echo "not refused: oxturn $*"; exit 1; fi
  [[ $said == *"$expected"* && $(wc -l <<<"$said") == 1 ]] || { echo "oxturn $* said: $said"; exit 1; }
}
export PATH=$HOME/oxturn/bin:$PATH
plugin=perimeter/build/perimeter.so
refused "no such file: 'nothing.so'" list planners --plugin nothing.so
echo text >text.so
refused "plug-in 'text.so' cannot be loaded" list planners --plugin text.so
echo 'int nothing;' | c++ -shared -fPIC -x c++ - -o empty.so
refused "'empty.so' is no plug-in of oxturn" list planners --plugin empty.so
refused "there is a planner 'perimeter' already" list planners --plugin $plugin --plugin $plugin
echo 'extern "C" const char* oxturn_plugin_abi() { return "oxturn 0.0.1"; }' | c++ -shared -fPIC -x c++ - -o old.so
refused "was built for [oxturn 0.0.1], and this program is [oxturn" list planners --plugin old.so
# Another version of the plug-in: results are not mixed.
printf 'more' >>$plugin
refused "holds results of another version of planner 'perimeter'" run mine.toml -o out --resume --plugin $plugin
echo "plug-ins: as documented"
