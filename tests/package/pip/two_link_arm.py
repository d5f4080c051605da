"""Loads a planar arm of two links with the installed package, and compares it with the equations of a textbook in NumPy: H(q),
gravity and Coriolis forces of Spong, Hutchinson, Vidyasagar, Robot Modeling and Control, section 6.4."""
import sys
import tempfile
from pathlib import Path

import numpy as np

import robcogen

LENGTH, CENTRES, MASSES, INERTIAS, GRAVITY = 0.7, (0.3, 0.25), (3.0, 2.0), (0.11, 0.05), 9.81


def link(name, centre, mass, inertia):
    return (
        f'<link name="{name}"><inertial><origin xyz="{centre} 0 0"/><mass value="{mass}"/>'
        f'<inertia ixx="{inertia / 2}" iyy="{inertia / 2}" izz="{inertia}" ixy="0" ixz="0" iyz="0"/></inertial></link>')


def joint(name, parent, child, x, rpy):
    return (
        f'<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{child}"/><origin xyz="{x} 0 0" rpy="{rpy}"/>'
        '<axis xyz="0 0 1"/></joint>')


def textbook(q, qd):
    (l, (r1, r2), (m1, m2), (i1, i2)) = LENGTH, CENTRES, MASSES, INERTIAS
    cross = m2 * l * r2
    h22 = m2 * r2**2 + i2
    h12 = h22 + cross * np.cos(q[1])
    h11 = m1 * r1**2 + i1 + m2 * l**2 + h22 + 2 * cross * np.cos(q[1])
    coriolis = cross * np.sin(q[1]) * np.array([-(2 * qd[0] + qd[1]) * qd[1], qd[0] ** 2])
    far = m2 * r2 * np.cos(q[0] + q[1])
    gravity = GRAVITY * np.array([(m1 * r1 + m2 * l) * np.cos(q[0]) + far, far])
    return np.array([[h11, h12], [h12, h22]]), coriolis + gravity


with tempfile.TemporaryDirectory() as folder:
    model = Path(folder, "arm.urdf")
    # The plane of the arm is vertical: its joints turn about a horizontal axis, with the first position measured from the horizon.
    model.write_text(
        '<robot name="arm"><link name="base"/>' + link("upper", CENTRES[0], MASSES[0], INERTIAS[0]) +
        link("lower", CENTRES[1], MASSES[1], INERTIAS[1]) + joint("shoulder", "base", "upper", 0, "1.5707963267948966 0 0") +
        joint("elbow", "upper", "lower", LENGTH, "0 0 0") + "</robot>")
    arm = robcogen.load(model, snap_angles=True, quiet=True, algorithms=["joint_space_inertia", "bias_forces"])
random = np.random.default_rng(7)
for _ in range(100):
    q, qd = random.uniform(-3, 3, (2, 2))
    H, bias = textbook(q, qd)
    np.testing.assert_allclose(arm.joint_space_inertia(q), H, rtol=1e-13)
    np.testing.assert_allclose(arm.bias_forces(q, qd), bias, rtol=1e-12, atol=1e-12)
print("compared with the textbook by", sys.prefix)
