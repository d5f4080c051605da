"""What Python users expect of functions, results and parameters: named tuples, text, pickles, copies."""
import copy
import functools
import importlib.util
import multiprocessing
import pickle
import sys
import unittest

import numpy as np

from common import RANDOM, leg


class Objects(unittest.TestCase):
    def test_results(self):
        p, q = leg.Parameters(), RANDOM.uniform(-1, 1, 3)
        result = leg.joint_space_inertia_factor(p, q)
        self.assertIsInstance(result, tuple)
        self.assertEqual(result._fields, ("L", "inverse_diagonal"))
        self.assertIs(type(result), leg.joint_space_inertia_factor_result)
        self.assertRegex(repr(result), r"^joint_space_inertia_factor_result\(L=array\(\[\[")
        for other in (pickle.loads(pickle.dumps(result)), copy.copy(result), copy.deepcopy(result), result._replace(L=result.L)):
            self.assertIs(type(other), type(result))
            np.testing.assert_array_equal(other.L, result.L)
            np.testing.assert_array_equal(other.inverse_diagonal, result.inverse_diagonal)
        self.assertIs(pickle.loads(pickle.dumps(leg.transforms.homogeneous.fr_base_X_fr_foot)), leg.transforms.homogeneous.fr_base_X_fr_foot)

    def test_parameters(self):
        p = leg.Parameters(upperleg_length=0.4)
        self.assertIn("upperleg_length=0.4, ", repr(p))
        self.assertEqual(eval(repr(p), {"Parameters": leg.Parameters}), p)
        self.assertNotEqual(leg.Parameters(), p)
        self.assertEqual(len({p, leg.Parameters(upperleg_length=0.4), leg.Parameters()}), 2)
        self.assertLessEqual(set(leg.parameter_names), set(dir(p)))
        q = RANDOM.uniform(-1, 1, 3)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            other = pickle.loads(pickle.dumps(p, protocol))
            self.assertEqual(other, p)
            np.testing.assert_array_equal(leg.gravity_forces(other, q), leg.gravity_forces(p, q))
        self.assertEqual((copy.copy(p), copy.deepcopy(p)), (p, p))

    def test_one_library_twice(self):
        """The same file under another name: nothing is shared, neither types nor functions."""
        spec = importlib.util.spec_from_file_location("another.leg", leg.__file__)
        other = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(other)
        self.assertNotIn("another.leg", sys.modules)
        self.assertIs(sys.modules["leg"], leg)
        self.assertIsNot(other.Parameters, leg.Parameters)
        q = RANDOM.uniform(-1, 1, 3)
        with self.assertRaisesRegex(TypeError, "gravity_forces: parameters must be Parameters of the module, not those of another module"):
            leg.gravity_forces(other.Parameters(), q)
        np.testing.assert_array_equal(other.gravity_forces(other.Parameters(), q), leg.gravity_forces(leg.Parameters(), q))
        self.assertEqual(other.Parameters.__module__, "another.leg")

    def test_processes(self):
        p, states = leg.Parameters(), RANDOM.uniform(-1, 1, (6, 3))
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            factors = pool.map(functools.partial(leg.joint_space_inertia_factor, p), states)
        for factor, q in zip(factors, states):
            np.testing.assert_array_equal(factor.L, leg.joint_space_inertia_factor(p, q).L)


if __name__ == "__main__":
    unittest.main()
