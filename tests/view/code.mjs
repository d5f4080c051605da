// The code of pages without a browser: principal axes, masses, and the motion under gravity.
//
// node code.mjs TOOL FOLDER ROBOTS
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { elementsOf, quaternionOf, turnOf } from "../../tool/view/page/positions.js";
import { makeRobot, makeState, postureOf, setCoordinate, swing } from "../../tool/view/page/posture.js";
import { linkOfTriangle, makeShapes } from "../../tool/view/page/shapes.js";
import { dot, place, principal, rotate } from "../../tool/view/page/vectors.js";

const [tool, folder, robots] = process.argv.slice(2);

mkdirSync(folder, { recursive: true });

// The same numbers in every run.
let seed = 7;
const random = () => {
  seed = (1103515245 * seed + 12345) % 2147483648;
  return (2 * seed) / 2147483648 - 1;
};

// Without friction, for the energy's sake.
async function load(name) {
  const document = join(folder, `${name}.kindsl`), text = readFileSync(join(robots, name, `${name}.kindsl`), "utf8");
  writeFileSync(document, text.replaceAll(/\bdamping = \S+/g, ""));
  const words = ["generate", document, "-o", folder, "--name", name, "--language", "javascript"];
  execFileSync(tool, [...words, "--frames", "*", "--algorithms", "energy,forward_dynamics,bias_forces,transforms"], { stdio: "pipe" });
  const module = await import(pathToFileURL(join(folder, "javascript", `${name}.mjs`)).href);
  const base = module.model.frames[0].name;
  const frames = module.model.links.map((link, l) => ({ kind: "link", name: `fr_${link.name}`, index: l, link: l }));
  const poseOf = ({ name }, given) =>
    name === base
      ? [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]
      : module.transforms.homogeneous[`${base}_X_${name}`](...given);
  const frame_poses = (...given) => {
    const poses = frames.map((frame) => poseOf(frame, given));
    return Array.from({ length: 12 }, (_, k) => poses.map((pose) => pose[k % 3][Math.floor(k / 3)]));
  };
  return makeRobot({ ...module, frame_poses }, { frames, warnings: [] });
}

