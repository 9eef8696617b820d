"""Pages from rows written by hand: every figure was worked out on paper. Usage: pages_test.py SOURCE_DIR"""
import glob
import importlib
import os
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

SOURCE = sys.argv.pop(1)
sys.path.insert(0, os.path.join(SOURCE, "docs/pages"))
import results  # noqa: E402


def row(suite, map_name, planner, params, outcome, **more):
    cells = {"suite": suite, "map": map_name, "map_sha256": map_name, "robot": "tied", "repeat": "1",
             "planner": planner, "params": params, "outcome": outcome, "reason": "", "path_sha256": "",
             "plan_wall_s": "123.456", "variant": f"{planner}[{params}]" if params else planner}
    return results.Row(cells, **more)


def driven(metres, coverage, target, longest, crossings="0", wound="0", **more):
    return dict(path_m=metres, coverage=coverage, target_m2=target, tether_limit_m="10", tether_max_m=longest,
                tether_crossings=crossings, tether_entangled=wound, length_ratio="1.5", **more)


def page(name, rows):
    return importlib.import_module(name.replace("-", "_")).page(rows)


def line(text, name, n=0):
    """The cells of the n-th table line whose first cell is `name`."""
    lines = [[cell.strip() for cell in one.replace("\\|", "/").split("|")[1:-1]] for one in text.split("\n")]
    return [cells for cells in lines if cells and cells[0] == name][n]


def berg_rows():
    s = "berg-table-4-1"
    return [row(s, "room", "shnaps-rimon", "", "ok", **driven("1250", "0.98", "0.9", "10")),
            row(s, "room", "berg", "trim=none", "invalid", **driven("100", "0.941", "0.9", "10.5", "2")),
            row(s, "room", "berg", "order=dfs", "partial", **driven("110", "0.95", "0.9", "10")),
            row(s, "hall", "shnaps-rimon", "", "ok", **driven("3000", "0.97", "0.9", "10")),
            row(s, "hall", "berg", "trim=none", "partial", **driven("200", "0.93", "0.9", "9")),
            row(s, "hall", "berg", "order=dfs", "crash")]


def leashed_rows():
    """Two tethers on m1, of which the second reaches half of the map; on m2 the leashed run fails."""
    s = "leashed"
    rows = [row(s, "m1", "zigzag", "ignore_tether=true", "ok", **driven("100", "1", "20", "14", "4", "1")),
            row(s, "m1", "boustrophedon", "ignore_tether=true", "ok", **driven("80", "1", "20", "10")),
            row(s, "m1", "leashed", "planner=zigzag", "ok", **driven("90", "0.75", "20", "10")),
            row(s, "m1", "leashed", "", "ok", **driven("88", "1", "20", "9")),
            row(s, "m1", "boustrophedon", "ignore_tether=true", "ok", **driven("80", "1", "10", "25")),
            row(s, "m1", "leashed", "", "ok", **driven("60", "1", "10", "10")),
            row(s, "m2", "zigzag", "ignore_tether=true;partition=none", "ok", **driven("50", "1", "20", "10")),
            row(s, "m2", "leashed", "planner=zigzag", "error", reason="no | path")]
    for i in (1, 4):
        rows[i]["path_sha256"] = "same"
    for i in (4, 5):
        rows[i]["robot"] = "short"
    return rows


def stc_rows():
    s, published = "stc-loops", "close_loops=false;epsilon=0.05;fill=none"
    data = [("m1", "stc", "", "partial", "0.8", "80"), ("m1", "stc-loops", published, "partial", "0.95", "120"),
            ("m1", "stc-loops", "", "ok", "0.996", "130"), ("m2", "stc", "", "infeasible", "", ""),
            ("m2", "stc-loops", published, "partial", "0.97", "20"), ("m2", "stc-loops", "", "ok", "0.998", "25")]
    return [row(s, m, p, params, outcome, coverage=c, path_m=metres, length_ratio="1.5")
            for m, p, params, outcome, c, metres in data]


def online_rows():
    """On m1 both runs are valid, on m2 the one by lidar is not; the default order has no run with the map."""
    s, lidar = "tether-online", "sensing=lidar"

    def run(metres, coverage, **more):
        return driven(metres, coverage, "20", "9", coverage_lower=coverage, **more)

    return [row(s, "m1", "berg", "order=dfs", "ok", **run("100", "1")),
            row(s, "m1", "berg", "order=dfs;" + lidar, "ok", **run("130", "0.997")),
            row(s, "m1", "berg", lidar, "ok", **run("90", "1")),
            row(s, "m2", "berg", "order=dfs", "ok", **run("100", "1")),
            row(s, "m2", "berg", "order=dfs;" + lidar, "invalid", **run("100", "0.5", reason="a | wall"))]


