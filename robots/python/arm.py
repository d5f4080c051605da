"""A seven-joint arm in Python: gravity torques over a workspace, a step under computed torque, identification from noisy
measurements, all postures with which it reaches a pose. Run it with the package robcogen on PYTHONPATH; with matplotlib and the
argument --plot FILE it draws figures.
"""
import sys
from pathlib import Path

import numpy as np

import robcogen

MODEL = Path(__file__).resolve().parent.parent / "iiwa14" / "iiwa14.kindsl"


def gravity_map(arm, points=61):
    """The gravity torque of the second joint over the positions of the second and the fourth, in one call."""
    second, fourth = np.meshgrid(np.linspace(-2, 2, points), np.linspace(-2, 2, points), indexing="ij")
    q = np.zeros((points * points, arm.dof))
    q[:, 1], q[:, 3] = second.ravel(), fourth.ravel()
    return second, fourth, arm.gravity_forces(q)[:, 1].reshape(points, points)


def step_response(arm, goal, duration=2.0, dt=1e-3, frequency=8.0):
    """Positions over time under computed torque: an error decays as that of a critically damped oscillator."""
    q, qd = np.zeros(arm.dof), np.zeros(arm.dof)
    positions = []
    for _ in range(round(duration / dt)):
        wanted = frequency**2 * (goal - q) - 2 * frequency * qd
        tau = arm.inverse_dynamics(q, qd, wanted)
        qd = qd + dt * arm.forward_dynamics(q, qd, tau)
        q = q + dt * qd
        positions.append(q)
    return np.array(positions)


def identify(arm, states=2000, noise=0.5, seed=1):
    """Base parameters from measured torques with noise (N m), by least squares, and what they predict elsewhere."""
    dice = np.random.default_rng(seed)
    q, qd, qdd = (dice.uniform(-2, 2, (states, arm.dof)) for _ in range(3))
    measured = arm.inverse_dynamics(q, qd, qdd) + dice.normal(0, noise, (states, arm.dof))
    regressor = arm.base_regressor(q, qd, qdd)
    parameters, *_ = np.linalg.lstsq(regressor.reshape(-1, regressor.shape[-1]), measured.ravel(), rcond=None)
    q, qd, qdd = (dice.uniform(-2, 2, (200, arm.dof)) for _ in range(3))
    error = arm.base_regressor(q, qd, qdd) @ parameters - arm.inverse_dynamics(q, qd, qdd)
    return parameters, np.sqrt(np.mean(error**2))


def postures(arm, q, turns=13):
    """All positions with the pose of the hand at q: of each swivel angle the branches that exist, and their pose errors."""
    X = arm.transforms.homogeneous.fr_base_X_fr_ee(q)
    found = []
    for swivel in np.linspace(-np.pi, np.pi, turns, endpoint=False):
        branches = arm.inverse_kinematics.fr_base_X_fr_ee(X, [swivel], q)
        angles = np.arctan2(branches.sin_q, branches.cos_q)
        found += [column for column, misfit in zip(angles.T, branches.misfit) if misfit < 1e-9]
    poses = arm.transforms.homogeneous.fr_base_X_fr_ee(np.array(found))
    return np.array(found), np.abs(poses - X).max()


def plot(file, second, fourth, torques, positions):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    figure.colorbar(left.contourf(second, fourth, torques, 24), ax=left, label="gravity torque of joint 2 (N m)")
    left.set(xlabel="joint 2 (rad)", ylabel="joint 4 (rad)")
    right.plot(np.arange(len(positions)) * 1e-3, positions)
    right.set(xlabel="time (s)", ylabel="positions (rad)")
    figure.savefig(file)


def main():
    groups = ["inverse_dynamics", "bias_forces", "forward_dynamics", "base_regressor", "transforms", "inverse_kinematics"]
    arm = robcogen.load(
        MODEL, name="arm", algorithms=groups, options=["--inverse-kinematics", "fr_base:fr_ee:swivel"])
    second, fourth, torques = gravity_map(arm)
    print(f"gravity torque of joint 2: at most {np.abs(torques).max():.1f} N m")
    goal = np.array([0.5, 0.6, -0.4, -1.2, 0.3, 0.8, 0.1])
    positions = step_response(arm, goal)
    print(f"distance to the goal after 2 s: {np.abs(positions[-1] - goal).max():.1e} rad")
    parameters, error = identify(arm)
    print(f"{len(parameters)} base parameters predict torques within {error:.3f} N m of the model, from noise of 0.5 N m")
    reached, error = postures(arm, goal)
    print(f"{len(reached)} postures have the pose of the goal within {error:.0e}")
    if "--plot" in sys.argv:
        file = sys.argv[sys.argv.index("--plot") + 1]
        plot(file, second, fourth, torques, positions)
        print(f"figures in {file}")


if __name__ == "__main__":
    main()
