# %% [markdown]
# A tour of the Python module, in cells (`# %%`) that Jupyter and most editors know. It also runs as a script.

# %% A map, a robot, a problem
import numpy as np
import oxturn

problem = oxturn.Problem(oxturn.Map.generate("rooms", seed=7), radius=0.2, tool_width=0.4)
print(problem.name, "starts at", problem.start)

# %% Every planner that promises to cover the whole target
figures = []
for planner in oxturn.planners():
    if planner["promise"] != "target" or "tether" in planner["capabilities"]:
        continue
    score = oxturn.plan(planner["name"], problem).score()
    figures.append((score["length_ratio"], planner["name"], score["coverage"], score["turns"]))
for ratio, name, coverage, turns in sorted(figures):
    print(f"{name:16} length ratio {ratio:.3f}  coverage {coverage:.4f}  turns {turns:.0f}")

# %% One parameter, swept
spacings = np.linspace(0.5, 1, 6)
lengths = [oxturn.plan("boustrophedon", problem, spacing=float(s)).length for s in spacings]
for spacing, length in zip(spacings, lengths):
    print(f"spacing {spacing:.1f}: {length:.0f} m")

# %% The same path by hand, scored as strictly: the first half of it
best = oxturn.plan("boustrophedon", problem)
half = oxturn.Plan(problem, best.legs[: len(best.legs) // 2])
print("half of the legs:", half.score()["coverage"])

# %% Planners say why they cannot take a problem
try:
    oxturn.plan("stc", problem, cell_size=50)
except oxturn.Infeasible as reason:
    print("infeasible:", reason)

# %% A picture (in a notebook the last line of a cell is enough: `best`)
with open("tour.svg", "w") as file:
    file.write(best.svg())