def growth_rows():
    """zigzag grows by n^1 and n^1.5 between 10^4 and 10^6 cells; stc is too fast to have an order, and crashes once."""
    def run(planner, family, decade, seconds, outcome="ok", rss="2000000"):
        return row("growth", f"{family}-1", planner, "", outcome, map_family=family, map_area_m2=str(0.08 * 10**decade),
                   tool_width_m="0.4", plan_cpu_s=seconds, peak_rss_bytes=rss)

    return [run("zigzag", "rooms", 4, "0.01"), run("zigzag", "rooms", 6, "1.0", rss="31000000"),
            run("zigzag", "cave", 4, "0.03"), run("zigzag", "cave", 6, "30.0"),
            run("stc", "rooms", 4, "0.001"), run("stc", "rooms", 6, "", "crash"),
            run("berg", "rooms", 4, "", "unsupported")]


def drivable_rows():
    """On m2 the tractor has no path."""
    data = [("m1", "spot", "ok", "100", "1"), ("m1", "tractor", "partial", "120", "0.9"),
            ("m2", "spot", "ok", "50", "1"), ("m2", "tractor", "infeasible", "", "")]
    return [row("drivable", m, "contour", "", outcome, robot=robot, path_m=metres, mission_s=metres, transit_m="10",
                coverage=c, curvature_violations="0", cusps="0") for m, robot, outcome, metres, c in data]


def cell_order_rows():
    """The generalised tour is a tenth shorter on m1 and has no path on m2."""
    data = [("m1", "", "ok", "100", "0.02"), ("m1", "order=gtsp", "ok", "90", "0.5"),
            ("m2", "", "ok", "50", "0.02"), ("m2", "order=gtsp", "timeout", "", "")]
    return [row("cell-order", m, "boustrophedon", params, outcome, map_family="field", path_m=metres, mission_s=metres,
                coverage="1", plan_cpu_s=seconds) for m, params, outcome, metres, seconds in data]


def beachbot_rows():
    """A horse with and without enforced connections, a crown; the published planner's path of it is not valid."""
    def run(map_name, robot, params, outcome, up, over, **more):
        return row("beachbot", map_name, "beachbot", params, outcome, robot=robot, tool_up_m=up, path_m="100",
                   over_finished_m=over, curvature_violations="2" if params else "0", **more)

    return [run("horse", "spot", "", "ok", "10", "0", stroke_share="1"),
            run("horse[edits=x.json;margin=1.7]", "spot", "", "ok", "14", "1", stroke_share="0.9999"),
            run("crown", "spot", "", "ok", "6", "2", fill_share="0.99", overlap="0.5"),
            run("crown", "spot", "fill=zigzag", "ok", "9", "0", fill_share="0.98", overlap="0.25"),
            run("crown", "spot", "containment=literal", "ok", "7", "3", fill_share="0.99"),
            run("crown", "spot", "variant=published", "invalid", "70", "30", fill_share="0.85"),
            run("crown", "curves", "", "partial", "20", "4", fill_share="0.97", reason="coverage 0.97 is below 0.99"),
            run("crown", "curves", "variant=published", "invalid", "80", "40", fill_share="0.85")]


def shortest_rows():
    """Two maps; the last variant has no valid path on one of them."""
    def run(planner, params, first, second, outcome="ok"):
        return [row("shortest", "m1", planner, params, "ok", length_ratio=first, gap="0.1", coverage_lower="0.9999",
                    plan_cpu_s="2"),
                row("shortest", "m2", planner, params, outcome, length_ratio=second, gap="0.21", coverage_lower="0.99",
                    plan_cpu_s="8")]

    return (run("boustrophedon", "", "1.3", "1.3") + run("shortest", "coverage=0.99;moves=2000000", "1.0", "1.21")
            + run("shortest", "coverage=0.99;moves=300000;temperature=0.2", "1.2", "1.2")
            + run("polished", "coverage=0.99;moves=300000;planner=stc", "1.1", "1.1", "invalid"))


def ablation_rows():
    """Two maps at one coverage; without detours one of them has no valid path."""
    def run(params, first, second, outcome="ok"):
        cells = [row("ablation", name, "shortest", "coverage=0.99;moves=300000" + params, "ok", length_ratio=ratio,
                     coverage_lower=covered, plan_cpu_s=seconds)
                 for name, ratio, covered, seconds in (("m1", first, "0.995", "2"), ("m2", second, "0.99", "8"))]
        cells[1]["outcome"] = outcome
        return cells

    return (run("", "1.0", "1.21") + run(";without=walls", "1.1", "1.331")
            + run(";without=detours", "1.1", "1.1", "invalid") + run(";without=heat", "1.0", "1.0"))


