# SPDX-License-Identifier: BSD-3-Clause
"""The Python package slalom."""

import copy
import html
import importlib.util
import inspect
import io
import math
import os
import pathlib
import pickle
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import types
import unittest
from unittest import mock

import numpy as np
import slalom

PROGRAMS = pathlib.Path(slalom.__file__).parents[3] / "bin"
CERTIFY = PROGRAMS / "slalom-certify"
EXAMPLE = pathlib.Path(__file__).parents[2] / "examples/python/evaluate_my_method.py"


class Direct:
    """Moves towards the goal."""

    options = {"speed": (0.5, "m/s", "linear velocity")}

    def __init__(self, robot, options):
        self.robot, self.speed = robot, options.speed

    def reset(self, task):
        self.cycles = 0

    def step(self, o):
        self.cycles += 1
        turn = math.atan2(o.goal_y, o.goal_x)
        return self.speed, float(np.clip(turn, -self.robot.max_w, self.robot.max_w))


class CertifyTest(unittest.TestCase):
    def test_a_class_has_a_limit(self):
        certificate = slalom.certify(
            "limit", Direct, of="random.obstacles", from_=2, to=42, step=20, reliability=0.1
        )
        claim = certificate["answer"]["claims"][0]
        self.assertEqual(certificate["question"]["method"], "method")
        self.assertIn(claim["claim"], str(certificate))
        self.assertTrue(claim["steps"][0]["claimed"])

    def test_the_certificate_of_a_named_method_is_verified(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "risk.certificate.json")
            slalom.certify(
                "risk",
                slalom.plugin("libslalom_follow_the_gap.so"),
                at_most=0.1,
                output=path,
                workers=2,
            )
            again = subprocess.run([CERTIFY, "verify", path, "--quiet"], capture_output=True)
            self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_class_is_tuned(self):
        class Planted(Direct):
            options = {"speed": (0.0, "m/s", "the robot stands")}
            option_ranges = {"speed": (0, 1)}

        tuned = slalom.tune(
            Planted,
            generators={"random": {"min_obstacles": 0, "max_obstacles": 0}},
            simulation={"stuck_time": 1},
            runs=300,
            sealed=200,
            workers=2,
        )["answer"]
        self.assertEqual(tuned["verdict"], "better")
        self.assertGreater(float(tuned["recommendation"]["speed"]), 0)

    def test_bad_questions_are_errors(self):
        for kind, question, words in (
            ("limmit", {}, "limit"),
            ("limit", {}, "'of' is missing"),
            ("limit", {"of": "passage.width", "budget": "x"}, "limit budget"),
            ("limit", {"of": "passage.width", "budgets": 1}, "unknown key 'budgets'"),
            ("risk", {"at_most": 2}, "--at-most 2"),
            ("risk", {"workers": 2**40}, "workers: 1099511627776 is not valid"),
        ):
            with self.assertRaisesRegex(slalom.Error, words):
                slalom.certify(kind, Direct, **question)

    def test_a_method_that_fails_always_is_an_error(self):
        with self.assertRaisesRegex(slalom.Error, "every run ended with method_error.*lost"):
            slalom.certify("risk", Fails, budget=20)


class Fails(Direct):
    def step(self, o):
        raise RuntimeError("lost")


class Crashes(Direct):
    def step(self, o):
        os.abort()


class Seeded(Direct):
    """Draws random numbers without a seed of its own."""

    def step(self, o):
        return self.speed, float(np.clip(o.goal_y, -1, 1))


def small(count=3, **options):
    return slalom.generate("random", count, seed=5, width=6, height=6, min_distance=3, max_obstacles=10, **options)


QUICK = dict(metrics=["success", "optimality", "time_to_goal"], descriptors=["density"])


