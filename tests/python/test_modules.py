"""Modules of different robots with one name, of one robot with different options, and with the names of other modules: each
computes its own robot's numbers."""
import contextlib
import copy
import io
import multiprocessing
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import threading
import types
import unittest
from pathlib import Path

import numpy as np

SOURCES = Path(os.environ["ROBCOGEN_SOURCE_DIR"])
sys.path.insert(0, str(SOURCES / "runtime" / "python"))
import robcogen  # noqa: E402

ROBOT = """<robot name="lever"><link name="base"/><link name="lever"><inertial><origin xyz="0.3 0 0"/><mass value="{mass}"/>
<inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="lever"/><axis xyz="0 1 0"/>
<limit lower="-3" upper="3" effort="10" velocity="5"/><dynamics damping="0.5"/></joint></robot>
"""
STATE = [0.4], [0.7], [0.2]


def expected(mass, damping=0.0):
    """The torque of a point mass on a lever that turns about a horizontal axis, which points along y."""
    q, qd, qdd = (x[0] for x in STATE)
    return (0.02 + mass * 0.3**2) * qdd - mass * 9.81 * 0.3 * np.cos(q) + damping * qd


class Modules(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        os.environ["ROBCOGEN_CACHE"] = str(cls.folder / "cache")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def model(self, path, mass=1.0):
        file = self.folder / path
        file.parent.mkdir(exist_ok=True)
        file.write_text(ROBOT.format(mass=mass))
        return file

    def load(self, model, **options):
        return robcogen.load(model, algorithms="inverse_dynamics", quiet=True, **options)

    def check(self, module, mass, damping=0.0):
        np.testing.assert_allclose(module.inverse_dynamics(*STATE), [expected(mass, damping)], rtol=1e-12)

    def test_one_name(self):
        """Two folders, two sets of options and an edit that is undone, each in turn and then again."""
        a, b = self.model("a/robot.urdf", 1.0), self.model("b/robot.urdf", 2.0)
        first = self.load(a)
        self.check(first, 1.0)
        with_damping = self.load(a, passive_forces=True)
        self.check(with_damping, 1.0, 0.5)
        self.check(self.load(b), 2.0)
        self.check(first, 1.0)
        self.assertIs(self.load(a), first)
        self.assertIs(self.load(a, options=["--passive-forces"]), with_damping)
        self.check(with_damping, 1.0, 0.5)
        text = a.read_text()
        a.write_text(text.replace('mass value="1.0"', 'mass value="2.0"'))
        self.check(self.load(a), 2.0)
        self.check(first, 1.0)
        a.write_text(text)
        self.assertIs(self.load(a), first)
        self.check(self.load(a), 1.0)

    def test_names_of_other_modules(self):
        sys.modules["robot"] = types.ModuleType("robot")
        before = dict(sys.modules)
        for name in ("copy", "robot"):
            module = self.load(self.model("a/robot.urdf"), name=name)
            self.check(module, 1.0)
            self.assertRegex(module.__name__, rf"^_robcogen\.{name}_[0-9a-f]+\.{name}$")
        for name, module in before.items():
            self.assertIs(sys.modules[name], module)
        new = [name for name in sys.modules if name not in before and not name.startswith("_robcogen")]
        self.assertFalse({"copy", "robot"} & set(new), new)
        self.assertIs(sys.modules["copy"], copy)
        del sys.modules["robot"]

    def test_threads_load_one_module(self):
        model, modules = self.model("a/robot.urdf"), [None] * 4

        def work(i):
            modules[i] = self.load(model)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.check(modules[0], 1.0)
        for module in modules:
            self.assertIs(module, modules[0])

    def test_subinterpreters_are_refused(self):
        try:
            import _xxsubinterpreters as interpreters
        except ImportError:
            self.skipTest("this Python has no module for subinterpreters")
        path = robcogen.build(self.model("a/robot.urdf"), algorithms="inverse_dynamics", quiet=True)
        program = f"import sys; sys.path.insert(0, {str(path.parent)!r}); import robot"
        interpreter = interpreters.create()
        try:
            with self.assertRaisesRegex(interpreters.RunFailedError, "ImportError.*subinterpreter"):
                interpreters.run_string(interpreter, program)
        finally:
            interpreters.destroy(interpreter)

    def test_pickles(self):
        module = self.load(self.model("a/robot.urdf"))
        function = module.inverse_dynamics
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            self.assertIs(pickle.loads(pickle.dumps(function, protocol)), function)
        self.assertIs(copy.copy(function), function)
        self.assertIs(copy.deepcopy(function), function)
        q = [np.array([x]) for x in (0.1, 0.2, 0.3)]
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(2) as pool:
                torques = pool.starmap(function, [(x, x, x) for x in q])
            np.testing.assert_array_equal(torques, [function(x, x, x) for x in q])
        # A pickle that comes to a machine without the module.
        program = f"import pickle; pickle.loads({pickle.dumps(function)!r})"
        environment = os.environ | {
            "ROBCOGEN_CACHE": str(self.folder / "other"), "PYTHONPATH": str(SOURCES / "runtime" / "python")}
        run = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=False)
        self.assertRegex(run.stderr, r"_robcogen\.robot_\w+ is not in the cache .*/other: load its model with robcogen.load")

    def test_options(self):
        """The generator takes all options; nothing is compiled."""
        model = self.model("a/robot.urdf")
        with self.assertRaisesRegex(robcogen.Error, "nowhere"):
            robcogen.load(
                model, contacts=["nowhere", "lever:surface"], floating_base=True, snap_angles=True, passive_forces=True,
                free_mimic_joints=True, allow_implausible=True, strict=True, effort=0, import_folders=self.folder, quiet=True)
        with self.assertRaisesRegex(TypeError, "floatingbase"):
            robcogen.load(model, floatingbase=True)

    def test_progress_and_notes(self):
        model = self.model("c/robot.urdf", 3.0)
        model.write_text(model.read_text().replace('<limit lower="-3" upper="3" effort="10" velocity="5"/>', ""))
        printed = []
        for _ in range(3):
            with contextlib.redirect_stderr(io.StringIO()) as stderr:
                robcogen.build(model, algorithms="inverse_dynamics")
            printed.append(stderr.getvalue())
        self.assertRegex(printed[0], r"^robcogen: robot: generating code from robot\.urdf\n[^\0]*warning: [^\0]*"
                         r"robcogen: robot: compiling 2 files\n[^\0]*robcogen: robot: ready after [\d.]+ s\n$")
        self.assertEqual(printed[1:], ["", ""])


if __name__ == "__main__":
    unittest.main()