def anytime_rows():
    """Two maps; of `polished`, more moves make one path longer, and the last budget leaves a map without a path."""
    def run(planner, params, first, second, outcome="ok"):
        cells = [row("anytime", name, planner, params, "ok", length_ratio=ratio, path_m=str(100 * float(ratio)),
                     coverage_lower=covered, plan_cpu_s=seconds)
                 for name, ratio, covered, seconds in (("m1", first, "0.995", "2"), ("m2", second, "0.99", "8"))]
        cells[1]["outcome"] = outcome
        return cells

    return (run("boustrophedon", "", "1.4", "1.4") + run("shortest", "coverage=0.99;moves=10000", "1.0", "1.21")
            + run("shortest", "coverage=0.99;moves=30000", "1.0", "1.0")
            + run("polished", "coverage=0.99;moves=10000", "1.1", "1.1")
            + run("polished", "coverage=0.99;moves=30000", "1.0", "1.5")
            + run("polished", "coverage=0.99;moves=100000", "1.1", "1.1", "invalid"))


def hyun_rows():
    """The paper's world and two others, of which one has no path as published."""
    data = [("hyun-1", "", "ok", "100", "1"), ("hyun-1", "variant=published", "partial", "80", "0.5"),
            ("w1", "", "ok", "110", "0.999"), ("w1", "variant=published", "partial", "70", "0.4"),
            ("w2", "", "ok", "120", "0.998"), ("w2", "variant=published", "infeasible", "", "")]
    return [row("hyun", m, "hyun", params, outcome, path_m=metres, transit_m="10", coverage=c, overlap="0.25",
                turns="7") for m, params, outcome, metres, c in data]


ALL = {"ablation": ablation_rows, "anytime": anytime_rows, "beachbot": beachbot_rows, "berg-table-4-1": berg_rows,
       "cell-order": cell_order_rows, "drivable": drivable_rows, "growth": growth_rows,
       "hyun": hyun_rows,
       "leashed": leashed_rows,
       "shortest": shortest_rows,
       "stc-loops": stc_rows,
       "tether-online": online_rows}


