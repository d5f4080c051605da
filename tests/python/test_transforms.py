"""A document of motions, without a robot, as a module: by hand, by differences, and over many states."""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import crane

RANDOM = np.random.default_rng(3)


def by_hand(swing, slide, rope, reach):
    """Of the hook in the post: a turn, then along the jib and down, and a quarter turn."""
    c, s = np.cos(swing), np.sin(swing)
    X = np.array([[c, -s, 0, c * (slide + reach)], [s, c, 0, s * (slide + reach)], [0, 0, 1, -rope], [0, 0, 0, 1.0]])
    return X @ np.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])


class Transforms(unittest.TestCase):
    def setUp(self):
        self.pose = crane.transforms.homogeneous.post_X_hook

    def test_values(self):
        self.assertIn("variables: (3,)\n    swing, slide, rope", self.pose.__doc__)
        v = RANDOM.uniform(-1, 1, (5, 3))
        many = self.pose(parameters=[1.2], variables=v)
        for row, X in zip(v, many):
            np.testing.assert_allclose(X, by_hand(*row, 1.2), atol=1e-14)
            np.testing.assert_allclose(self.pose(parameters=[1.2], variables=row), X, atol=1e-15)

    def test_derivatives(self):
        v, step = RANDOM.uniform(-1, 1, 3), 1e-6
        d = crane.transforms.homogeneous.post_X_hook_d_variables(parameters=[1.2], variables=v)
        for k in range(3):
            moved = [by_hand(*(v + sign * step * np.eye(3)[k]), 1.2) for sign in (1, -1)]
            np.testing.assert_allclose(d.d_variables[:, :, k], (moved[0] - moved[1]) / (2 * step), atol=1e-9)
        # Many states, in the order of NumPy and in that of the library, and in single precision.
        many = crane.transforms.homogeneous.post_X_hook_d_variables([[1.2]] * 3, [v, v, v])
        self.assertEqual(many.d_variables.shape, (3, 4, 4, 3))
        out = np.zeros((3, 4, 4)), np.zeros((3, 3, 4, 4)).transpose(0, 3, 2, 1)
        crane.transforms.homogeneous.post_X_hook_d_variables([1.2], [v, v, v], out=out)
        for k in range(3):
            np.testing.assert_array_equal(many.d_variables[k], d.d_variables)
            np.testing.assert_array_equal(out[1][k], d.d_variables)
        single = crane.transforms.homogeneous.post_X_hook_d_variables(np.float32([1.2]), v.astype(np.float32))
        np.testing.assert_allclose(single.d_variables, d.d_variables, atol=1e-5)

    def test_the_model(self):
        self.assertEqual(set(crane.frame_names), {"post", "hook"})
        self.assertFalse(hasattr(crane, "dof"))
        with self.assertRaisesRegex(ValueError, r"post_X_hook: variables must have the shape \(3,\) or \(N, 3\), has \(2,\)"):
            self.pose(parameters=[1.2], variables=[0, 0])

    def test_without_a_build_system(self):
        sources = os.environ["ROBCOGEN_SOURCE_DIR"]
        with tempfile.TemporaryDirectory() as folder:
            program = (f"import sys; sys.path.insert(0, {sources + '/runtime/python'!r}); import robcogen\n"
                       f"c = robcogen.load({sources + '/tests/python/crane.motdsl'!r}, name='lifted')\n"
                       "print(c.transforms.homogeneous.post_X_hook(parameters=[1], variables=[0, 0, 2])[2, 3])")
            run = subprocess.run([sys.executable, "-c", program], env=os.environ | {"ROBCOGEN_CACHE": folder}, capture_output=True,
                                 text=True, check=False)
            self.assertEqual(run.stdout.strip(), "-2.0", run.stderr)


if __name__ == "__main__":
    unittest.main()
