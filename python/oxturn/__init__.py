"""oxturn: plans, scores and compares coverage paths.

    import oxturn
    p = oxturn.Problem.read("kitchen.yaml", radius=0.17)
    r = oxturn.plan("boustrophedon", p)
    r.score()["coverage"]

docs/python.md tells more.
"""
import hashlib
import inspect

from ._oxturn import (Context, Infeasible, Map, Plan, Problem, Unsupported, generators, load_plugin, plan, planners,
                      read_results)
from . import _oxturn

__all__ = ["Context", "Infeasible", "Map", "Plan", "Problem", "Unsupported", "columns", "generators", "load_plugin",
           "plan", "planner", "planners", "read_results", "run"]


def planner(cls):
    """Class decorator: makes a planner written in Python known, to plan() and to suites.

    The class has `name`, and if it wants `title`, `citation`, `guarantee`, `capabilities` (a list of "holes", "tether",
    "online", "curvature", "footprint") and `parameters` (a dictionary of defaults, which become keyword arguments of
    the constructor). `plan(self, problem, context)` returns legs: (points, tool), (points, tool, reverse) or
    (points, tool, reverse, width).
    """
    try:
        source, origin = inspect.getsource(cls), inspect.getsourcefile(cls) or "<python>"
    except (OSError, TypeError):  # typed in by hand
        source, origin = repr(vars(cls)), "<python>"
    _oxturn.add_planner(cls, origin, hashlib.sha256(source.encode()).hexdigest())
    return cls


def run(suite, output, *, jobs=1, resume=False, progress=False):
    """Runs a suite (a TOML file) into a results folder; returns its rows as dictionaries."""
    return _oxturn.run(str(suite), str(output), jobs, resume, progress)


def columns(rows):
    """Rows as a dictionary of NumPy arrays: floats with NaN for what is empty, or texts."""
    import numpy
    table = {}
    for name in rows[0] if rows else ():
        cells = [row[name] for row in rows]
        if any(isinstance(cell, str) for cell in cells):
            table[name] = numpy.array([cell or "" for cell in cells])
        else:
            table[name] = numpy.array([numpy.nan if cell is None else cell for cell in cells])
    return table