class Package(unittest.TestCase):
    def test_results_are_columns_with_one_value_per_run(self):
        results = slalom.evaluate({"direct": Direct, "fails": Fails}, small(), **QUICK)
        self.assertEqual(results["method"], ["direct", "fails"] * 3)
        self.assertEqual(results["outcome"][1::2], ["method_error"] * 3)
        for name in QUICK["metrics"] + QUICK["descriptors"]:
            self.assertEqual(results[name].dtype, np.float64)
            self.assertEqual(len(results[name]), 6)
        self.assertEqual(results["success"][1], 0)
        self.assertTrue(np.isnan(results["optimality"][1]))
        self.assertEqual(results.reasons["optimality"][1], "outcome: method_error")
        self.assertEqual(results["density"][0], results["density"][1])
        self.assertIsNone(results.trajectories)
        self.assertEqual(len(results.timing["cycle_time_mean"]), 6)
        self.assertNotIn("cycle_time_mean", results)

    def test_a_class_needs_no_more_than_step(self):
        class Short:
            options = {"turn": (1.0, "1/s", "angular velocity per radian")}

            def step(self, o):
                return self.robot.max_v, self.options.turn * math.atan2(o.goal_y, o.goal_x)

        results = slalom.evaluate({"short": Short}, small(3), workers=2, **QUICK)
        self.assertNotIn("method_error", results["outcome"])
        with self.assertRaisesRegex(slalom.Error, "'turn'"):
            slalom.evaluate({"short": (Short, {"trun": 2})}, small(1), **QUICK)

    def test_without_reset_each_run_begins_with_what_the_constructor_made(self):
        seen = []

        class Counts:
            def __init__(self, robot, options):
                self.cycles = 0

            def step(self, o):
                seen.append(self.cycles)
                self.cycles += 1
                return 0, (1 if self.cycles < 3 else math.nan)

        slalom.evaluate({"counts": Counts}, small(2), in_process=True, **QUICK)
        self.assertEqual(seen, [0, 1, 2, 0, 1, 2])

    def test_workers_do_not_change_results(self):
        columns = [
            slalom.evaluate({"a": Direct, "b": Seeded}, small(4), workers=workers, repetitions=2, **QUICK)
            for workers in (1, 2)
        ]
        self.assertEqual(list(columns[0]), list(columns[1]))
        for name in columns[0]:
            np.testing.assert_array_equal(columns[0][name], columns[1][name], err_msg=name)

    def test_options_of_a_class_are_given_beside_it(self):
        methods = {"slow": (Direct, {"speed": 0.25}), "fast": Direct}
        results = slalom.evaluate(methods, small(1), trajectories=True, **QUICK)
        speeds = {
            name: trajectory[:, slalom.TRAJECTORY_COLUMNS.index("command_v")].max()
            for name, trajectory in zip(results["method"], results.trajectories)
        }
        self.assertEqual(speeds, {"slow": 0.25, "fast": 0.5})

    def test_trajectories_are_arrays_from_start_on(self):
        scenarios = small(2)
        results = slalom.evaluate({"direct": Direct}, scenarios, trajectories=True, **QUICK)
        starts = {scenario.hash: scenario.start for scenario in scenarios}
        for row, trajectory in enumerate(results.trajectories):
            self.assertEqual(trajectory.shape[1], len(slalom.TRAJECTORY_COLUMNS))
            self.assertEqual(tuple(trajectory[0, 1:4]), starts[results["scenario_hash"][row]])
            for column in ("t", "traveled"):
                values = list(trajectory[:, slalom.TRAJECTORY_COLUMNS.index(column)])
                self.assertEqual(values, sorted(values))
            if results["success"][row]:
                self.assertEqual(results["time_to_goal"][row], trajectory[-1, 0])

    def test_a_crash_ends_only_its_runs(self):
        results = slalom.evaluate({"crashes": Crashes, "direct": Direct}, small(2), **QUICK)
        self.assertEqual(results["outcome"][0::2], ["method_crash"] * 2)
        self.assertNotIn("method_crash", results["outcome"][1::2])

    def test_methods_may_be_in_process(self):
        seen = []

        class Observed(Direct):
            def step(self, o):
                seen.append(o.time)
                return super().step(o)

        inside = slalom.evaluate({"a": Observed}, small(1), in_process=True, **QUICK)
        self.assertGreater(len(seen), 1)
        outside = slalom.evaluate({"a": Observed}, small(1), **QUICK)
        self.assertEqual(inside["outcome"], outside["outcome"])
        np.testing.assert_array_equal(inside["time_to_goal"], outside["time_to_goal"])

    def test_mrpts_and_compiled_methods_take_part(self):
        methods = {
            "nd": slalom.mrpt_holonomic("CHolonomicND"),
            "gap": slalom.plugin("libslalom_follow_the_gap.so", look_ahead=2.0),
        }
        results = slalom.evaluate(methods, small(2), **QUICK)
        self.assertEqual(results["method"], ["gap", "nd"] * 2)
        self.assertFalse(any(outcome.startswith("method_") for outcome in results["outcome"]))

    def test_a_filter_is_around_another_method(self):
        methods = {"safe": slalom.barrier_filter("direct", margin=0.05), "direct": (Direct, {"speed": 0.5})}
        results = slalom.evaluate(methods, small(2), **QUICK)
        self.assertEqual(sorted(set(results["method"])), ["direct", "safe"])
        for methods in [{"a": slalom.barrier_filter("b")}, {"a": slalom.barrier_filter("a")}]:
            with self.assertRaisesRegex(slalom.Error, "is not another method"):
                slalom.evaluate(methods, small(1))
        with self.assertRaisesRegex(slalom.Error, "gain"):
            slalom.evaluate({"a": slalom.barrier_filter("b", gain=-1), "b": Direct}, small(1))

    def test_a_class_sets_parameters_of_another_method(self):
        class Speeds:
            def adapt(self, o):
                return {"speed": 0.25 if o.time < 1 else 0.5}

        class Kept(Direct):
            def __init__(self, robot, options):
                self.robot, self.options = robot, options

            def step(self, o):
                self.speed = self.options.speed
                return super().step(o)

        methods = {"kept": (Kept, {"speed": 0.4}), "outer": (Speeds, {"inner": "kept"})}
        results = slalom.evaluate(methods, small(1), repetitions=2, trajectories=True, **QUICK)
        for run in results.runs():
            commands = [sample.command_v for sample in run.samples]
            if run["method"] == "kept":
                self.assertEqual(set(commands[:-1]), {0.4})
            else:
                self.assertEqual([commands[0], commands[9], commands[12]], [0.25, 0.25, 0.5])
        gap = slalom.plugin("libslalom_follow_the_gap.so")
        errors = [
            ({"a": (Speeds, {"inner": "a"})}, "inner 'a' is not another method"),
            ({"a": (Direct, {"inner": "b"}), "b": gap}, r"Direct has no adapt\(\); expected a class with adapt"),
        ]
        for methods, error in errors:
            with self.assertRaisesRegex(slalom.Error, error):
                slalom.evaluate(methods, small(1))
        wrong = slalom.evaluate({"a": (Speeds, {"inner": "b"}), "b": gap}, small(1), **QUICK)
        self.assertEqual(wrong["outcome"][0], "method_error")
        self.assertIn("unknown parameter of follow_the_gap: 'speed'", wrong["detail"][0])

    def test_the_robot_is_set_by_the_keys_of_its_section(self):
        footprint = [(0.3, 0.2), (-0.3, 0.2), (-0.3, -0.2), (0.3, -0.2)]

        class Checks(Direct):
            def __init__(self, robot, options):
                super().__init__(robot, options)
                assert robot.footprint == footprint and robot.rays == 91, robot

        results = slalom.evaluate(
            {"a": Checks}, small(1), robot={"footprint": footprint}, sensor={"rays": 91}, **QUICK
        )
        self.assertNotEqual(results["outcome"], ["method_error"])
        self.assertEqual(results.manifest["sensor.rays"], "91")

    def test_lasers_are_sections_by_name(self):
        results = slalom.evaluate(
            {"a": Direct}, small(1), lasers={"front": {"x": 0.2}, "rear": {"x": -0.2, "yaw": 3.14}}, **QUICK
        )
        self.assertEqual(results.manifest["laser.front.x"], "0.2")
        self.assertEqual(results.manifest["laser.rear.yaw"], "3.14")

    def test_tables_are_texts(self):
        text = slalom.evaluate({"direct": Direct}, small(), **QUICK).table("all", ["success"])
        self.assertIn("direct by all", text)

    def test_progress_is_reported(self):
        calls = []
        slalom.evaluate({"a": Direct}, small(2), progress=lambda *call: calls.append(call), **QUICK)
        self.assertEqual(calls[-1][1:], (2, 2))

    def test_a_bar_is_drawn_ten_times_per_second_and_cleared(self):
        stream, now = io.StringIO(), [0.0]
        bar = slalom._Bar(stream, lambda: now[0])
        for now[0], done in ((0.0, 0), (0.05, 1), (0.125, 2)):
            bar("runs", done, 4)
        first, second = "\rruns [" + 20 * " " + "] 0/4", "\rruns [" + 10 * "#" + 10 * " " + "] 2/4"
        self.assertEqual(stream.getvalue(), first + second)
        bar.clear()
        self.assertEqual(stream.getvalue(), first + second + "\r" + (len(second) - 1) * " " + "\r")

    def test_terminals_show_a_bar_and_files_do_not(self):
        program = (
            "import slalom, sys\n"
            "class Stands:\n"
            "    def step(self, o): return 0, 0\n"
            "bar = len(sys.argv) == 1\n"
            "slalom.evaluate({'a': Stands}, slalom.generate('random', 2, progress=bar), progress=bar)\n"
        )
        phases = ["Generating scenarios", "Describing scenarios", "Running methods"]
        for words, expected in (([], phases), (["quiet"], [])):
            terminal, inside = os.openpty()
            with open(terminal, "rb", buffering=0) as output, tempfile.TemporaryFile() as file:
                command = [sys.executable, "-c", program, *words]
                subprocess.run(command, check=True, stdout=file, stderr=inside)
                os.write(inside, b"end")
                drawn = b""
                while not drawn.endswith(b"end"):
                    drawn += output.read(4096)
                os.close(inside)
                self.assertEqual(re.findall(r"(\w+ \w+) \[ +\] 0/2", drawn.decode()), expected)
                self.assertEqual(drawn == b"end", not expected)
                subprocess.run(command, check=True, stdout=file, stderr=file)
                self.assertEqual(os.fstat(file.fileno()).st_size, 0)

    def test_notebooks_show_a_bar(self):
        class ZMQInteractiveShell:
            pass

        notebook = types.SimpleNamespace(get_ipython=ZMQInteractiveShell)
        with mock.patch.dict(sys.modules, IPython=notebook), mock.patch("sys.stderr", io.StringIO()) as drawn:
            slalom.evaluate({"a": Direct}, small(2), **QUICK)
        self.assertIn("] 0/2", drawn.getvalue())

    def test_invalid_arguments_are_errors(self):
        for message, call in {
            "unknown key; expected 'radius'": lambda: slalom.evaluate({"a": Direct}, small(1), robot={"raduis": 1}),
            "methods: none given": lambda: slalom.evaluate({}, small(1)),
            "no scenario given": lambda: slalom.evaluate({"a": Direct}, []),
            "has no step()": lambda: slalom.evaluate({"a": object}, small(1)),
            "unknown option of the class; expected 'speed'": lambda: slalom.evaluate(
                {"a": (Direct, {"sped": 1})}, small(1)
            ),
            "unknown holonomic method class": lambda: slalom.evaluate({"a": slalom.mrpt_holonomic("X")}, small(1)),
            "unknown generator": lambda: slalom.generate("randm", 1),
            "max_size": lambda: slalom.generate("random", 1, max_size="many"),
            "seed: -1 is not valid": lambda: slalom.evaluate({"a": Direct}, small(1), seed=-1),
            "workers: -1 is not valid": lambda: slalom.evaluate({"a": Direct}, small(1), workers=-1),
            "repetitions: 1099511627776 is not valid": lambda: slalom.evaluate({"a": Direct}, small(1), repetitions=2**40),
            "count: -1 is not valid": lambda: slalom.generate("random", -1),
            "seed: 0.5 is not valid": lambda: slalom.generate("random", 1, seed=0.5),
            "expected {NAME: METHOD, ...}": lambda: slalom.evaluate(slalom.plugin("libslalom_mppi.so"), small(1)),
            "methods: [": lambda: slalom.evaluate([Direct], small(1)),
            "expected ['success']": lambda: slalom.evaluate({"a": Direct}, small(1), metrics="success"),
            "is not a list of scenarios": lambda: slalom.evaluate({"a": Direct}, small(1)[0]),
            "robot: 5 is not a dict": lambda: slalom.evaluate({"a": Direct}, small(1), robot=5),
            "robot radius: None is not valid": lambda: slalom.evaluate({"a": Direct}, small(1), robot={"radius": None}),
            "is not a class": lambda: slalom.evaluate({"a": Direct(None, types.SimpleNamespace(speed=1))}, small(1)),
        }.items():
            with self.assertRaises(slalom.Error, msg=message) as raised:
                call()
            self.assertIn(message, str(raised.exception))

    def test_a_function_of_an_observation_is_a_method(self):
        def turns(o):
            return 0.3, 0.3 if o.goal_y > 0 else -0.3

        class Turns:
            def step(self, o):
                return turns(o)

        results = slalom.evaluate({"a": turns, "b": lambda o: turns(o), "c": Turns}, small(2), **QUICK)
        for name in ("outcome", "time_to_goal"):
            for first in (0, 3):
                np.testing.assert_array_equal(results[name][first : first + 2], results[name][first + 1 : first + 3])

    def test_a_method_of_the_adapter_python_runs_in_this_interpreter(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "mine.py")
            path.write_text("class Mine:\n    options = {'v': (0.2, 'm/s', 'speed')}\n    def step(self, o): return self.options.v, 0\n")
            method = {"adapter": "python", "module": path, "class": "Mine", "v": 0.3}
            results = slalom.evaluate({"a": method, "b": lambda o: (0.3, 0)}, small(1), **QUICK)
            self.assertEqual(results["detail"][0], results["detail"][1])
            with self.assertRaisesRegex(slalom.Error, "no class 'Mane' in the module; expected 'Mine'"):
                slalom.evaluate({"a": {**method, "class": "Mane"}}, small(1))

    def test_a_constructor_that_raises_is_an_error(self):
        class Refuses(Direct):
            def __init__(self, robot, options):
                raise ValueError("too small")

        with self.assertRaisesRegex(slalom.Error, "Refuses cannot be created: ValueError: too small"):
            slalom.evaluate({"a": Refuses}, small(1))

    def test_a_constructor_with_other_parameters_is_named(self):
        class NoOptions(Direct):
            def __init__(self, robot):
                pass

        with self.assertRaisesRegex(slalom.Error, "NoOptions cannot be created: TypeError: .*2 positional arguments"):
            slalom.evaluate({"a": NoOptions}, small(1))

    @unittest.skipUnless(importlib.util.find_spec("onnx"), "python3-onnx is not installed")
    def test_the_example_trains_a_policy_that_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "policy.onnx")
            program = EXAMPLE.parents[1] / "onnx_policy/train.py"
            small_training = ["-o", path, "--scenarios", "2", "--rounds", "2", "--epochs", "1"]
            subprocess.run([sys.executable, program, *small_training], check=True, stdout=subprocess.DEVNULL)
            results = slalom.evaluate({"policy": slalom.onnx(path, scan_size=61)}, small(1), simulation={"max_time": 5}, **QUICK)
        self.assertIn(results["outcome"][0], ["success", "collision", "timeout", "stuck"])

    def run_talking_method(self, options):
        """Standard output and error of a program whose method prints, and what is kept with the run."""
        program = (
            "import slalom, sys\n"
            "class Talks:\n"
            "    def step(self, o):\n"
            "        print('printed')\n"
            "        print('complained', file=sys.stderr)\n"
            "        sys.exit()\n"
            "print('program')\n"
            f"results = slalom.evaluate({{'a': Talks}}, slalom.generate('random', 1), {options})\n"
            "if len(sys.argv) > 1: results.save(sys.argv[1])\n"
        )
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.results")
            done = subprocess.run([sys.executable, "-c", program, path], capture_output=True, text=True, check=True)
            words = [PROGRAMS / "slalom-analyze", "show", path, "--run", "random_0000/a/0"]
            kept = subprocess.run(words, capture_output=True, text=True, check=True).stdout
        return done.stdout, done.stderr, kept

    def test_what_methods_print_is_shown_on_request(self):
        out, err, kept = self.run_talking_method("show_output=True")
        self.assertEqual(out, "program\n")
        self.assertEqual(err.splitlines()[:2], ["printed", "complained"])
        self.assertNotIn("printed\n", kept)

    def test_what_methods_print_is_kept_with_their_runs(self):
        out, err, kept = self.run_talking_method("show_output=False")
        self.assertEqual((out, err), ("program\n", ""))
        self.assertIn("  printed\n  complained\n", kept)

    def test_other_threads_do_not_block_workers(self):
        stop = threading.Event()
        thread = threading.Thread(target=lambda: [None for _ in iter(stop.is_set, True)])
        thread.start()
        try:
            results = slalom.evaluate({"direct": Direct}, small(1), **QUICK)
        finally:
            stop.set()
            thread.join()
        self.assertNotIn("deadline", results["outcome"][0])

    def test_modules_are_told_about_forked_workers(self):
        told = []
        os.register_at_fork(
            before=lambda: told.append("before"), after_in_parent=lambda: told.append("after in parent")
        )
        slalom.evaluate({"direct": Direct}, small(1), **QUICK)
        self.assertEqual(told[:2], ["before", "after in parent"])
        self.assertEqual(told.count("before"), told.count("after in parent"))

    def test_ctrl_c_is_a_keyboard_interrupt(self):
        program = (
            "import slalom, sys\n"
            "class Waits:\n"
            "    def __init__(self, robot, options): pass\n"
            "    def reset(self, task): pass\n"
            "    def step(self, o):\n"
            "        while True: pass\n"
            "scenarios = slalom.generate('random', 1)\n"
            "def progress(phase, done, total):\n"
            "    print(phase, flush=True)\n"
            "try: slalom.evaluate({'a': Waits}, scenarios, progress=progress)\n"
            "except KeyboardInterrupt: sys.exit(7)\n"
        )
        process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE)
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=100), 7)
        process.stdout.close()

    def test_an_interruption_at_any_place_is_a_keyboard_interrupt(self):
        class Interrupts(Direct):
            place = ""

            def reset(self, task):
                if self.place == "reset":
                    signal.raise_signal(signal.SIGINT)

            def step(self, o):
                if self.place == "step":
                    signal.raise_signal(signal.SIGINT)
                return 0, 0

        def report(phase, done, total):
            if Interrupts.place == "progress":
                signal.raise_signal(signal.SIGINT)

        for Interrupts.place in ("reset", "step", "progress"):
            with self.assertRaises(KeyboardInterrupt):
                slalom.evaluate({"a": Interrupts}, small(1), in_process=True, progress=report, **QUICK)
        # Simulates one that came before the first line of a function.
        call = slalom.Call()
        with self.assertRaises(KeyboardInterrupt), call:
            sys.unraisablehook(types.SimpleNamespace(exc_value=KeyboardInterrupt(), object=report))
        self.assertEqual(len(slalom.evaluate({"a": Direct}, small(1), **QUICK)["success"]), 1)

    def test_the_example_runs_and_draws_a_failure(self):
        with tempfile.TemporaryDirectory() as folder:
            program = subprocess.run([sys.executable, EXAMPLE], cwd=folder, capture_output=True, text=True)
            self.assertEqual(program.returncode, 0, program.stderr)
            self.assertIn("nd by confinement", program.stdout)
            failure = program.stdout.splitlines()[-1]
            self.assertRegex(failure, r"^random_\d+: \w+ after [\d.]+ s, [\d.]+ m from the goal$")
            drawing = pathlib.Path(folder, failure.split(":")[0] + ".svg")
            self.assertTrue(drawing.read_text().startswith("<svg"))


