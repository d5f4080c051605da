"""Every function of every module gives what `robcogen eval` gives."""
import re
import unittest

import numpy as np

from common import MODELS, RANDOM, arm, ball_leg, evaluate, five_bar, leg, random_values, scopes, walker


# They are Python's own.
OF_POSES = ("base_pose_from_mujoco", "base_pose_to_mujoco", "base_pose_from_ros", "base_pose_to_ros", "gravity_in_base", "integrate",
            "difference")


def shapes(function):
    """Arguments and results with their shapes, as the documentation lists them."""
    arguments, results = {}, {}
    for line in function.__doc__.splitlines():
        match = re.fullmatch(r"(returns )?(\w+): (\([\d, ]*\)|Parameters)", line)
        if match:
            shape = "parameters" if match[3] == "Parameters" else tuple(int(n) for n in re.findall(r"\d+", match[3]))
            (results if match[1] else arguments)[match[2]] = shape
    return arguments, results


def parameters_of(module):
    return {name: 1.1 * getattr(module.Parameters(), name) for name in module.parameter_names}


DERIVED = {
    "inverse_dynamics_d_q": ("--derivatives", "inverse_dynamics:q"),
    "contact_jacobian_d_q": ("--derivatives", "contact_jacobian:q"),
    "inverse_dynamics_gradient_parameters_q": ("--gradients", "inverse_dynamics:parameters,q"),
    "forward_dynamics_gradient_q": ("--gradients", "forward_dynamics:q"),
    "forward_dynamics_gradient_gravity": ("--gradients", "forward_dynamics:gravity"),
    "kinetic_energy_gradient_q_qd": ("--gradients", "kinetic_energy:q,qd"),
    "potential_energy_tangent_q": ("--tangents", "potential_energy:q"),
}


