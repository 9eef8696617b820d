"""The Python module as a user has it. test_module.py DOCS_FOLDER, with the module on PYTHONPATH."""
import contextlib
import io
import os
import re
import runpy
import sys
import tempfile
import unittest

import numpy as np
import oxturn

DOCS = os.path.abspath(sys.argv.pop(1))


def hall(**robot):
    return oxturn.Problem(oxturn.Map.generate("rectangle", width=8, height=5), **robot)


class Problems(unittest.TestCase):
    def test_regions_are_arrays(self):
        (outer, holes), = hall(radius=0.5).configuration_space
        self.assertEqual(outer.shape, (4, 2))
        self.assertEqual(holes, [])
        np.testing.assert_allclose(np.ptp(outer, axis=0), [7, 4], atol=1e-6)

    def test_the_robot_is_a_dictionary(self):
        robot = hall(radius=0.25, tool_width=0.6).robot
        self.assertEqual((robot["radius"], robot["tool_width"]), (0.25, 0.6))

    def test_numpy_numbers_are_numbers(self):
        self.assertEqual(hall(radius=np.float64(0.25), start=np.array([1, 2])).start, (1, 2))

    def test_files_come_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "hall.geojson")
            oxturn.Map.generate("clutter", seed=3).write(file)
            again = oxturn.Problem.read(file, radius=0.3)
            self.assertEqual(len(again.free[0][1]), len(oxturn.Map.generate("clutter", seed=3).free[0][1]))

    def test_transit_goes_round(self):
        problem = oxturn.Problem(oxturn.Map.generate("rooms", seed=7))
        line = problem.transit(problem.start, problem.start)
        self.assertEqual(line.shape[1], 2)

    def test_errors_are_sentences(self):
        for sentence, call in [
                ("did you mean", lambda: oxturn.plan("boustrofedon", hall())),
                ("unknown parameter 'lanes'", lambda: oxturn.plan("boustrophedon", hall(), lanes=3)),
                ("expected a number from", lambda: oxturn.plan("boustrophedon", hall(), spacing=7)),
                ("start: expected two numbers", lambda: hall(start=3)),
                ("inside a wall|outside", lambda: hall(start=(100, 100))),
                ("no such file", lambda: oxturn.Problem.read("nothing.yaml")),
                ("shape \\(n, 2\\)", lambda: oxturn.Plan(hall(), [([1, 2, 3], True)])),
                ("a leg is", lambda: oxturn.Plan(hall(), [(1,)]))]:
            with self.assertRaisesRegex(ValueError, sentence):
                call()
        with self.assertRaisesRegex(TypeError, "'spacing' is a list"):
            oxturn.plan("boustrophedon", hall(), spacing=[1])


class Plans(unittest.TestCase):
    def test_scores_are_those_of_the_program(self):
        score = oxturn.plan("boustrophedon", hall()).score()
        self.assertEqual(score["flaw"], "")
        self.assertGreater(score["coverage_lower"], 0.999)
        self.assertGreater(score["promise_coverage"], 0.999)
        self.assertIsNone(score["tether_max_m"])

    def test_legs_go_out_and_in(self):
        result = oxturn.plan("stc", hall())
        again = oxturn.Plan(result.problem, result.legs)
        self.assertEqual(again.length, result.length)
        self.assertEqual(again.score()["coverage"], result.score()["coverage"])
        points, tool, reverse, width = result.legs[0]
        self.assertEqual(points.shape[1], 2)
        self.assertFalse(reverse)

    def test_legs_keep_the_width_of_the_tool(self):
        problem = hall()
        legs = [([problem.start, (problem.start[0] + 1, problem.start[1])], True, False, 0.1)]
        result = oxturn.Plan(problem, legs)
        self.assertEqual(result.legs[0][3], 0.1)
        whole = oxturn.Plan(problem, [legs[0][:3]])
        self.assertLess(result.score()["coverage"], 0.8 * whole.score()["coverage"])
        with self.assertRaisesRegex(ValueError, "width is -1"):
            oxturn.Plan(problem, [legs[0][:3] + (-1,)])

    def test_infeasible_and_unsupported_have_types(self):
        with self.assertRaises(oxturn.Infeasible):
            oxturn.plan("stc", hall(), cell_size=50)
        with self.assertRaises(oxturn.Unsupported):
            oxturn.plan("stc", hall(tether_length=5))

    def test_the_seed_is_the_planners_luck(self):
        lengths = [oxturn.plan("random-walk", hall(), seed=s).length for s in (1, 1, 2)]
        self.assertEqual(lengths[0], lengths[1])
        self.assertNotEqual(lengths[0], lengths[2])

    def test_pictures_are_svg(self):
        self.assertIn("<svg", oxturn.plan("stc", hall())._repr_svg_())