class FilesAndFigures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        gap = slalom.plugin("libslalom_follow_the_gap.so")
        cls.results = slalom.evaluate({"direct": Direct, "fails": Fails, "gap": gap}, small(), **QUICK)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_as_text_results_are_the_summary_with_what_is_wrong_with_a_method(self):
        path = self.path("saved.results")
        self.results.save(path)
        words = [PROGRAMS / "slalom-analyze", "summary", path]
        printed = subprocess.run(words, capture_output=True, text=True, check=True).stdout
        self.assertEqual(repr(self.results), printed)
        self.assertRegex(printed, r"fails: 3 of 3 runs ended with method_error: RuntimeError: lost")

    def test_saved_results_are_read_with_all_values(self):
        path = self.path("saved.results")
        self.results.save(path)
        read = slalom.read_results(path, trajectories=True)
        self.assertEqual(list(read), list(self.results))
        for name in read:
            np.testing.assert_array_equal(read[name], self.results[name], err_msg=name)
        self.assertEqual(read.reasons, self.results.reasons)
        self.assertEqual(read.manifest, self.results.manifest)
        ends = [trajectory[-1, 0] for trajectory in read.trajectories]
        known = read["success"] == 1
        np.testing.assert_array_equal(np.array(ends)[known], read["time_to_goal"][known])
        self.assertIsNone(slalom.read_results(path).trajectories)

    def test_read_results_are_saved_again(self):
        self.results.save(self.path("a.results"))
        slalom.read_results(self.path("a.results")).save(self.path("b.results"))
        self.assertEqual(repr(slalom.read_results(self.path("b.results"))), repr(self.results))

    def test_files_that_are_no_results_are_neither_read_nor_replaced(self):
        path = self.path("text.results")
        pathlib.Path(path).write_text("mine")
        with self.assertRaisesRegex(slalom.Error, "text.results"):
            slalom.read_results(path)
        with self.assertRaisesRegex(slalom.Error, "text.results.*not replaced"):
            self.results.save(path)
        self.assertEqual(pathlib.Path(path).read_text(), "mine")
        with self.assertRaisesRegex(slalom.Error, "FILE.results"):
            self.results.save(self.path("saved.csv"))

    def test_reports_are_pages(self):
        index = self.results.report(self.path("report"), rows="density:2", columns=["success"])
        self.assertIn("gap", pathlib.Path(index).read_text())

    def test_a_missing_program_is_an_error(self):
        with mock.patch("os.path.isfile", return_value=False), mock.patch("shutil.which", return_value=None):
            with self.assertRaisesRegex(slalom.Error, "slalom-analyze is not installed; expected the package slalom"):
                self.results.report(self.path("report"))

    def test_notebooks_show_the_first_screen_of_the_report(self):
        shown = self.results._repr_html_()
        self.assertRegex(shown, r'^<iframe srcdoc="&lt;!DOCTYPE html&gt;')
        page = html.unescape(re.search('srcdoc="([^"]*)"', shown)[1])
        for word in ("gap", "direct", "fails", "How sure?", "</style>", "</html>"):
            self.assertIn(word, page)
        self.assertNotIn("<script", page)
        self.assertNotIn("report.css", page)

    def test_comparisons_name_the_difference(self):
        text = self.results.compare(metrics=["success"], baseline="gap")
        self.assertRegex(text, r"success +gap +fails")
        self.assertNotRegex(text, r"success +direct +fails")
        again = slalom.evaluate({"gap": slalom.plugin("libslalom_follow_the_gap.so")}, small(), **QUICK)
        text = self.results.compare(again, metrics=["success"], method="gap")
        self.assertRegex(text, r"gap \(evaluation-\d+.results\) and gap .* are identical in success")

    def test_figures_are_shown_or_written(self):
        figure = self.results.figure(scenario=self.results["scenario"][0], method="gap")
        self.assertTrue(figure._repr_svg_().startswith("<svg"))
        self.assertLess(len(repr(figure)), 80)
        self.assertIsNone(self.results.figure(self.path("scene.svg"), scenario=self.results["scenario"][0], method="gap"))
        self.assertEqual(pathlib.Path(self.path("scene.svg")).read_text(), figure)
        self.assertIn(">density", self.results.figure(metric="success", by="density:q2").lower())
        self.assertIn("success", self.results.figure(outcomes=True))
        with self.assertRaisesRegex(slalom.Error, "^metric success: needs by; expected by density:q4$"):
            self.results.figure(metric="success")
        for message, options in {"no such scenario": {"scenario": "none"}, "scenario,cell": {}}.items():
            with self.assertRaisesRegex(slalom.Error, "(?<!slalom-analyze: )" + message):
                self.results.figure(**options)

    def test_temporary_files_last_as_long_as_the_results_and_their_copies(self):
        results = slalom.evaluate({"direct": Direct}, small(1), **QUICK)
        file, text = pathlib.Path(results._path), repr(results)
        copied = copy.copy(results)
        del results
        self.assertEqual(repr(copied), text)
        del copied
        self.assertFalse(file.exists())

    def test_results_are_not_copied_into_other_memory(self):
        for copied in (pickle.dumps, copy.deepcopy):
            with self.assertRaisesRegex(TypeError, "cannot be pickled or copied"):
                copied(self.results)

    def test_misspelled_columns_are_answered_with_the_nearest(self):
        for columns, wrong, right in (
            (self.results, "sucess", "success"),
            (self.results.reasons, "optimalty", "optimality"),
            (self.results.timing, "cycle_time_meen", "cycle_time_mean"),
        ):
            with self.assertRaises(KeyError) as raised:
                columns[wrong]
            self.assertEqual(str(raised.exception), f"no column '{wrong}'; did you mean '{right}'?")
        with self.assertRaisesRegex(KeyError, "expected one of scenario, scenario_hash"):
            self.results["q"]
        self.assertIsNone(self.results.get("sucess"))

    def test_reasons_are_a_column_too(self):
        row = self.results["method"].index("fails")
        self.assertEqual(self.results["reasons"][row]["optimality"], "outcome: method_error")
        self.assertIn("RuntimeError: lost", self.results["detail"][row])
        self.assertEqual(self.results.reasons["density"], {})


