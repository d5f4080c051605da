"""Documentation, stubs, and the example of the guide."""
import inspect
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from common import arm, five_bar, leg, scopes, walker


# A trunk and a leg.
INERTIAL = '<inertial><mass value="2"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>'
HOPPER = f"""<robot name="hopper"><link name="trunk">{INERTIAL}</link><link name="leg">{INERTIAL}</link>
<joint name="hip" type="continuous"><parent link="trunk"/><child link="leg"/><axis xyz="0 1 0"/></joint></robot>"""


class Documents(unittest.TestCase):
    def test_signatures(self):
        self.assertRegex(str(inspect.signature(leg.Parameters)), r"^\(\*, \w+=[-\d.]+, .*upperleg_length=0.35")
        self.assertEqual(
            str(inspect.signature(arm.inverse_dynamics)), "(q, qd, qdd, gravity=None, external=None, *, out=None)")
        self.assertEqual(str(inspect.signature(leg.gravity_forces)), "(parameters, q, gravity=None, *, out=None)")
        # With a floating base, gravity says how the base is oriented, so it has no default.
        self.assertIsNot(inspect.signature(walker.inverse_dynamics).parameters["gravity"].default, None)
        self.assertIn("recursive Newton-Euler", arm.inverse_dynamics.__doc__)
        for line in ("gravity: (3,); default (0, 0, -9.81)\n    gravity (m/s^2) in base coordinates\n", "external: (8, 6); default zero\n",
                     "qd: (7,)\n    joint velocities (rad/s, m/s)\n"):
            self.assertIn(line, arm.inverse_dynamics.__doc__)
        self.assertIn("gravity: (3,)\n", walker.inverse_dynamics.__doc__)
        self.assertIn("base_pose: (7,)\n    pose of the base in the world: unit quaternion w, x, y, z from base axes to world axes, then",
                      walker.gravity_in_base.__doc__)

    def test_stubs_have_every_function(self):
        for module in (arm, leg, walker):
            stub = os.path.join(os.path.dirname(module.__file__), module.__name__ + ".pyi")
            with open(stub, encoding="utf-8") as file:
                text = file.read()
            names = set(re.findall(r"def (\w+)\(", text)) - {"__init__"}
            names -= set(getattr(module, "parameter_names", ()))
            self.assertEqual(names, {name.rsplit(".")[-1] for name, _ in scopes(module)})
            compile(text, stub, "exec")

    @unittest.skipUnless(five_bar, "only where everything is tested")
    def test_stubs_satisfy_mypy(self):
        program = "\n".join([
            "import numpy as np", "import leg", "p = leg.Parameters(upperleg_length=0.4)",
            "H = leg.joint_space_inertia(p, [0.0, 0.1, 0.2])", "print(H.T @ H, p.upperleg_length, leg.dof + 1)",
            "X = leg.transforms.homogeneous.fr_base_X_fr_foot(p, np.zeros(3))",
            "factor: leg.joint_space_inertia_factor_result = leg.joint_space_inertia_factor(p, np.zeros((5, 3)))",
            "print(factor.L.shape, X[0], factor._fields, factor._asdict())"])
        check = subprocess.run([sys.executable, "-m", "mypy", "--version"], capture_output=True, check=False)
        if check.returncode:
            self.skipTest("there is no mypy")
        with tempfile.TemporaryDirectory() as folder:
            for module in (arm, leg, walker):
                shutil.copy(os.path.join(os.path.dirname(module.__file__), module.__name__ + ".pyi"), folder)
            with open(os.path.join(folder, "use.py"), "w", encoding="utf-8") as file:
                file.write(program + "\n")
            run = subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", "use.py"], cwd=folder,
                capture_output=True, text=True, check=False,
                env={k: v for k, v in os.environ.items() if k != "PYTHONPATH"} | {"MYPYPATH": folder})
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_the_example_of_the_guide_runs(self):
        with open(os.path.join(os.environ["ROBCOGEN_SOURCE_DIR"], "runtime", "LANGUAGES.md"), encoding="utf-8") as file:
            blocks = re.findall(r"\n```python\n(.*?)\n```\n", file.read(), re.DOTALL)
        self.assertGreater(len(blocks), 0)
        names = {"hyl_kindsl": os.path.join(os.environ["ROBCOGEN_SOURCE_DIR"], "robots", "hyl", "hyl.kindsl")}
        sys.path.insert(0, os.path.join(os.environ["ROBCOGEN_SOURCE_DIR"], "runtime", "python"))
        names["hopper_urdf"] = os.path.join(tempfile.mkdtemp(), "hopper.urdf")
        self.addCleanup(shutil.rmtree, os.path.dirname(names["hopper_urdf"]))
        with open(names["hopper_urdf"], "w", encoding="utf-8") as file:
            file.write(HOPPER)
        cache = tempfile.TemporaryDirectory()
        self.addCleanup(cache.cleanup)
        os.environ["ROBCOGEN_CACHE"] = cache.name
        for block in blocks:
            exec(compile(block, "LANGUAGES.md", "exec"), names)
        self.assertEqual(names["tau"].shape, (7,))
        self.assertAlmostEqual(names["forces"][0], 7.501 * 9.81)
        # The base falls for 10 ms, by h^2 g (1 + … + 10).
        np.testing.assert_allclose(names["pose"], [1, 0, 0, 0, 0, 0, 0.6 - 55e-6 * 9.81], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