@oxturn.planner
class Bad:
    name = "bad"
    parameters = {"how": "raise"}

    def __init__(self, how):
        self.how = how

    def plan(self, problem, context):
        if self.how == "wait":
            context.publish([([problem.start, problem.start], True)])
            while not context.cancelled():
                pass
            return []
        if self.how == "infeasible":
            raise oxturn.Infeasible("too hard")
        if self.how == "nothing":
            return None
        raise KeyError("lost")


class PlannersInPython(unittest.TestCase):
    def test_what_they_raise_arrives(self):
        with self.assertRaises(KeyError):
            oxturn.plan("bad", hall())
        with self.assertRaises(oxturn.Infeasible):
            oxturn.plan("bad", hall(), how="infeasible")
        with self.assertRaises(TypeError):
            oxturn.plan("bad", hall(), how="nothing")

    def test_they_are_swept_like_others(self):
        with tempfile.TemporaryDirectory() as folder:
            suite = os.path.join(folder, "s.toml")
            with open(suite, "w") as file:
                file.write('schema = 1\nname = "s"\n[limits]\nwall_s = 1\n'
                           '[robots.disc]\nradius = 0.2\ntool_width = 0.4\n'
                           '[[maps]]\ngenerator = "rectangle"\n'
                           '[[planners]]\nname = "bad"\nhow = ["raise", "wait", "infeasible", "nothing"]\n'
                           '[[planners]]\nname = "leashed"\nplanner = "bad"\n')
            rows = {row["params"] or "": row for row in oxturn.run(suite, os.path.join(folder, "out"))}
        outcomes = [rows[key]["outcome"] for key in ("", "how=wait", "how=infeasible", "how=nothing")]
        self.assertEqual(outcomes, ["error", "timeout", "infeasible", "error"])
        self.assertIn("lost", rows[""]["reason"])
        self.assertEqual(rows["planner=bad"]["outcome"], "unsupported")

    def test_a_class_may_be_defined_again(self):
        oxturn.planner(Bad)
        self.assertEqual([p["name"] for p in oxturn.planners()].count("bad"), 1)

    def test_incomplete_classes_are_refused(self):
        for wrong, sentence in [(type("A", (), {}), "attribute 'name'"),
                                (type("B", (), {"name": "stc", "plan": None}), "already"),
                                (type("C", (), {"name": "c", "plan": None, "capabilities": ["wings"]}),
                                 "unknown capability")]:
            with self.assertRaisesRegex(ValueError, sentence):
                oxturn.planner(wrong)


class Documentation(unittest.TestCase):
    def setUp(self):
        self.before = os.getcwd()
        self.folder = tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()

    def test_the_page_runs(self):
        with open(os.path.join(DOCS, "python.md")) as file:
            blocks = re.findall(r"```python\n(.*?)```", file.read(), re.S)
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            names = {}
            for number, block in enumerate(blocks):
                exec(compile(block, "python.md, block %d" % (number + 1), "exec"), names)
        means = dict(re.findall(r"^(strips|boustrophedon|stc) ([0-9.]+)", said.getvalue(), re.M))
        self.assertGreater(float(means["strips"]), 0.99)

    def test_the_tour_runs(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            runpy.run_path(os.path.join(DOCS, "python_tour.py"))
        self.assertIn("boustrophedon", said.getvalue())
        self.assertTrue(os.path.exists("tour.svg"))


if __name__ == "__main__":
    unittest.main()
