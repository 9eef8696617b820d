"""write_page.py NAME RESULTS FOLDER: writes the page FOLDER/NAME.md from a results folder of the suite NAME.

A page with a picture of its figures has it in FOLDER/pictures/NAME.svg: `picture(rows)` of its module.
"""
import importlib
import os
import sys

import results


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    name, source, folder = sys.argv[1:]
    module = importlib.import_module(name.replace("-", "_"))
    rows = results.read(source)
    others = {row["suite"] for row in rows} - {name}
    if others or not rows:
        sys.exit(f"page '{name}' is made from the results of suite '{name}', but '{source}' holds "
                 + (f"rows of suite '{others.pop()}'" if others else "no rows"))
    title = module.__doc__.split("\n", 1)[0]
    with open(os.path.join(folder, name + ".md"), "w") as file:
        file.write(f"# {title}\n\nMade by `scripts/pages {name}` from `bench/suites/{name}.toml`; do not edit by "
                   "hand.\n\n"
                   + module.page(rows))
    if hasattr(module, "picture"):
        os.makedirs(os.path.join(folder, "pictures"), exist_ok=True)
        with open(os.path.join(folder, "pictures", name + ".svg"), "w") as file:
            file.write(module.picture(rows))


main()
