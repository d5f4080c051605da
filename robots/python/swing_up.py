"""A cart swings its pole up: iterative LQR in Python, linearised by generated derivatives, all steps in one call. Run it with the
package robcogen on PYTHONPATH; with matplotlib and the argument --plot FILE it draws the motion.
"""
import sys
from pathlib import Path

import numpy as np

import robcogen

MODEL = Path(__file__).resolve().parent.parent / "optimal_control" / "cart_pole.kindsl"
STEP, STEPS = 0.02, 150  # s


class CartPole:
    """Steps of explicit Euler; the state has position of the cart and angle of the pole, then their velocities."""

    def __init__(self, robot, upright):
        self.robot, self.goal = robot, np.array([0.0, upright, 0.0, 0.0])
        self.weights, self.final_weights, self.effort = np.diag([0.1, 0.1, 0.01, 0.01]), np.diag([500.0, 500.0, 50.0, 50.0]), 1e-2

    def next(self, x, u):
        return x + STEP * np.concatenate([x[2:], self.robot.forward_dynamics(x[:2], x[2:], [u, 0.0])])

    def linearise(self, X, U):
        """The derivatives of all steps, by state (N, 4, 4) and by force (N, 4)."""
        forces = np.stack([U, np.zeros_like(U)], axis=1)
        d = self.robot.forward_dynamics_derivatives(X[:-1, :2], X[:-1, 2:], forces)
        A = np.tile(np.eye(4), (len(U), 1, 1))
        A[:, :2, 2:] += STEP * np.eye(2)
        A[:, 2:, :2] += STEP * d.d_q
        A[:, 2:, 2:] += STEP * d.d_qd
        B = np.zeros((len(U), 4))
        B[:, 2:] = STEP * d.d_tau[:, :, 0]
        return A, B

    def roll(self, x, U):
        X = [x]
        for u in U:
            X.append(self.next(X[-1], u))
        return np.array(X)

    def cost(self, X, U):
        e = X - self.goal
        running = np.einsum("ki,ij,kj->", e[:-1], self.weights, e[:-1]) + self.effort * U @ U
        return STEP * running + e[-1] @ self.final_weights @ e[-1]


def backward(problem, X, U, damping):
    """The changes of forces: open loop, and as feedback; None where the cost is not convex in the force."""
    A, B = problem.linearise(X, U)
    e = X - problem.goal
    Vx, Vxx = 2 * problem.final_weights @ e[-1], 2 * problem.final_weights
    k, K = np.zeros(len(U)), np.zeros((len(U), 4))
    for i in reversed(range(len(U))):
        Qx = 2 * STEP * problem.weights @ e[i] + A[i].T @ Vx
        Qu = 2 * STEP * problem.effort * U[i] + B[i] @ Vx
        Qxx = 2 * STEP * problem.weights + A[i].T @ Vxx @ A[i]
        Quu = 2 * STEP * problem.effort + B[i] @ Vxx @ B[i] + damping
        Qux = B[i] @ Vxx @ A[i]
        if Quu <= 0:
            return None
        k[i], K[i] = -Qu / Quu, -Qux / Quu
        Vx = Qx + K[i] * Quu * k[i] + K[i] * Qu + Qux * k[i]
        Vxx = Qxx + Quu * np.outer(K[i], K[i]) + np.outer(K[i], Qux) + np.outer(Qux, K[i])
    return k, K


def optimise(problem, start, iterations=300):
    """States, forces and the costs of the iterations (Tassa, Erez, Todorov, IROS 2012)."""
    U = np.zeros(STEPS)
    X = problem.roll(start, U)
    costs, damping = [problem.cost(X, U)], 1e-6
    for _ in range(iterations):
        steps = backward(problem, X, U, damping)
        better = None
        for scale in 0.5 ** np.arange(10) if steps else ():
            k, K = steps
            Xs, Us = [start], []
            for i in range(STEPS):
                Us.append(U[i] + scale * k[i] + K[i] @ (Xs[-1] - X[i]))
                Xs.append(problem.next(Xs[-1], Us[-1]))
                if not np.abs(Xs[-1]).max() < 1e3:  # it diverges
                    break
            Xs, Us = np.array(Xs), np.array(Us)
            if len(Us) == STEPS and problem.cost(Xs, Us) < costs[-1]:
                better = Xs, Us
                break
        if better is None:
            damping *= 10
            if damping > 1e6:
                break
            continue
        X, U = better
        costs.append(problem.cost(X, U))
        damping = max(damping / 5, 1e-9)
        if costs[-2] - costs[-1] < 1e-7 * costs[-1]:
            break
    return X, U, costs


def plot(file, X, U, costs):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(14, 4), layout="constrained")
    t = STEP * np.arange(len(X))
    left.plot(t, X[:, :2], label=["cart (m)", "pole (rad)"])
    left.set(xlabel="time (s)")
    left.legend()
    middle.step(t[:-1], U)
    middle.set(xlabel="time (s)", ylabel="force (N)")
    right.semilogy(costs)
    right.set(xlabel="iteration", ylabel="cost")
    figure.savefig(file)


def main():
    robot = robcogen.load(MODEL, name="cart_pole", algorithms=["forward_dynamics", "forward_dynamics_derivatives", "energy"])
    # The pole is upright where its potential energy is greatest; it begins opposite.
    angles = np.linspace(-np.pi, np.pi, 721)
    heights = robot.potential_energy(np.stack([np.zeros_like(angles), angles], axis=1))
    upright = angles[np.argmax(heights)]
    problem = CartPole(robot, upright)
    X, U, costs = optimise(problem, np.array([0.0, upright - np.pi, 0.0, 0.0]))
    error = np.abs(X[-1] - problem.goal).max()
    print(f"{len(costs) - 1} iterations, cost {costs[0]:.0f} to {costs[-1]:.1f}")
    print(f"upright after {STEP * STEPS:.0f} s within {error:.3f}, with at most {np.abs(U).max():.1f} N")
    if "--plot" in sys.argv:
        file = sys.argv[sys.argv.index("--plot") + 1]
        plot(file, X, U, costs)
        print(f"figures in {file}")


if __name__ == "__main__":
    main()
