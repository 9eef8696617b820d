#!/usr/bin/env bash
# try_pip.sh SOURCE_DIR BUILD_DIR PYTHON WORK_DIR: `pip install .` into an environment of its own, from what is built already.
set -euo pipefail
rm -rf "$4"
"$3" -m venv --system-site-packages "$4"
OXTURN_BUILD_DIR=$2 "$4/bin/pip" install --quiet --no-index "$1"
cd "$4"
bin/python -c '
import oxturn
assert oxturn.__file__.startswith("'"$4"'"), oxturn.__file__
problem = oxturn.Problem(oxturn.Map.generate("rooms", seed=7), radius=0.17)
assert oxturn.plan("boustrophedon", problem).score()["coverage"] > 0.999'
echo "pip: installed, and plans"