class Figures(unittest.TestCase):
    def test_beachbot(self):
        text = page("beachbot", beachbot_rows())
        claim = lambda start: next(cells[1] for cells in (
            [cell.strip() for cell in one.split("|")[1:-1]] for one in text.split("\n")) if cells[:1] and
            cells[0].startswith(start))
        self.assertIn("6.0 m with the tool up and 2.0 m over finished work; only no direct connection inwards: 7.0 m "
                      "and 3.0 m (1 paths: ", claim("elements inside"))
        self.assertIn("10.0 m with the tool up without, 14.0 m with; strokes drawn 0.9999", claim("a person"))
        self.assertIn("as published: 0 of 1 paths can be driven, 2 bends too sharp, 80.0 m", claim("moving control"))
        self.assertIn("1 of 1, 0 bends, 20.0 m", claim("moving control"))
        self.assertIn("spiral: crown 100 m (overlap 0.50); zigzag: crown 100 m (overlap 0.25)", claim("the spiral"))
        self.assertIn("published 0.8500, all widths of the tool 0.9900", claim("cutting areas"))
        self.assertIn("round it: 3.0 m over it, 30.0 m", claim("outlook"))
        self.assertEqual(line(text, "curves"), ["curves", "crown", "`beachbot`", "coverage 0.97 is below 0.99"])

    def test_berg_table(self):
        text = page("berg-table-4-1", berg_rows())
        self.assertIn("4743.68", text)
        # planner, rooms, median and least coverage, times berg, length ratio, over limit, invalid
        self.assertEqual(line(text, "shnaps-rimon"), ["shnaps-rimon", "2", "97.50", "97.00", "13.75", "1.50", "0", "0"])
        self.assertEqual(line(text, "berg\\[trim=none\\]"),
                         ["berg\\[trim=none\\]", "2", "93.55", "93.00", "1.00", "1.50", "1", "1"])
        self.assertEqual(line(text, "berg\\[order=dfs\\]"),
                         ["berg\\[order=dfs\\]", "2", "95.00", "95.00", "1.10", "1.50", "0", "0"])
        # the room's own table: a breach keeps its figures
        self.assertEqual(line(text, "berg\\[trim=none\\]", 1),
                         ["berg\\[trim=none\\]", "invalid", "94.10", "100.0", "1.00", "1.50", "0.50", "2", ""])
        self.assertEqual(line(text, "shnaps-rimon", 1),
                         ["shnaps-rimon", "ok", "98.00", "1250.0", "12.50", "1.50", "", "0", ""])

    def test_leashed(self):
        text = page("leashed", leashed_rows())
        # planner, robot, over limit, crossings, entangled, kept, least coverage, price, highest:
        # (90 m / 15 m2) / (100 m / 20 m2) = 1.2; a run without a path covers nothing
        self.assertEqual(line(text, "zigzag"),
                         ["zigzag", "tied", "1 of 2", "2", "1 of 2", "1 of 2", "0.0000", "1.200", "1.200"])
        self.assertEqual(line(text, "boustrophedon"),
                         ["boustrophedon", "tied", "0 of 1", "0", "0 of 1", "1 of 1", "1.0000", "1.100", "1.100"])
        # the unaware path covers 20 m2, though the short tether reaches 10 of them: (60 / 10) / (80 / 20)
        self.assertEqual(line(text, "boustrophedon", 1),
                         ["boustrophedon", "short", "1 of 1", "0", "0 of 1", "1 of 1", "1.0000", "1.500", "1.500"])
        self.assertEqual(line(text, "zigzag", 1),
                         ["zigzag", "100.0", "1.0000", "4.00", "4", "yes", "90.0", "0.7500", "1.200", ""])
        self.assertIn("error: no \\| path", text)

    def test_stc_loops(self):
        text = page("stc-loops", stc_rows())
        # variant, valid, least coverage, median, 0.99 or more, above stc, length ratio
        self.assertEqual(line(text, "stc"), ["stc", "1 of 2", "0.8000", "0.8000", "0 of 2", "0 of 2", "1.500"])
        self.assertEqual(line(text, "published"),
                         ["published", "2 of 2", "0.9500", "0.9600", "0 of 2", "2 of 2", "1.500"])
        self.assertEqual(line(text, "stc-loops"),
                         ["stc-loops", "2 of 2", "0.9960", "0.9970", "2 of 2", "2 of 2", "1.500"])
        self.assertEqual(line(text, "m1"), ["m1", "0.8000", "0.9500", "", "", "0.9960"])
        self.assertEqual(line(text, "m2", 1), ["m2", "infeasible", "20.0", "", "", "25.0"])

    def test_tether_online(self):
        text = page("tether-online", online_rows())
        # planner, valid, least coverage, loss, greatest loss, ratio, greatest ratio
        self.assertEqual(line(text, "berg(order=dfs)"),
                         ["berg(order=dfs)", "1 of 2", "0.5000", "0.0030", "0.0030", "1.300", "1.300"])
        self.assertEqual(line(text, "berg"), ["berg", "1 of 1", "1.0000", "", "", "", ""])
        self.assertEqual(line(text, "m1"), ["m1", "1.0000", "0.9970", "100.0", "130.0", "1.300", "9.00", "10.00", ""])
        self.assertIn("invalid: a", line(text, "m2")[8])


    def test_growth(self):
        text = page("growth", growth_rows())
        self.assertEqual(line(text, "zigzag"), ["zigzag", "0.010", "1.000", "1.00", "31"])
        self.assertEqual(line(text, "stc"), ["stc", "0.001", "crash", "", "2"])
        self.assertEqual(line(text, "zigzag", 1), ["zigzag", "0.030", "30.000", "1.50", "2"])
        # What is above n log n, slow or failed.
        self.assertEqual(line(text, "zigzag", 2), ["zigzag", "cave", "1.50", "30.0", ""])
        self.assertEqual(line(text, "stc", 1), ["stc", "rooms", "", "0.0", "crash"])
        self.assertNotIn("| berg", text)


class CellOrder(unittest.TestCase):
    def test_ratios_over_the_default(self):
        text = page("cell-order", cell_order_rows())
        self.assertEqual(line(text, "boustrophedon\\[order=gtsp\\]"),
                         ["boustrophedon\\[order=gtsp\\]", "1 of 2", "1.0000", "0.900", "0.900", "0.900", "0.900",
                          "0.900", "0.900", "20"])


class Drivable(unittest.TestCase):
    def test_ratios_over_the_robot_that_turns_on_the_spot(self):
        text = page("drivable", drivable_rows())
        self.assertEqual(line(text, "contour", 1)[1:7], ["tractor", "1 of 2", "1.200", "1.200", "0.9000", "0.9000"])