const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a} instead of ${b}`);

// A v = lambda v, and the vectors are orthogonal and of unit length.
for (let k = 0; k < 200; ++k) {
  const [a, b, c, d, e, f] = Array.from({ length: 6 }, random);
  const matrix = [[a, b, c], [b, d, e], [c, e, f]];
  const pairs = principal(matrix);
  pairs.forEach(({ value, vector }, i) => {
    matrix.forEach((row, r) => near(dot(row, vector), value * vector[r], 1e-13, "principal axis"));
    pairs.forEach((other, j) => near(dot(vector, other.vector), i === j ? 1 : 0, 1e-13, "orthogonal axes"));
    assert.ok(i === 0 || value >= pairs[i - 1].value, "ascending");
  });
}

// Solid ellipsoids have the moments that they are drawn for; masses add up.
{
  const robot = await load("hyl");
  const posture = postureOf(robot, makeState(robot, [0.1, 0.7, -1.2], {}));
  const moving = robot.model.links.filter((link) => link.mass > 0);
  near(posture.carried[0].mass, moving.reduce((sum, link) => sum + link.mass, 0), 1e-12, "whole mass");
  robot.model.links.forEach((link, l) => {
    const mass = posture.masses[l];
    if (!mass) return assert.equal(link.mass, 0);
    mass.moments.forEach((moment, k) => {
      const [b, c] = [0, 1, 2].filter((i) => i !== k).map((i) => mass.semi[i]);
      near((mass.mass / 5) * (b * b + c * c), moment, 1e-12, "moment of the ellipsoid");
    });
    // The sum over the axes is the inertia about the centre, and with the parallel axes that of the document.
    const back = mass.axes.map((a) => rotate(transposed(posture.poses[l]), a));
    [[0, 1], [0, 2], [1, 2]].forEach(([r, s], k) => {
      const own = (mass.mass / 5) * back.reduce((sum, a) => sum + a[r] * a[s], 0);
      near(own + mass.mass * link.com[r] * link.com[s], link.products[k], 1e-12, "product of inertia");
    });
    for (const [r, given] of link.moments.entries()) {
      const squares = back.reduce((sum, a) => sum + (dot(a, a) - a[r] * a[r]), 0);
      const parallel = mass.mass * (dot(link.com, link.com) - link.com[r] ** 2);
      near((mass.mass / 5) * squares + parallel, given, 1e-12, "moment of inertia");
    }
    place(posture.poses[l], link.com).forEach((x, k) => near(mass.centre[k], x, 0, "centre of mass"));
  });
}

function transposed(pose) {
  return [0, 1, 2].map((r) => [pose[0][r], pose[1][r], pose[2][r], 0]);
}

// Without friction the energy stays. A robot that falls freely, and a chain.
for (const name of ["hyl", "tree5", "ball_leg"]) {
  const robot = await load(name);
  robot.joints = robot.joints.map((joint) => ({ ...joint, lower: -Infinity, upper: Infinity }));
  const q = elementsOf(robot.model.joints, robot.joints.map(() => 0.4 + 0.3 * random()));
  const state = makeState(robot, q, {});
  const energy = () => robot.module.kinetic_energy(state.q, state.qd) + robot.module.potential_energy(state.q);
  const before = energy(), start = [...state.q];
  let kinetic = 0;
  for (let k = 0; k < 240; ++k) {
    assert.ok(swing(robot, state, 1 / 240));
    kinetic = Math.max(kinetic, robot.module.kinetic_energy(state.q, state.qd));
  }
  assert.ok(kinetic > 0.1, `${name} moves`);
  near(energy(), before, 1e-5 * kinetic, `energy of ${name}`);
  assert.notDeepEqual(state.q, start);
}

// Quaternions of turns and back, also of none, of nearly half a turn, and of the other sign.
for (const size of [0, 1e-9, 1e-5, 0.7, 3.14159]) {
  const axis = [random(), random(), random()], norm = Math.hypot(...axis), turn = axis.map((v) => (size * v) / norm);
  const quaternion = quaternionOf(turn);
  near(Math.hypot(...quaternion), 1, 1e-15, "unit quaternion");
  for (const sign of [1, -1])
    turnOf(quaternion.map((e) => sign * e)).forEach((v, k) => near(v, turn[k], 1e-14, "turn"));
}

// A slider of a spherical joint turns the child about its axis, and what it shows is what it was set to.
{
  const robot = await load("ball_leg"), state = makeState(robot, [1, 0, 0, 0, 0.4, 1, 0, 0, 0], {});
  const j = robot.joints.findIndex((joint) => joint.name === "ankle_y"), child = robot.joints[j].child;
  const before = postureOf(robot, state).poses[child];
  setCoordinate(robot, state, j, 2.5);
  const posture = postureOf(robot, state), after = posture.poses[child];
  assert.equal(posture.positions[j], 2.5);
  const [c, s] = [Math.cos(2.5), Math.sin(2.5)];
  [0, 1, 2].forEach((r) => {
    near(after[r][0], c * before[r][0] - s * before[r][2], 1e-14, "x axis");
    near(after[r][1], before[r][1], 1e-14, "y axis");
    near(after[r][3], before[r][3], 1e-14, "origin");
  });
}

// A joint stops at its limit.
{
  const robot = await load("hyl");
  robot.joints = robot.joints.map((joint, j) => (j === 0 ? { ...joint, lower: -0.1, upper: 0.1 } : joint));
  const state = makeState(robot, [0, 0.2, 0.3], {});
  for (let k = 0; k < 240; ++k) swing(robot, state, 1 / 240);
  assert.equal(state.q[0], -0.1);
}
console.log("the code of pages is right");

// Surfaces of shapes are closed and turned outwards: the volume inside is that of the shape, or a little less where it is
// round. A shape from all sides has only the edges that two faces have in common.
{
  const pose = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3]];
  const shape = (kind, size, more = {}) => ({ link: 0, body: "b", isVisual: false, kind, size, pose, ...more });
  // A tetrahedron: three edges of 2 m, in steps of 1/65535 of them.
  const numbers = (list) => Buffer.from(new Uint16Array(list).buffer).toString("base64");
  const points = numbers([0, 0, 0, 65535, 0, 0, 0, 65535, 0, 0, 0, 65535]);
  const faces = numbers([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
  const meshes = [{ low: [0, 0, 0], step: 2 / 65535, points, faces }];
  const given = [
    [shape("sphere", [0.5, 0, 0]), Math.PI / 6, 0],
    [shape("box", [1, 2, 3]), 6, 12],
    [shape("cylinder", [0.5, 2, 0]), Math.PI / 2, 48],
    [shape("capsule", [0.5, 2, 0]), Math.PI / 2 + Math.PI / 6, 0],
    [shape("mesh", [1, 1, 1], { mesh: 0 }), 8 / 6, 6],
    [shape("mesh", [1, 3, -1], { mesh: 0 }), 4, 6],
  ];
  const volume = ({ points, faces }) =>
    faces.reduce((sum, corners) => {
      const [p, q, r] = corners.map((c) => points[c]);
      const normal = [q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2], q[0] * r[1] - q[1] * r[0]];
      return sum + dot(p, normal) / 6;
    }, 0);
  makeShapes({ shapes: given.map(([s]) => s), meshes }).forEach((made, k) => {
    const [{ kind }, expected, sharp] = given[k];
    near(volume(made), expected, 0.03 * expected, `volume of ${kind}`);
    assert.ok(made.edges.every(({ normals }) => normals.length === 2), `${kind} is closed`);
    assert.equal(made.edges.filter(({ isSharp }) => isSharp).length, sharp, `edges of ${kind}`);
    made.normals.forEach((n) => near(dot(n, n), 1, 1e-12, "unit normal"));
  });
  // The box from (0, 1.5, 1.5) to (2, 2.5, 4.5): its axes are turned.
  const box = makeShapes({ shapes: [shape("box", [1, 2, 3])] })[0].points;
  [[0, 0, 2], [1, 1.5, 2.5], [2, 1.5, 4.5]].forEach(([k, low, high]) => {
    near(Math.min(...box.map((p) => p[k])), low, 1e-15, "lower end");
    near(Math.max(...box.map((p) => p[k])), high, 1e-15, "upper end");
  });
  const triangle = (link, x) => ({ link, corners: [{ x, y: 0 }, { x: x + 2, y: 0 }, { x, y: 2 }] });
  const near_and_far = [triangle(3, 0), triangle(5, 0.5)];
  assert.equal(linkOfTriangle(near_and_far, 0.75, 0.5), 5);
  assert.equal(linkOfTriangle(near_and_far, 0.25, 0.5), 3);
  assert.equal(linkOfTriangle(near_and_far, 3, 3), -1);
}
