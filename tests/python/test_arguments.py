"""All kinds of arguments, and results that the caller gives."""
import array
import unittest

import numpy as np

from common import RANDOM, arm, leg

N = 6
Q, QD, QDD = (RANDOM.uniform(-1, 1, (N, 7)) for _ in range(3))
ONE = np.array([arm.inverse_dynamics(*state) for state in zip(Q, QD, QDD)])


class Arguments(unittest.TestCase):
    def check(self, result, expected=ONE, tolerance=1e-11):
        np.testing.assert_allclose(result, expected, rtol=0, atol=tolerance)

    def test_many_states(self):
        self.check(arm.inverse_dynamics(Q, QD, QDD))
        self.assertEqual(arm.joint_space_inertia(Q).shape, (N, 7, 7))
        for n in (1, 2, 3, 17):
            q = RANDOM.uniform(-1, 1, (n, 7))
            self.check(arm.joint_space_inertia(q), [arm.joint_space_inertia(x) for x in q])

    def test_matrices_of_many_states_in_any_order(self):
        """More states than are copied at a time; matrices row by row, column by column, and with gaps."""
        n = 150
        states = [RANDOM.uniform(-1, 1, (n, 7)) for _ in range(3)]
        expected = [arm.inverse_dynamics_derivatives(*state) for state in zip(*states)]
        results = (
            arm.inverse_dynamics_derivatives(*states),
            [np.zeros((n, 7)), *(np.zeros((n, 7, 7)).transpose(0, 2, 1) for _ in range(3))],
            [np.zeros((n, 14))[:, ::2], np.zeros((n, 7, 7)), *(np.zeros((2 * n, 7, 14))[::-2, :, 1::2] for _ in range(2))])
        for out in results[1:]:
            arm.inverse_dynamics_derivatives(*states, out=tuple(out))
        for result in results:
            for k, array in enumerate(result):
                self.check(array, [state[k] for state in expected])
        single = arm.inverse_dynamics_derivatives(*(x.astype(np.float32) for x in states))
        self.check(single[1], [state[1] for state in expected], 1e-3)

    def test_many_states_that_are_copied(self):
        n = 150
        q, qd, qdd = (RANDOM.uniform(-1, 1, (n, 7)) for _ in range(3))
        raw = np.zeros(8 * q.size + 1, np.uint8)
        odd = raw[1:].view(np.float64).reshape(q.shape)
        odd[:] = q
        expected = [arm.inverse_dynamics(*state) for state in zip(q, qd, qdd.astype(np.float32))]
        self.check(arm.inverse_dynamics(odd, qd[::-1][::-1], qdd.astype(np.float32)), expected)

    def test_none_and_one_state(self):
        self.assertEqual(arm.inverse_dynamics(Q[:0], QD[:0], QDD[:0]).shape, (0, 7))
        self.assertEqual(arm.inverse_dynamics(Q[:0], QD[0], QDD[0]).shape, (0, 7))
        self.assertEqual(arm.inverse_dynamics([], [], []).shape, (0, 7))
        self.check(arm.inverse_dynamics(Q[:1], QD[:1], QDD[:1]), ONE[:1])

    def test_one_value_for_all_states(self):
        expected = [arm.inverse_dynamics(q, QD[0], QDD[0]) for q in Q]
        self.check(arm.inverse_dynamics(Q, QD[0], QDD[0]), expected)
        self.check(arm.inverse_dynamics(Q, QD[:1], QDD[0]), expected)
        self.check(arm.inverse_dynamics(Q, QD, QDD, gravity=[0, 0, -9.81]))
        p = leg.Parameters()
        q = RANDOM.uniform(-1, 1, (4, 3))
        self.check(leg.gravity_forces(p, q), [leg.gravity_forces(p, x) for x in q])

    def test_lists_tuples_and_other_numbers(self):
        self.check(arm.inverse_dynamics(Q.tolist(), tuple(map(tuple, QD)), list(QDD)))
        self.check(arm.inverse_dynamics(array.array("d", Q[0]), QD[0], memoryview(QDD[0])), ONE[0])
        whole = np.arange(7)
        self.check(arm.joint_space_inertia(whole), arm.joint_space_inertia(whole.astype(float)))
        self.check(arm.joint_space_inertia(Q.astype(">f8")), arm.joint_space_inertia(Q))
        self.check(arm.joint_space_inertia(Q.astype(np.longdouble)), arm.joint_space_inertia(Q))

    def test_single_precision(self):
        single = [x.astype(np.float32) for x in (Q, QD, QDD)]
        result = arm.inverse_dynamics(*single)
        self.assertEqual(result.dtype, np.float32)
        self.check(result, ONE, 1e-3)
        self.assertEqual(arm.inverse_dynamics(single[0], QD, QDD).dtype, np.float64)
        self.assertEqual(arm.inverse_dynamics(*single, gravity=[0, 0, -9.81]).dtype, np.float32)

    def test_strides(self):
        wide = np.zeros((2 * N, 21))
        wide[::2, ::3] = Q
        backwards = Q[::-1, ::-1].copy()
        raw = np.zeros(8 * Q.size + 1, np.uint8)
        odd = raw[1:].view(np.float64).reshape(Q.shape)
        odd[:] = Q
        for q in (wide[::2, ::3], np.asfortranarray(Q), backwards[::-1, ::-1], odd):
            self.check(arm.inverse_dynamics(q, QD, QDD))
            self.check([arm.inverse_dynamics(*state) for state in zip(q, QD, QDD)])
        self.check(arm.inverse_dynamics(np.broadcast_to(Q[0], (N, 7)), QD, QDD), arm.inverse_dynamics(Q[0], QD, QDD))
        read_only = Q.copy()
        read_only.flags.writeable = False
        self.check(arm.inverse_dynamics(read_only, QD, QDD))

    def test_out(self):
        out = np.full((N, 7), np.nan)
        self.assertIs(arm.inverse_dynamics(Q, QD, QDD, out=out), out)
        self.check(out)
        wide = np.full((N, 14), np.nan)
        arm.inverse_dynamics(Q, QD, QDD, out=wide[:, ::2])
        self.check(wide[:, ::2])
        self.assertTrue(np.isnan(wide[:, 1::2]).all())
        tau = np.zeros(7)
        self.assertIs(arm.inverse_dynamics(Q[0], QD[0], QDD[0], out=tau), tau)
        self.check(tau, ONE[0])
        p, q = leg.Parameters(), np.array([0.1, 0.2, 0.3])
        L, inverse = np.zeros((3, 3)), np.zeros(3)
        leg.joint_space_inertia_factor(p, q, out=(L, inverse))
        self.check(L.T @ L, leg.joint_space_inertia(p, q))
        for order in "CF":
            J = np.zeros((6, 3), order=order)
            leg.jacobians.fr_base_J_fr_foot(p, q, out=J)
            self.check(J, leg.jacobians.fr_base_J_fr_foot(p, q))

    def test_nan_stays_in_its_state(self):
        q = Q.copy()
        q[2, 3] = np.nan
        tau = arm.inverse_dynamics(q, QD, QDD)
        self.assertTrue(np.isnan(tau[2]).any())
        keep = np.arange(N) != 2
        self.check(tau[keep], ONE[keep])

    def test_keywords(self):
        self.check(arm.inverse_dynamics(qdd=QDD, q=Q, qd=QD, gravity=None, out=None))
        self.check(arm.inverse_dynamics(Q, QD, **{"q" + "dd": QDD}))


if __name__ == "__main__":
    unittest.main()