class Hyun(unittest.TestCase):
    def test_least_coverage_and_medians_beyond_the_first_world(self):
        text = page("hyun", hyun_rows())
        self.assertEqual(line(text, "default"), ["default", "1 of 1", "1.000", "100", "10", "0.25", "7"])
        self.assertEqual(line(text, "default", 1), ["default", "2 of 2", "0.998", "115", "10", "0.25", "7"])
        self.assertEqual(line(text, "`variant = published`", 1)[1:4], ["1 of 2", "0.400", "70"])


class Shortest(unittest.TestCase):
    def test_geometric_means_where_all_maps_have_a_path(self):
        text = page("shortest", shortest_rows())
        self.assertEqual(line(text, "0.99, 2,000,000")[1:], ["1.100", "0.154", "0.99000", "4.00"])
        self.assertEqual(line(text, "polished\\[coverage=0.99;moves=300000;planner=stc\\]")[1], "")
        self.assertEqual(line(text, "m1")[1:3], ["1.300", "1.000"])


class Ablation(unittest.TestCase):
    def test_longer_than_with_all_parts(self):
        text = page("ablation", ablation_rows())
        # length ratio, longer in per cent, least coverage, seconds
        self.assertEqual(line(text, "nothing: all parts")[1:], ["1.100", "0.00", "0.99000", "4.00"])
        self.assertEqual(line(text, "following walls")[1:], ["1.210", "10.00", "0.99000", "4.00"])
        self.assertEqual(line(text, "short detours: all by the general repair")[1:3], ["", ""])
        # map, heat, walls, detours
        self.assertEqual(line(text, "map"), ["map", "heat", "walls", "detours"])
        self.assertEqual(line(text, "m1"), ["m1", "0.00", "10.00", "10.00"])
        self.assertEqual(line(text, "m2"), ["m2", "-17.36", "10.00", ""])


class Anytime(unittest.TestCase):
    def test_means_and_how_many_are_longer(self):
        text = page("anytime", anytime_rows())
        # planner, coverage, moves, length ratio, covered, seconds, longer than start, longer than with fewer moves
        self.assertEqual(line(text, "boustrophedon")[3], "1.400")
        self.assertEqual(line(text, "shortest"),
                         ["shortest", "0.99", "10,000", "1.100", "0.99000", "4.00", "0 of 2", ""])
        self.assertEqual(line(text, "polished", 1)[3:], ["1.225", "0.99000", "4.00", "1 of 2", "1 of 2"])
        self.assertEqual(line(text, "polished", 2)[3:], ["", "0.99000", "4.00", "0 of 1", "1 of 1"])
        self.assertEqual(line(text, "m2"), ["m2", "1.400", "1.210", "1.000", ""])
        self.assertIn("- Coverage 0.99: 30,000 moves of `shortest` make the start 29 % shorter.\n"
                      "  Of this, fewer moves reach (10,000: 75 %).", text)

    def test_picture(self):
        picture = importlib.import_module("anytime").picture(anytime_rows())
        shapes = [shape for shape in ElementTree.fromstring(picture) if shape.tag.endswith("polyline")]
        points = [[tuple(map(float, spot.split(","))) for spot in shape.get("points").split()] for shape in shapes]
        # Two maps and two means; heights from 1.0 to 1.4, 400 high below 46, four ticks 107.5 apart.
        self.assertEqual(points[0], [(117.8, 46.0), (225.2, 446.0), (332.8, 446.0)])
        self.assertEqual(points[2], [(117.8, 46.0), (225.2, 346.0), (332.8, 221.3)])  # without the last budget
        self.assertEqual(points[3], [(117.8, 46.0), (225.2, 346.0), (332.8, 446.0)])


class Pages(unittest.TestCase):
    def test_no_times(self):
        for name, rows in ALL.items():
            self.assertNotIn("123.4", page(name, rows()), name)

    def test_each_has_its_suite(self):
        modules = {os.path.basename(file)[:-3].replace("_", "-") for file in glob.glob(f"{SOURCE}/docs/pages/*.py")}
        self.assertEqual(modules - {"chart", "results", "write-page"}, set(ALL))
        for name in ALL:
            self.assertTrue(os.path.exists(f"{SOURCE}/bench/suites/{name}.toml"), name)

    def test_results_of_another_suite_are_refused_in_one_sentence(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "runs.csv"), "w") as file:
                file.write("run_id,suite,outcome\n1,quick,ok\n")
            program = f"{SOURCE}/docs/pages/write_page.py"
            done = subprocess.run([sys.executable, program, "leashed", folder, folder], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stderr.strip(), f"page 'leashed' is made from the results of suite 'leashed', but "
                                                  f"'{folder}' holds rows of suite 'quick'")
            self.assertFalse(os.path.exists(os.path.join(folder, "leashed.md")))


unittest.main()