def drive_north(run):
    return run.samples[-1].y - run.scenario.start[1]


class OwnColumns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, "own.results")
        self.results = slalom.evaluate({"direct": Direct, "fails": Fails}, small(), **QUICK)

    def test_a_function_of_a_run_is_a_metric_in_files_and_tables(self):
        before = {name: list(self.results[name]) for name in ("scenario", "method", "success")}
        self.results.add_metric(drive_north, unit="m", better="down", low=-50, high=50)
        self.results.save(self.file)
        read = slalom.read_results(self.file, trajectories=True)
        ends = [trajectory[-1, 2] for trajectory in read.trajectories]
        starts = [scenario.start[1] for scenario in read.scenarios for _ in range(2)]
        np.testing.assert_array_equal(read["drive_north"], np.array(ends) - starts)
        self.assertEqual(before, {name: list(self.results[name]) for name in before})
        self.assertIn("drive_north ↓ m", read.table("all", ["drive_north"]))
        self.assertRegex(read.compare(metrics=["drive_north"]), "drive_north +direct +fails")
        self.assertEqual(read.manifest["own_column.drive_north"], inspect.getsource(drive_north))

    def test_a_function_of_a_scenario_is_a_descriptor_for_rows(self):
        self.results.add_descriptor(lambda scenario: int(scenario.name[-1]), name="number", low=0)
        self.assertEqual([run["number"] for run in self.results.runs()], [0, 0, 1, 1, 2, 2])
        self.assertIn("[1, 2]", self.results.table("number:2", ["success"]))

    def test_none_and_a_text_say_why_there_is_no_value(self):
        self.results.add_metric(lambda run: "it fails" if run.method == "fails" else None, name="none")
        self.assertEqual(self.results.reasons["none"][0], "no value")
        self.assertEqual(self.results.reasons["none"][1], "it fails")
        self.results.add_metric(lambda run: math.inf, name="infinite")
        self.assertEqual(self.results.reasons["infinite"][0], "not a finite number")

    def test_results_of_shards_are_merged_with_the_column(self):
        folder = pathlib.Path(self.file).parent
        (folder / "shards").mkdir()
        (folder / "c.ini").write_text(
            "[campaign]\nmethods = gap\n[scenarios]\ngenerator = random\ncount = 4\n"
            "[method.gap]\nadapter = library\nplugin = libslalom_follow_the_gap.so\n"
        )
        for shard in ("1/2", "2/2"):
            words = ["run", "-c", "c.ini", "--shard", shard, "-o", f"shards/{shard[0]}.results", "--quiet"]
            subprocess.run([PROGRAMS / "slalom-simulate", *words], cwd=folder, check=True)
        read = slalom.read_results(str(folder / "shards"))
        read.add_metric(drive_north)
        ends = [run.samples[-1].y - run.scenario.start[1] for run in read.runs()]
        self.assertEqual(list(read["drive_north"]), ends)
        self.assertEqual(len(ends), 4)
        self.assertNotIn("drive_north", slalom.read_results(str(folder / "shards")))

    def test_what_cannot_be_a_column_is_an_error(self):
        one = lambda run: 1
        for message, arguments in {
            "'': cannot be the id of a column; expected at most 60 lower-case letters": {},
            "success: is a quantity of Slalom; expected another name": {"name": "success"},
            "x of .*direct/0: 1 is out of range; expected a number >= 2": {"name": "x", "low": 2},
            r"range: '2.0..1.0' is not valid": {"name": "x", "low": 2, "high": 1},
            "low and high: 'a' is not valid; expected a number": {"name": "x", "low": "a"},
            "better: unknown 'larger'; expected one of up, down, none": {"name": "x", "better": "larger"},
            "kind: unknown 'rates'; expected 'rate'": {"name": "x", "kind": "rates"},
        }.items():
            with self.subTest(message), self.assertRaisesRegex(slalom.Error, message):
                self.results.add_metric(one, **arguments)
        with self.assertRaisesRegex(slalom.Error, r"x of <slalom.Run \w+/direct/0, \w+>: \[\] is not valid"):
            self.results.add_metric(lambda run: [], name="x")
        with self.assertRaises(ZeroDivisionError):
            self.results.add_metric(lambda run: 1 / 0, name="x")
        self.assertNotIn("x", self.results)


