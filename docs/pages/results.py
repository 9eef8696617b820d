"""Rows of a results folder, as `oxturn run` leaves it, and what pages share: groups, medians, Markdown tables."""
import csv
import math
import os
import statistics


class Row(dict):
    def number(self, column):
        text = self.get(column, "")
        return float(text) if text else None

    @property
    def valid(self):
        return self["outcome"] in ("ok", "partial")

    def settings(self):
        return dict(item.split("=", 1) for item in self["params"].split(";") if item)

    def over_limit(self):
        """Metres by which the tether was pulled over its limit, 0 within rounding; None if it could not be followed."""
        limit, longest = self.number("tether_limit_m"), self.number("tether_max_m")
        if limit is None or longest is None:
            return None
        return longest - limit if longest - limit > 1e-6 * limit else 0.0

    def entangled(self):
        value = self.number("tether_entangled")
        return None if value is None else value != 0


def read(folder):
    with open(os.path.join(folder, "runs.csv"), newline="") as file:
        latest = {row["run_id"]: Row(row) for row in csv.DictReader(file)}  # of several attempts the last
    return list(latest.values())


def groups(rows, key):
    """{key(row): rows}, in order of appearance."""
    result = {}
    for row in rows:
        result.setdefault(key(row), []).append(row)
    return result


def by_problem(rows):
    """One group a map and robot; titles name the robot only where there are several."""
    several = len({row["robot"] for row in rows}) > 1
    return groups(rows, lambda row: f"{row['map']} ({row['robot']})" if several else row["map"])


def median(values):
    values = [value for value in values if value is not None]
    return statistics.median(values) if values else None


def geometric_mean(values):
    """None if there are no values, or one of them is None or not positive."""
    values = list(values)
    if not values or any(value is None or value <= 0 for value in values):
        return None
    return math.exp(sum(map(math.log, values)) / len(values))


def least(values):
    return min((value for value in values if value is not None), default=None)


def greatest(values):
    return max((value for value in values if value is not None), default=None)


def fixed(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def escaped(text):
    for char in "\\|*`[]":
        text = text.replace(char, "\\" + char)
    return text.replace("<", "&lt;").replace("\n", " ")


def table(align, head, rows):
    """Markdown, padded so that it reads well as plain text too. `align`: a letter l or r for each column."""
    width = [max(3, *(len(row[i]) for row in [head] + rows)) for i in range(len(head))]

    def line(cells):
        padded = (cell.ljust(w) if a == "l" else cell.rjust(w) for cell, w, a in zip(cells, width, align))
        return "| " + " | ".join(padded) + " |\n"

    rule = ("-" * w if a == "l" else "-" * (w - 1) + ":" for w, a in zip(width, align))
    return line(head) + "| " + " | ".join(rule) + " |\n" + "".join(line(row) for row in rows)
