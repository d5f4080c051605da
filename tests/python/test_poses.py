"""Poses of the base: orders of other libraries, gravity, integration and differences."""
import unittest

import numpy as np

from common import RANDOM, ball_leg, leg, random_values, walker


def rotation(quaternion):
    """Of a unit quaternion w, x, y, z: the matrix from the axis and the angle (Rodrigues)."""
    w, v = quaternion[0], np.asarray(quaternion[1:])
    sine = np.linalg.norm(v)
    K = np.cross(np.eye(3), v / sine if sine > 0 else v)
    angle = 2 * np.arctan2(sine, w)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def random_pose():
    pose = RANDOM.uniform(-1, 1, 7)
    pose[:4] /= np.linalg.norm(pose[:4])
    return pose


class Poses(unittest.TestCase):
    def test_orders(self):
        # A quarter turn about z, at (1, 2, 3).
        s = np.sqrt(0.5)
        pose = walker.base_pose_from_mujoco([1, 2, 3, s, 0, 0, s])
        np.testing.assert_allclose(pose, [s, 0, 0, s, 1, 2, 3], rtol=1e-15)
        np.testing.assert_allclose(walker.base_pose_from_ros([1, 2, 3], [0, 0, s, s]), pose, rtol=1e-15)
        np.testing.assert_allclose(walker.base_pose_to_mujoco(pose), [1, 2, 3, s, 0, 0, s], rtol=1e-15)
        result = walker.base_pose_to_ros(pose)
        np.testing.assert_allclose(result.position, [1, 2, 3])
        np.testing.assert_allclose(result.orientation, [0, 0, s, s], rtol=1e-15)
        many = walker.base_pose_from_mujoco(np.tile([1, 2, 3, s, 0, 0, s], (5, 1)))
        np.testing.assert_array_equal(many, np.tile(pose, (5, 1)))
        self.assertEqual(walker.base_pose_from_mujoco(np.float32([1, 2, 3, 1, 0, 0, 0])).dtype, np.float32)
        self.assertFalse(hasattr(leg, "base_pose_from_mujoco"))
        self.assertFalse(hasattr(ball_leg, "integrate"))

    def test_gravity(self):
        for _ in range(5):
            pose, gravity = random_pose(), RANDOM.uniform(-1, 1, 3)
            R = rotation(pose[:4])
            np.testing.assert_allclose(walker.gravity_in_base(pose), R.T @ [0, 0, -9.81], atol=1e-14)
            np.testing.assert_allclose(walker.gravity_in_base(pose, gravity), R.T @ gravity, atol=1e-14)

    def test_integration(self):
        """Against small steps of the differential equation."""
        q, qd, pose, velocity = RANDOM.uniform(-1, 1, 3), RANDOM.uniform(-1, 1, 3), random_pose(), RANDOM.uniform(-2, 2, 6)
        dt, steps = 0.7, 20_000
        R, p = rotation(pose[:4]), pose[4:].copy()
        turn = np.cross(np.eye(3), velocity[:3]) * dt / steps
        small = np.eye(3) + turn + turn @ turn / 2 + turn @ turn @ turn / 6
        for _ in range(steps):
            middle = R @ (np.eye(3) + turn / 2 + turn @ turn / 8)
            p += middle @ velocity[3:] * dt / steps
            R = R @ small
        moved = walker.integrate(q, qd, pose, velocity, dt)
        np.testing.assert_allclose(moved.q, q + dt * qd, rtol=1e-15)
        np.testing.assert_allclose(rotation(moved.base_pose[:4]), R, atol=1e-8)
        np.testing.assert_allclose(moved.base_pose[4:], p, atol=1e-8)
        np.testing.assert_allclose(walker.integrate(q, qd, pose, 0 * velocity, dt).base_pose, pose, rtol=1e-14)

    def test_difference(self):
        # Turns of every size up to half a turn.
        for size in (0.0, 1e-9, 1e-4, 0.3, 0.99, 1.01, 2.0, 3.1):
            q, qd, pose, velocity = RANDOM.uniform(-1, 1, 3), RANDOM.uniform(-1, 1, 3), random_pose(), RANDOM.uniform(-1, 1, 6)
            velocity[:3] *= size / np.linalg.norm(velocity[:3])
            moved = walker.integrate(q, qd, pose, velocity, 1.0)
            back = walker.difference(q, moved.q, pose, moved.base_pose)
            np.testing.assert_allclose(back.qd, qd, atol=1e-13)
            np.testing.assert_allclose(back.base_velocity, velocity, atol=1e-12)
            # Both signs of a quaternion are the same orientation.
            flipped = moved.base_pose * [-1, -1, -1, -1, 1, 1, 1]
            np.testing.assert_allclose(walker.difference(q, moved.q, pose, flipped).base_velocity, velocity, atol=1e-12)

    def test_a_step_of_simulation(self):
        """A base that falls freely without rotating moves as a point does."""
        q, rest = np.zeros(3), np.zeros(3)
        pose, velocity = walker.base_pose_from_ros([0, 0, 2], [0, 0, 0, 1]), np.zeros(6)
        motion = walker.forward_dynamics(q, rest, rest, velocity, walker.gravity_in_base(pose))
        np.testing.assert_allclose(motion.base_acceleration, [0, 0, 0, 0, 0, -9.81], atol=1e-12)
        velocity = velocity + 0.1 * motion.base_acceleration
        pose = walker.integrate(q, rest, pose, velocity, 0.1).base_pose
        np.testing.assert_allclose(pose, [1, 0, 0, 0, 0, 0, 2 - 0.0981], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