class Values(unittest.TestCase):
    def compare(self, module, name, function, state, *options):
        arguments, results = shapes(function)
        given, asked = {}, {}
        for key, shape in arguments.items():
            if shape == "parameters":
                asked[key] = parameters_of(module)
                given[key] = module.Parameters(**asked[key])
                continue
            if key not in state:
                state[key] = random_values(module, key, shape)
            given[key] = state[key]
            asked[key] = state[key]
            if key == "external":
                asked[key] = {link: list(w) for link, w in zip(module.link_names, state[key])}
        expected = evaluate(module, name, [asked], *options)[0]
        got = function(**given)
        in_float = function(**{k: np.asarray(v, np.float32) if arguments[k] != "parameters" else v for k, v in given.items()})
        if len(results) == 1:
            got, in_float = (got,), (in_float,)
        else:
            self.assertEqual((set(expected), list(got._fields)), (set(results), list(results)), name)
        for i, (key, shape) in enumerate(results.items()):
            wanted = np.asarray(expected[key])
            if len(shape) == 3:  # rows of the derivative of a matrix are its elements, column by column
                wanted = wanted.reshape(shape[1], shape[0], shape[2]).transpose(1, 0, 2)
            scale = 1e-9 * (1 + np.abs(wanted).max(initial=0))
            self.assertEqual(np.shape(got[i]), shape, name)
            np.testing.assert_allclose(np.asarray(got[i]).reshape(-1), wanted.reshape(-1), rtol=0, atol=scale, err_msg=name)
            if len(arguments) > ("parameters" in arguments):
                np.testing.assert_allclose(
                    np.asarray(in_float[i]).reshape(-1), wanted.reshape(-1), rtol=0, atol=3e5 * scale, err_msg=name)
                self.assertIn(np.asarray(in_float[i]).dtype, (np.dtype(np.float32), np.dtype(float)))

    def test_all_functions(self):
        count = 0
        for module in MODELS:
            for name, function in scopes(module):
                if name.startswith("inertia_factor") or name in OF_POSES:
                    continue
                self.compare(module, name, function, {}, *DERIVED.get(name, ()))
                count += 1
        self.assertGreater(count, 50)

    @unittest.skipUnless(five_bar, "only where everything is tested")
    def test_loops(self):
        """The elbows follow: forward against inverse dynamics, many states against one, and the rate of the energy."""
        q, qd, tau = 0.3 * RANDOM.uniform(-1, 1, (3, 7, five_bar.dof))
        qdd = five_bar.forward_dynamics(q, qd, tau)
        np.testing.assert_allclose(five_bar.inverse_dynamics(q, qd, qdd), tau, atol=1e-12)
        np.testing.assert_allclose(qdd[3], five_bar.forward_dynamics(q[3], qd[3], tau[3]), rtol=1e-13)

        def change(function):
            step = 1e-6
            return (function(q + step * qd, qd + step * qdd) - function(q - step * qd, qd - step * qdd)) / (2 * step)

        energy = change(five_bar.kinetic_energy) + change(lambda q, _: five_bar.potential_energy(q))
        rates = change(lambda q, _: five_bar.joint_positions(q))
        damped = 0.002 * (rates[:, 2:] ** 2).sum(axis=1)
        np.testing.assert_allclose(energy, (tau * qd).sum(axis=1) - damped, atol=1e-8)

    def test_contacts(self):
        """A foot that holds: its acceleration, J a + bias, is zero."""
        q, qd = RANDOM.uniform(-1, 1, 3), RANDOM.uniform(-1, 1, 3)
        base, gravity, tau = RANDOM.uniform(-1, 1, 6), np.array([0, 0, -9.81]), RANDOM.uniform(-1, 1, 3)
        known = dict(scopes(walker))
        self.assertIn("contact_jacobian", known)
        state = {"q": q, "qd": qd, "base_velocity": base, "gravity": gravity, "tau": tau, "contact_acceleration": [0.0] * 3,
                 "active": [1.0], "activity": [1.0], "compliance": [0.0] * 3}

        def call(name):
            return known[name](**{k: v for k, v in state.items() if k in shapes(known[name])[0]})

        J, bias, dynamics = call("contact_jacobian"), call("contact_bias"), call("constrained_forward_dynamics")
        a = np.concatenate([dynamics.base_acceleration, dynamics.qdd])
        np.testing.assert_allclose(J @ a + bias, 0, atol=1e-9)

    def test_factor(self):
        p, q, x = leg.Parameters(), RANDOM.uniform(-1, 1, 3), RANDOM.uniform(-1, 1, 3)
        H = leg.joint_space_inertia(p, q)
        factor = leg.joint_space_inertia_factor(p, q)
        np.testing.assert_allclose(factor.L.T @ factor.L, H, atol=1e-12)
        np.testing.assert_allclose(H @ leg.inertia_factor.solve(factor.L, factor.inverse_diagonal, x), x, atol=1e-12)

    def test_matrices_are_those_of_columns_and_rows(self):
        p, q = leg.Parameters(), np.array([0.3, 0.1, 0.2])
        X = leg.transforms.homogeneous.fr_base_X_fr_foot(p, q)
        J = leg.jacobians.fr_base_J_fr_foot(p, q)
        np.testing.assert_allclose(X[3], [0, 0, 0, 1])
        np.testing.assert_allclose(X[:3, :3] @ X[:3, :3].T, np.eye(3), atol=1e-14)
        step = 1e-6
        for k in range(3):
            moved = leg.transforms.homogeneous.fr_base_X_fr_foot(p, q + step * np.eye(3)[k])
            np.testing.assert_allclose((moved - X)[:3, 3] / step, J[3:, k], atol=1e-5)

    def test_many_states_with_quaternions(self):
        states = [random_values(ball_leg, name, (7, size)) for name, size in (("q", 9), ("qd", 7), ("qdd", 7))]
        many = ball_leg.inverse_dynamics(*states)
        self.assertEqual(many.shape, (7, 7))
        for k in range(7):
            np.testing.assert_allclose(many[k], ball_leg.inverse_dynamics(*(s[k] for s in states)), atol=1e-10)
        self.assertIn("hip_w hip_x hip_y hip_z", ball_leg.inverse_dynamics.__doc__)

    def test_default_gravity_is_standard(self):
        q, zero = RANDOM.uniform(-1, 1, 7), np.zeros(7)
        wrench = np.zeros((len(arm.link_names), 6))
        down = arm.inverse_dynamics(q, zero, zero)
        np.testing.assert_allclose(arm.inverse_dynamics(q, zero, zero, gravity=[0, 0, -9.81]), down, atol=1e-12)
        np.testing.assert_allclose(arm.inverse_dynamics(q, zero, zero, external=wrench), down, atol=1e-12)
        np.testing.assert_allclose(arm.inverse_dynamics(q, zero, zero, [0, 0, 0]), zero, atol=1e-12)

    def test_the_model(self):
        self.assertEqual((arm.dof, leg.dof), (7, 3))
        self.assertEqual(leg.joint_names, ("SLIDE", "HFE", "KFE"))
        self.assertEqual(leg.link_parents, (-1, 0, 1, 2))
        self.assertEqual(arm.position_names, arm.joint_names)
        self.assertEqual((ball_leg.dof, len(ball_leg.position_names)), (7, 9))
        self.assertEqual(ball_leg.position_names[:5], ("hip_w", "hip_x", "hip_y", "hip_z", "knee"))
        self.assertEqual(ball_leg.link_parents, (-1, 0, 1, 2))
        self.assertEqual(len(arm.link_names), 8)
        self.assertEqual(leg.Parameters(upperleg_length=0.4).upperleg_length, 0.4)
        self.assertAlmostEqual(leg.Parameters().lowerleg_length, 0.33)

    def test_the_limbs(self):
        self.assertEqual(leg.limbs, {})

    @unittest.skipUnless(five_bar, "only where everything is tested")
    def test_six_limbs(self):
        import hexapod
        self.assertEqual(len(hexapod.limbs), 6)
        joints = []
        for name, limb in hexapod.limbs.items():
            self.assertEqual((limb.name, limb.part, limb.first_link), (name, "Leg", min(limb.links.values())))
            for own, names in ((limb.links, hexapod.link_names), (limb.joints, hexapod.joint_names), (limb.frames, hexapod.frame_names)):
                self.assertTrue(own)
                for element, index in own.items():
                    self.assertEqual(names[index], f"fr_{name}_{element[3:]}" if element.startswith("fr_") else f"{name}_{element}")
            joints += limb.joints.values()
        self.assertEqual(sorted(joints), list(range(hexapod.dof)))


if __name__ == "__main__":
    unittest.main()