class Annotations(unittest.TestCase):
    def test_all_that_users_call_is_annotated(self):
        self.assertTrue(pathlib.Path(slalom.__file__).with_name("py.typed").exists())
        public = [getattr(slalom, name) for name in slalom.__all__]
        functions = [one for one in public if inspect.isfunction(one)]
        functions += [one for _, one in inspect.getmembers(slalom.Results, inspect.isfunction)]
        self.assertGreater(len(functions), 10)
        for function in functions:
            signature = inspect.signature(function)
            self.assertIsNot(signature.return_annotation, signature.empty, function)
            for parameter in list(signature.parameters.values()):
                if parameter.name != "self":
                    self.assertIsNot(parameter.annotation, parameter.empty, f"{function} {parameter}")


class Interpreters(unittest.TestCase):
    def run_with(self, words, folder):
        return subprocess.run(
            [sys.executable, *words], capture_output=True, text=True,
            env={**os.environ, "PYTHONPATH": str(folder), "PATH": f"{PROGRAMS}:{os.environ['PATH']}"},
        )

    def import_with(self, words, folder):
        done = self.run_with([*words, "-c", "import slalom"], folder)
        return done.stderr.splitlines()[-1] if done.returncode else ""

    def test_without_its_library_the_package_says_what_it_needs_and_runs_programs(self):
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder, "slalom")
            package.mkdir()
            for path in pathlib.Path(slalom.__file__).parent.glob("*.py"):
                shutil.copy(path, package)
            expected = "ImportError: slalom: .*libslalom.so: .*expected glibc 2.35 or newer and a whole installation"
            self.assertRegex(self.import_with([], folder), expected)
            done = self.run_with(["-m", "slalom", "evaluate", "--version"], folder)
            self.assertEqual((done.stdout, done.returncode), (f"slalom-evaluate {slalom.__version__}\n", 0), done.stderr)

    def test_without_numpy_arrays_are_views_of_memory(self):
        folder = pathlib.Path(slalom.__file__).parents[1]
        program = (
            "import slalom\n"
            "class Goes:\n"
            "    uses_map = uses_tracks = True\n"
            "    def reset(self, task): assert task.map.cells[0, 0] in (0, 1)\n"
            "    def __init__(self, robot, options): self.rays = robot.rays\n"
            "    def step(self, o):\n"
            "        assert type(o.ranges) is memoryview and len(o.ranges) == self.rays and o.ranges[0] > 0\n"
            "        return 0.5, 0\n"
            "scenarios = slalom.generate('random', 2, walkers=1)\n"
            "results = slalom.evaluate({'a': Goes}, scenarios, trajectories=True)\n"
            "assert 'method_error' not in results['outcome'], results['detail']\n"
            "assert list(results['repetition']) == [0, 0]\n"
            "first = results.trajectories[0]\n"
            "print(results['density'].tolist(), first[0, 1], scenarios[0].start[0], scenarios[0].occupancy()[0, 0])\n"
        )
        results = slalom.evaluate({"a": Direct}, slalom.generate("random", 2, walkers=1), **QUICK)
        done = self.run_with(["-S", "-c", program], folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        density, rest = done.stdout.split("] ")
        self.assertEqual(density + "]", str(results["density"].tolist()))
        x, start, _ = rest.split()
        self.assertEqual(x, start)


    def test_every_python_of_this_machine_gives_the_same_results(self):
        program = (
            "import hashlib, slalom\n"
            "class Turns:\n"
            "    def step(self, o): return 0.4, 0.8 if o.goal_y > min(o.ranges) - 2 else -0.8\n"
            "results = slalom.evaluate({'a': Turns}, slalom.generate('random', 3), trajectories=True)\n"
            "bits = b''.join(bytes(memoryview(one).cast('B')) for one in results.trajectories)\n"
            "print(hashlib.sha256(bits).hexdigest(), results)\n"
        )
        others = [*pathlib.Path("/usr/bin").glob("python3.*[0-9]"), *pathlib.Path.home().glob(".pyenv/versions/3.*/bin/python3")]
        version = "import sys; print(sys.version_info >= (3, 8))"
        pythons = [one for one in others if subprocess.run([one, "-c", version], capture_output=True, text=True).stdout == "True\n"]
        package = str(pathlib.Path(slalom.__file__).parents[1])
        said = {
            subprocess.run([*words, "-c", program], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": package}).stdout
            for words in [[sys.executable], [sys.executable, "-S"], *([one] for one in pythons)]
        }
        self.assertEqual(len(said), 1, said)
        self.assertRegex(said.pop(), "^[0-9a-f]{64} ")


class Programs(unittest.TestCase):
    def run_module(self, *words):
        return subprocess.run(
            [sys.executable, "-m", "slalom", *words], capture_output=True, text=True,
            env={**os.environ, "PYTHONPATH": str(pathlib.Path(slalom.__file__).parents[1])},
        )

    def test_python_m_slalom_runs_a_program_with_its_output_and_its_status(self):
        direct = subprocess.run([PROGRAMS / "slalom-evaluate", "no.ini"], capture_output=True, text=True)
        done = self.run_module("evaluate", "no.ini")
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual((done.returncode, done.stderr), (direct.returncode, direct.stderr))
        self.assertIn("slalom-evaluate", self.run_module("evaluate", "--help").stdout)

    def test_other_names_are_answered_with_the_programs(self):
        self.assertIn("PROGRAM is one of analyze, ", self.run_module("--help").stdout)
        for words, given in [(["avaluate"], "avaluate"), (["../evaluate"], "../evaluate"), ([], "no program")]:
            done = self.run_module(*words)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, f"^slalom: {re.escape(given)}: expected one of analyze, .*evaluate")


class Scenarios(unittest.TestCase):
    def test_copies_of_scenarios_are_equal_and_any_iterable_of_them_is_a_list(self):
        scenarios = small()
        self.assertEqual(pickle.loads(pickle.dumps(scenarios)), scenarios)
        self.assertEqual(copy.deepcopy(scenarios), scenarios)
        results = slalom.evaluate({"a": lambda o: (0, 0)}, (one for one in scenarios), **QUICK)
        self.assertEqual(len(results["scenario"]), 3)

    def test_generation_is_repeatable(self):
        self.assertEqual(small(), small())
        self.assertEqual(len({scenario.hash for scenario in small()}), 3)

    def test_a_function_is_a_family(self):
        def gate(random, width=1.0):
            y = random.uniform(1.5, 4.5)
            walls = [[4.9, 0, 5.1, y - width / 2], [4.9, y + width / 2, 5.1, 6]]
            corners = [[[a, b], [c, b], [c, d], [a, d]] for a, b, c, d in walls]
            return {"bounds": [0, 0, 10, 6], "start": [1, 3, 0], "goal": [9, 3], "polygons": corners}

        made = slalom.generate(gate, 4, seed=3, width=0.8)
        self.assertEqual([scenario.name for scenario in made], [f"gate_000{i}" for i in range(4)])
        self.assertEqual(len({scenario.hash for scenario in made}), 4)
        self.assertEqual(made, slalom.generate(gate, 4, seed=3, width=0.8, workers=3))
        self.assertNotEqual(made, slalom.generate(gate, 4, seed=4, width=0.8))
        self.assertEqual(len(slalom.generate(gate, 1, walkers=2)[0].movers), 2)
        with self.assertRaisesRegex(slalom.Error, "solvable"):  # a robot 0.5 m wide
            slalom.generate(gate, 1, width=0.4)

    def test_what_a_family_raises_ends_the_generation(self):
        for raised in (ValueError, KeyboardInterrupt):
            def fails(random):
                raise raised("no more")

            for workers in (1, 3):
                with self.assertRaisesRegex(raised, "no more"):
                    slalom.generate(fails, 2, workers=workers)
        for message, given in {
            "family family: None is not a dict": None,
            "family family:1: missing key 'goal'": {"bounds": [0, 0, 9, 9], "start": [1, 1, 0]},
        }.items():
            with self.assertRaisesRegex(slalom.Error, message):
                slalom.generate(lambda random: given, 1)
        with self.assertRaisesRegex(slalom.Error, "family: 3 is not valid; expected the name of a generator, or a function"):
            slalom.generate(3, 1)

    def test_progress_is_reported_from_all_threads(self):
        for workers in (1, 3):
            calls = []
            made = small(workers=workers, progress=lambda *call: calls.append(call))
            self.assertEqual(made, small())
            self.assertEqual((calls[0][1:], calls[-1][1:]), ((0, 3), (3, 3)))

    def test_a_failing_progress_function_and_ctrl_c_end_the_generation(self):
        def refuse(phase, done, total):
            raise RuntimeError("enough")

        def interrupt(phase, done, total):
            signal.raise_signal(signal.SIGINT)

        for workers in (1, 3):
            with self.assertRaisesRegex(RuntimeError, "enough"):
                small(workers=workers, progress=refuse)
            with self.assertRaises(KeyboardInterrupt):
                small(workers=workers, progress=interrupt)

    def test_lists_keep_scenarios(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.scenarios")
            slalom.write_scenarios(path, small())
            self.assertEqual(slalom.read_scenarios(path), small())
            with self.assertRaisesRegex(slalom.Error, "none.scenarios"):
                slalom.read_scenarios(os.path.join(folder, "none.scenarios"))

    def test_movers_are_those_of_the_yaml(self):
        crossing = slalom.generate("crossing", 2, min_movers=3, max_movers=3)
        self.assertEqual([len(scenario.movers) for scenario in crossing], [3, 3])
        text = small(1)[0].yaml() + (
            "movers:\n  - {id: walker, radius: 0.3, after: stop, waypoints: [[0, 3, 0.5], [4, 3, 3.5]]}\n"
        )
        scenario = slalom.Scenario.from_yaml(text)
        walker = {"id": "walker", "radius": 0.3, "after": "stop", "waypoints": [(0, 3, 0.5), (4, 3, 3.5)]}
        self.assertEqual(scenario.movers, [walker])
        self.assertNotEqual(scenario, small(1)[0])
        self.assertEqual(slalom.Scenario.from_yaml(scenario.yaml()), scenario)
        with self.assertRaisesRegex(slalom.Error, r"yaml:\d+.*radius"):
            slalom.Scenario.from_yaml(text.replace("radius: 0.3", "radius: 0"))

    def test_walkers_are_added_to_any_family(self):
        walked = small(walkers=2)
        self.assertEqual([len(scenario.movers) for scenario in walked], [2, 2, 2])
        results = slalom.evaluate({"direct": Direct}, walked)
        self.assertFalse(np.isnan(results["mover_collision"]).any())
        self.assertIn("survivability", results)

    def test_occupancy_has_rows_from_the_bottom(self):
        scenario = small(1)[0]
        cells = scenario.occupancy(0.1)
        x_min, y_min, x_max, y_max = scenario.bounds
        self.assertEqual(cells.dtype, np.bool_)
        self.assertEqual(cells.shape, (round((y_max - y_min) / 0.1), round((x_max - x_min) / 0.1)))
        for x, y in (scenario.start[:2], scenario.goal):
            self.assertFalse(cells[int((y - y_min) / 0.1), int((x - x_min) / 0.1)])

    def test_notebooks_show_a_drawing(self):
        self.assertTrue(small(1)[0]._repr_svg_().startswith("<svg"))


if __name__ == "__main__":
    unittest.main()
