"""extract.py PAGE N OUTPUT: writes the N-th ```cpp block (from 0) of a page to a file, if it has changed."""
import re
import sys

page, number, output = sys.argv[1:]
with open(page) as file:
    block = re.findall(r"```cpp\n(.*?)```", file.read(), re.S)[int(number)]
try:
    with open(output) as file:
        same = file.read() == block
except FileNotFoundError:
    same = False
if not same:
    with open(output, "w") as file:
        file.write(block)
