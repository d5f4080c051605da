"""Wrong arguments: an exception that names the function, the argument, what is expected and what is given."""
import subprocess
import sys
import unittest

import numpy as np

from common import arm, ball_leg, leg, walker

Z = np.zeros(7)
Z2 = np.zeros((4, 7))


class Errors(unittest.TestCase):
    def refuse(self, kind, message, *args, function=arm.inverse_dynamics, **kwargs):
        with self.assertRaises(kind) as caught:
            function(*args, **kwargs)
        self.assertEqual(str(caught.exception), message)

    def test_shapes(self):
        start = "inverse_dynamics: q must have the shape (7,) or (N, 7), has "
        for wrong, given in ((np.zeros(6), "(6,)"), (np.zeros((4, 6)), "(4, 6)"), (np.zeros((2, 3, 7)), "(2, 3, 7)"),
                             (np.float64(1), "()"), (1.0, "()"), ([1, 2], "(2,)"), (np.zeros((7, 1)), "(7, 1)")):
            self.refuse(ValueError, start + given, wrong, Z, Z)
        self.refuse(ValueError, "inverse_dynamics: q has 4 states, qdd has 5", Z2, Z, np.zeros((5, 7)))
        self.refuse(
            ValueError, "inverse_dynamics: external must have the shape (8, 6) or (N, 8, 6), has (6, 8)", Z, Z, Z,
            external=np.zeros((6, 8)))
        self.refuse(
            ValueError, "inverse_dynamics: q has sequences of different lengths: 7 and 6", [[0.0] * 7, [0.0] * 6], Z, Z)
        self.refuse(ValueError, "inverse_dynamics: q mixes numbers and sequences", [[0.0] * 7, 1.0], Z, Z)
        self.refuse(ValueError, "inverse_dynamics: q has too many dimensions", [[[[0.0]]]], Z, Z)

    def test_types(self):
        wrong = "must be numbers, an array of float64 or float32 or a sequence"
        for value in ("1234567", b"1234567", {"a": 1}, object(), ["a"] * 7, np.zeros(7, complex), np.array(["a"] * 7)):
            self.refuse(ValueError, f"inverse_dynamics: qd {wrong}", Z, value, Z)

    def test_calls(self):
        self.refuse(TypeError, "inverse_dynamics: qdd is missing", Z, Z)
        self.refuse(TypeError, "inverse_dynamics: q is missing", None, Z, Z)
        self.refuse(TypeError, "inverse_dynamics: takes at most 5 arguments, got 6", Z, Z, Z, None, None, Z)
        self.refuse(
            TypeError, "inverse_dynamics: unknown argument 'speed'; the arguments are q, qd, qdd, gravity, external, out", Z, Z, Z,
            speed=1)
        self.refuse(TypeError, "inverse_dynamics: q is given twice", Z, Z, Z, q=Z)

    def test_out(self):
        out = "inverse_dynamics: out for tau "
        frozen = np.zeros(7)
        frozen.flags.writeable = False
        self.refuse(ValueError, out + "must be a writable array", Z, Z, Z, out=frozen)
        self.refuse(ValueError, out + "must be an array of float64 or float32", Z, Z, Z, out=[0.0] * 7)
        self.refuse(ValueError, out + "must be an array of float64 or float32", Z, Z, Z, out=np.zeros(7, int))
        self.refuse(ValueError, out + "must be float64, like the arguments", Z, Z, Z, out=np.zeros(7, np.float32))
        self.refuse(ValueError, out + "must have the shape (7,) or (N, 7), has (6,)", Z, Z, Z, out=np.zeros(6))
        self.refuse(ValueError, out + "must have the shape (4, 7), has (3, 7)", Z2, Z, Z, out=np.zeros((3, 7)))
        self.refuse(ValueError, out + "must have the shape (7,), has (4, 7)", Z, Z, Z, out=np.zeros((4, 7)))
        both = np.zeros(10)
        self.refuse(ValueError, out + "overlaps qd", Z, both[:7], Z, out=both[3:])
        self.refuse(ValueError, out + "overlaps q", both[:7], Z, Z, out=both[:7])
        for strides in ((0, 8), (8, 8), (56, 4)):
            shared = np.lib.stride_tricks.as_strided(np.zeros(100), (3, 7), strides)
            self.refuse(ValueError, out + "has elements that share memory", np.zeros((3, 7)), Z, Z, out=shared)
        L = np.zeros(9)
        self.refuse(
            ValueError, "joint_space_inertia_factor: out for inverse_diagonal overlaps that for L", leg.Parameters(), [0, 0, 0],
            function=leg.joint_space_inertia_factor, out=(L.reshape(3, 3), L[:3]))
        self.refuse(
            ValueError, "joint_space_inertia_factor: out must be a tuple of 2 arrays", leg.Parameters(), [0, 0, 0],
            function=leg.joint_space_inertia_factor, out=L)

    def test_parameters(self):
        self.refuse(
            TypeError, "Parameters takes keyword arguments only, such as Parameters(lowerleg_com_z=1.0)".replace(
                "lowerleg_com_z", leg.parameter_names[0]), 1.0, function=leg.Parameters)
        names = ", ".join(leg.parameter_names)
        self.refuse(
            TypeError, f"Parameters has no 'payload'; its names are {names}", payload=1.0, function=leg.Parameters)
        self.refuse(TypeError, "Parameters: upperleg_length must be a number, is a str", upperleg_length="long", function=leg.Parameters)
        p = leg.Parameters()
        with self.assertRaises(AttributeError) as caught:
            p.payload
        self.assertEqual(str(caught.exception), f"Parameters has no 'payload'; its names are {names}")
        with self.assertRaises(AttributeError):
            p.upperleg_length = 1.0
        q, start = np.zeros(3), "inverse_dynamics: parameters "
        missing = start + "is missing: the first argument must be Parameters of the module, is a "
        self.refuse(TypeError, missing + "ndarray", q, q, q, function=leg.inverse_dynamics)
        self.refuse(TypeError, missing + "list", [1, 2], q, q, q, function=leg.inverse_dynamics)
        self.refuse(TypeError, start + "is missing", q=q, qd=q, qdd=q, function=leg.inverse_dynamics)
        wrong = start + "must be Parameters of the module, is "
        self.refuse(TypeError, wrong + "a dict", parameters={}, q=q, qd=q, qdd=q, function=leg.inverse_dynamics)

    def test_quaternions(self):
        """Positions in another order, or zeros, are not a pose, whose first four numbers are a unit quaternion."""
        start = "gravity_in_base: base_pose[0:4] must be a unit quaternion w, x, y, z, followed by the position: its norm "
        end = "; base_pose_from_mujoco and base_pose_from_ros take other orders"
        of_mujoco = [1, 2, 0.5, 0.6, 0.8, 0, 0]
        self.refuse(ValueError, start + "is 2.36854" + end, of_mujoco, function=walker.gravity_in_base)
        self.refuse(ValueError, start + "is 0" + end, np.zeros(7, np.float32), function=walker.gravity_in_base)
        good = walker.base_pose_from_mujoco(of_mujoco)
        self.refuse(ValueError, start + "in state 1 is 2.36854" + end, [good, of_mujoco], function=walker.gravity_in_base)
        self.assertTrue(np.isnan(walker.gravity_in_base([good, good * np.nan])[1]).all())
        walker.gravity_in_base(np.round(walker.base_pose_from_mujoco([0, 0, 0, 0.5001, 0.5, 0.4999, 0.5]), 4))
        self.refuse(
            ValueError, "base_pose_from_ros: orientation[0:4] must be a unit quaternion x, y, z, w: its norm is 0", np.zeros(3),
            np.zeros(4), function=walker.base_pose_from_ros)
        q = np.zeros(9)
        q[[0, 5]] = 1
        rest = np.zeros(7)
        ball_leg.inverse_dynamics(q, rest, rest)
        q[5] = 1.01
        self.refuse(
            ValueError, "inverse_dynamics: q[5:9] must be a unit quaternion w, x, y, z: its norm is 1.01", q, rest, rest,
            function=ball_leg.inverse_dynamics)

    def test_without_numpy(self):
        code = ("import sys; sys.modules['numpy'] = None; import arm; t = arm.inverse_dynamics([0.1] * 7, [0] * 7, [0] * 7);"
                "H = arm.joint_space_inertia([[0.1] * 7] * 2); print(type(t).__name__, t.shape, t.format, H.shape)")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
        self.assertEqual((run.stdout, run.stderr), ("memoryview (7,) d (2, 7, 7)\n", ""))


if __name__ == "__main__":
    unittest.main()
