"""try_external.py OXTURN PAGE: writes the page's first python block to sweep.py and runs its first sh block, as a
reader would, in a clean folder; then looks for the rows that the page promises."""
import csv
import os
import re
import subprocess
import sys
import tempfile

program, page = map(os.path.abspath, sys.argv[1:])
with open(page) as file:
    text = file.read()
python, shell = (re.search(r"```" + kind + r"\n(.*?)```", text, re.S).group(1) for kind in ("python", "sh"))
with tempfile.TemporaryDirectory() as folder:
    with open(os.path.join(folder, "sweep.py"), "w") as file:
        file.write(python)
    path = os.path.dirname(program) + os.pathsep + os.environ["PATH"]
    subprocess.run(["bash", "-e", "-c", shell], cwd=folder, env=dict(os.environ, PATH=path), check=True, timeout=300)
    with open(os.path.join(folder, "out", "runs.csv"), newline="") as file:
        rows = {row["variant"]: row for row in csv.DictReader(file)}
assert os.path.basename(program) == "oxturn"
assert {"zigzag", "stc", "sweep", "sweep[spacing=0.5]"} <= set(rows), sorted(rows)
assert all(row["outcome"] in ("ok", "partial") for row in rows.values()), rows
assert rows["sweep"]["outcome"] == "ok" and float(rows["sweep"]["coverage"]) > 0.99
