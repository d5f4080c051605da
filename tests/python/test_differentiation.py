"""The page on JAX and PyTorch: its programs run where these are, and give the gradients of the module. What they
rest on, the derivatives of the module, is compared with differences everywhere."""
import importlib.util
import os
import re
import sys
import unittest

import numpy as np

import arm

PACKAGE = os.path.join(os.environ["ROBCOGEN_SOURCE_DIR"], "runtime", "python")
PAGE = os.path.join(PACKAGE, "README.md")
sys.path.insert(0, PACKAGE)


def program(section):
    with open(PAGE, encoding="utf-8") as file:
        return re.search(rf"\n## {section}\n.*?\n```python\n(.*?)\n```\n", file.read(), re.DOTALL)[1]


def gradient_of_squares(q):
    rest = np.zeros_like(q)
    tau, d_q, *_ = arm.inverse_dynamics_derivatives(q, rest, rest)
    return tau, 2 * tau @ d_q


Q = np.linspace(0.1, 0.7, 7)


class Differentiation(unittest.TestCase):
    def run_program(self, section, package, tolerance):
        text = program(section)
        compile(text, PAGE, "exec")
        if importlib.util.find_spec(package) is None:
            self.skipTest(f"there is no {package}")
        names = {}
        exec(text, names)
        tau, gradient = gradient_of_squares(Q)
        torques = names["torques"].detach() if package == "torch" else names["torques"]
        # The first axis is vertical, so its torque is zero except for rounding.
        np.testing.assert_allclose(np.asarray(torques), tau, rtol=tolerance, atol=tolerance * abs(tau).max())
        np.testing.assert_allclose(np.asarray(names["gradient"]), gradient, rtol=tolerance, atol=tolerance * abs(gradient).max())
        return names

    def test_jax(self):
        names = self.run_program("JAX", "jax", 1e-4)  # float32
        self.assertEqual(names["many"].shape, (5, 7))

    def test_pytorch(self):
        self.run_program("PyTorch", "torch", 1e-12)

    def test_derivatives(self):
        q, qd, qdd = np.random.default_rng(2).uniform(-1, 1, (3, 7))
        tau, d_q, d_qd, d_qdd = arm.inverse_dynamics_derivatives(q, qd, qdd)
        np.testing.assert_allclose(tau, arm.inverse_dynamics(q, qd, qdd), atol=1e-11)
        np.testing.assert_allclose(d_qdd, arm.joint_space_inertia(q), atol=1e-11)
        step = 1e-6
        for k in range(7):
            e = step * np.eye(7)[k]
            by_q = arm.inverse_dynamics(q + e, qd, qdd) - arm.inverse_dynamics(q - e, qd, qdd)
            by_qd = arm.inverse_dynamics(q, qd + e, qdd) - arm.inverse_dynamics(q, qd - e, qdd)
            np.testing.assert_allclose(d_q[:, k], by_q / (2 * step), atol=1e-7)
            np.testing.assert_allclose(d_qd[:, k], by_qd / (2 * step), atol=1e-7)


if __name__ == "__main__":
    unittest.main()
