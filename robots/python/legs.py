"""A hexapod walks in Python: the positions of all joints over a step from the paths of its feet, in closed form. Run it with
the package robcogen on PYTHONPATH; with matplotlib and the argument --plot FILE it draws the positions of a leg.
"""
import sys
from pathlib import Path

import numpy as np

import robcogen

MODEL = Path(__file__).resolve().parent.parent / "hexapod" / "hexapod.kindsl"
TRIPODS = ("LF", "RM", "LH"), ("RF", "LM", "RH")  # legs that swing together
STRIDE, LIFT = 0.06, 0.03  # m


def standing():
    """Positions of yaw, lift and knee of all legs."""
    return np.tile([0.0, -0.5, 1.4], 6)


def foot_path(phase):
    """What is added to the position of a foot at a phase in [0, 1): back on the ground, then forward in the air."""
    swing = np.clip(2 * phase - 1, 0, 1)
    along = np.where(phase < 0.5, 0.5 - 2 * phase, swing - np.sin(2 * np.pi * swing) / (2 * np.pi) - 0.5)
    return np.stack([STRIDE * along, 0 * phase, LIFT * np.sin(np.pi * swing) ** 2], axis=-1)


def walk(robot, instants=200):
    """Positions of all joints over a step, and the largest error of a foot. Each leg takes one call for all instants."""
    start = standing()
    q = np.tile(start, (instants, 1))
    time = np.arange(instants) / instants
    ik, transforms = robot.inverse_kinematics, robot.transforms.homogeneous
    error = 0.0
    for half, legs in enumerate(TRIPODS):
        for leg in legs:
            name = f"fr_body_X_{leg}_foot"
            feet = getattr(transforms, name)(start)[:3, 3] + foot_path((time + half / 2) % 1)
            signs = getattr(ik.configuration, name)(start)  # the knee stays bent to the same side
            solved = getattr(ik.branch, name)(feet, signs, q)
            q = solved.q
            reached = getattr(transforms, name)(q)[:, :3, 3]
            error = max(error, np.abs(reached - feet).max(), solved.misfit.max())
    return q, error


def plot(file, q):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    axes.plot(np.arange(len(q)) / len(q), q[:, :3], label=["yaw", "lift", "knee"])
    axes.set(xlabel="phase of the step", ylabel="positions of the left front leg (rad)")
    axes.legend()
    figure.savefig(file)


def main():
    legs = [leg for tripod in TRIPODS for leg in tripod]
    options = ["--inverse-kinematics", ",".join(f"fr_body:{leg}_foot:point" for leg in legs)]
    robot = robcogen.load(MODEL, name="hexapod", algorithms=["transforms", "inverse_kinematics"], options=options)
    q, error = walk(robot)
    jump = np.abs(np.diff(np.vstack([q, q[:1]]), axis=0)).max()
    print(f"{len(q)} postures of a step: joints move by {np.ptp(q, axis=0).max():.2f} rad, at most {jump:.3f} rad at once")
    print(f"the feet are where they should be within {error:.0e} m")
    if "--plot" in sys.argv:
        file = sys.argv[sys.argv.index("--plot") + 1]
        plot(file, q)
        print(f"figures in {file}")


if __name__ == "__main__":
    main()
