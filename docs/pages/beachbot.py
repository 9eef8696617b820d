"""Drawings of the kinds of BeachBot

Each claim is that of Vollprecht 2014; beside it what runs of the suite show.
"""
from results import escaped, fixed, groups, least, table

INTRODUCTION = """\
Nine drawings of our own ([drawings/](drawings/)) of the kinds that Vollprecht 2014 drew with a robot that rakes sand:
a line drawing of an animal, a closed polygon round other elements, script and sans-serif letters (from the Hershey
fonts), a logo with filled areas, letters without and with holes, houses, and a crown. They are drawn on a canvas of
20 x 15 m with a margin of 1.7 m by a robot of 0.2 m radius with a tool of 0.42 m that turns on the spot (`spot`), and
by one with a least turning radius of 0.5 m (`curves`).
`beachbot` is the planner with its defaults; `published` does what the source
says. `zigzag` knows nothing of strokes. [drawings.md](drawings.md) explains the columns.
"""
COLUMNS = [("path_m", 0), ("tool_up_m", 1), ("stroke_share", 4), ("fill_share", 4), ("fill_share_reachable", 4),
           ("over_finished_m", 2), ("curvature_violations", 0), ("overlap", 2)]
EDITED = "[edits="
LETTERS = ("letters-plain", "letters-holes", "crown")


def name_of(row):
    return "horse, two enforced connections" if EDITED in row["map"] else row["map"].split("[")[0]


def found(rows, robot, params):
    """{drawing: row} of the planner with these parameters and no others."""
    return {name_of(row): row for row in rows
            if row["robot"] == robot and row["planner"] == "beachbot" and row["params"] == params}


def total(rows, column):
    """Over the rows that have it."""
    return sum(row.number(column) or 0 for row in rows)


def pairs(rows, robot, params, base=""):
    """Rows of both variants on the drawings on which both have a path."""
    ours, others = found(rows, robot, base), found(rows, robot, params)
    names = [name for name in ours if name in others and ours[name].number("path_m") is not None
             and others[name].number("path_m") is not None]
    return [ours[name] for name in names], [others[name] for name in names]


def metres(rows, column="tool_up_m"):
    return f"{total(rows, column):.1f} m"


def containment(rows):
    ours, literal = pairs(rows, "spot", "containment=literal")
    return (f"inside first: {metres(ours)} with the tool up and {metres(ours, 'over_finished_m')} over finished work; "
            f"only no direct connection inwards: {metres(literal)} and {metres(literal, 'over_finished_m')} "
            f"({len(ours)} paths: the nine drawings, and the horse with two connections enforced)")


def enforced(rows):
    both = found(rows, "spot", "")
    free, bound = both.get("horse"), both.get("horse, two enforced connections")
    if free is None or bound is None:
        return "not run"
    return (f"horse, two of them: {metres([free])} with the tool up without, {metres([bound])} with; strokes drawn "
            f"{fixed(bound.number('stroke_share'), 4)}")


def heuristic(rows):
    """The source's control points against those that are checked."""
    ours, literal = pairs(rows, "curves", "variant=published")
    sharp = lambda some: total(some, "curvature_violations")
    return (f"as published: {len([r for r in literal if r.valid])} of {len(literal)} paths can be driven, "
            f"{sharp(literal):.0f} bends too sharp, {metres(literal)} with the tool up; checked, and others tried "
            f"where they fail: "
            f"{len([r for r in ours if r.valid])} of {len(ours)}, {sharp(ours):.0f} bends, {metres(ours)}")


def fills(rows):
    parts = []
    for params, name in (("", "spiral"), ("fill=zigzag", "zigzag"), ("fill=contour", "contour")):
        some = [row for drawing, row in found(rows, "spot", params).items() if drawing in LETTERS]
        parts.append(f"{name}: " + ", ".join(
            f"{name_of(row)} {fixed(row.number('path_m'), 0)} m (overlap {fixed(row.number('overlap'), 2)})"
            for row in some))
    return "; ".join(parts)


def small_parts(rows):
    ours, published = pairs(rows, "spot", "variant=published")
    share = lambda some: fixed(least(row.number("fill_share") for row in some), 4)
    return f"least share of a drawing's fills: published {share(published)}, all widths of the tool {share(ours)}"


def round_finished(rows):
    parts = []
    for params, name in (("", "round it"), ("finished=weight", "a weight on such connections"),
                         ("finished=ignore", "not minded")):
        some = list(found(rows, "spot", params).values())
        parts.append(f"{name}: {metres(some, 'over_finished_m')} over it, {metres(some)} with the tool up")
    return "; ".join(parts)


CLAIMS = [
    ("elements inside others are drawn first, so that the robot need not enter them again (2.3.2)", containment),
    ("a person may enforce connections (2.3.2)", enforced),
    ("moving control points apart makes connections smooth (2.4)", heuristic),
    ("the spiral suits convex areas; concave letters need more (2.2)", fills),
    ("cutting areas into parts loses small ones (2.2, 4)", small_parts),
    ("outlook: transits that go round what is finished (5)", round_finished),
]


def claims(rows):
    return table("ll", ["claim of the source", "measured"], [[claim, escaped(say(rows))] for claim, say in CLAIMS])


def runs(rows):
    text = ""
    for robot, some in groups(rows, lambda row: row["robot"]).items():
        lines = [[name_of(row), f"`{row['variant']}`", row["outcome"]]
                 + [fixed(row.number(column), digits) for column, digits in COLUMNS] for row in some]
        text += f"\n### Robot `{robot}`\n\n" + table("lll" + "r" * len(COLUMNS), ["drawing", "planner", "outcome"]
                                                      + [column for column, _ in COLUMNS], lines)
    return text


def reasons(rows):
    lines = [[row["robot"], name_of(row), f"`{row['variant']}`", escaped(row["reason"])] for row in rows
             if row["planner"] == "beachbot" and "published" not in row["variant"] and row["outcome"] != "ok"]
    return table("llll", ["robot", "drawing", "planner", "reason"], lines) if lines else "None.\n"


def page(rows):
    return (INTRODUCTION + "\n## Claims\n\n" + claims(rows) + "\n## Paths of ours that are not ok\n\n" + reasons(rows)
            + "\n## Each run\n" + runs(rows))
