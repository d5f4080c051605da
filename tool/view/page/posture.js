// The robot in a position. Everything here is computed by functions that the generator printed.
import { coordinatesOf, elementsOf, isFollower, normalised, ratesOf, visit } from "./positions.js";
import { makeShapes } from "./shapes.js";
import { add, axis, dot, origin, place, principal, rotate, scale } from "./vectors.js";

// The constant parts of the robot: `robot` is the generated module, `data` what the generator adds.
export function makeRobot(robot, data) {
  const { model } = robot;
  const joints = [...model.joints, ...model.coupled_joints];
  const children = model.links.map(() => []);
  joints.forEach((joint, j) => {
    if (!isFollower(joints, j)) children[joint.parent].push(j);
  });
  const jointFrames = joints.map(() => -1);
  data.frames.forEach((frame, f) => {
    if (frame.kind === "joint") jointFrames[frame.index] = f;
  });
  joints.forEach((_, j) => {
    if (isFollower(joints, j)) jointFrames[j] = jointFrames[j - 1];
  });
  return { module: robot, model, data, joints, children, jointFrames, dof: model.dof, shapes: makeShapes(data) };
}

// The robot at rest. `coordinates` are what the sliders show (positions.js); q follows from them.
export function makeState(robot, q, parameters) {
  const coordinates = coordinatesOf(robot.model.joints, q);
  return { q: [...q], coordinates, qd: coordinates.map(() => 0), parameters: { ...parameters } };
}

// If the loops cannot be closed at this value, the coordinate stops at the last value towards it where they can.
export function setCoordinate(robot, state, j, value) {
  const kReach = 0.02;  // rad or m: Newton's method converges after such a step
  const before = state.coordinates[j];
  const kSteps = robot.module.close_loops ? Math.max(1, Math.ceil(Math.abs(value - before) / kReach)) : 1;
  for (let step = 1; step <= kSteps; ++step) {
    const last = state.coordinates[j];
    state.coordinates[j] = step < kSteps ? before + ((value - before) * step) / kSteps : value;
    const moved = elementsOf(robot.model.joints, state.coordinates);
    const q = closed(robot, state, [...moved, ...state.q.slice(moved.length)]);
    if (robot.module.close_loops && !q.every(Number.isFinite)) {
      state.coordinates[j] = last;
      break;
    }
    state.q = q;
  }
  state.qd.fill(0);
}

// Completes q by the elements of joints that follow through loops.
function closed(robot, state, q) {
  return robot.module.close_loops ? robot.module.close_loops(...argumentsOf(robot, { ...state, q })) : q;
}

// The links with their mass properties, from the document or for the current parameters.
function linksOf(robot, parameters) {
  const { links } = robot.model;
  if (!robot.module.numbers) return links;
  const rows = robot.module.numbers(parameters).links;
  return links.map((link, l) => ({
    ...link,
    mass: rows[0][l],
    com: [1, 2, 3].map((r) => rows[r][l]),
    moments: [4, 5, 6].map((r) => rows[r][l]),
    products: [7, 8, 9].map((r) => rows[r][l]),
  }));
}

// The semi-axes of the ellipsoid of uniform density that has this mass and these principal moments.
function semiAxes(mass, moments) {
  const sum = moments[0] + moments[1] + moments[2];
  return moments.map((moment) => Math.sqrt(Math.max(0, (2.5 / mass) * (sum - 2 * moment))));
}

const principalsOfLinks = new WeakMap();

// Principal moments and axes about the centre of mass, in the frame of the link, in which they are constant.
function principalsOf(link) {
  const known = principalsOfLinks.get(link);
  if (known) return known;
  const { mass, com, moments, products } = link;
  const about = dot(com, com);
  const off = (a, b, product) => mass * com[a] * com[b] - product;
  const inertia = [
    [moments[0] - mass * (about - com[0] ** 2), off(0, 1, products[0]), off(0, 2, products[1])],
    [off(0, 1, products[0]), moments[1] - mass * (about - com[1] ** 2), off(1, 2, products[2])],
    [off(0, 2, products[1]), off(1, 2, products[2]), moments[2] - mass * (about - com[2] ** 2)],
  ];
  const principals = principal(inertia);
  principalsOfLinks.set(link, principals);
  return principals;
}

function massOf(link, pose) {
  const { mass, com } = link;
  if (!(mass > 0)) return null;
  const principals = principalsOf(link);
  const semi = semiAxes(mass, principals.map((p) => p.value));
  return {
    mass,
    com,
    centre: place(pose, com),
    moments: principals.map((p) => p.value),
    semi,
    axes: principals.map((p, k) => scale(semi[k], rotate(pose, p.vector))),
  };
}

// The mass and centre of mass of each link with all that it carries; for the base, those of the whole robot.
function carried(robot, masses) {
  const result = masses.map((m) => ({ mass: m ? m.mass : 0, moment: m ? scale(m.mass, m.centre) : [0, 0, 0] }));
  const visit = (l) => {
    for (const j of robot.children[l]) {
      const { child } = robot.joints[j];
      visit(child);
      result[l].mass += result[child].mass;
      result[l].moment = add(result[l].moment, result[child].moment);
    }
  };
  visit(0);
  return result.map(({ mass, moment }) => ({ mass, centre: mass > 0 ? scale(1 / mass, moment) : null }));
}

const argumentsOf = (robot, state) => (robot.module.parameters ? [state.parameters, state.q] : [state.q]);

// The coordinates of all joints, including those that follow others.
function positions(robot, state) {
  const count = robot.model.coupled_joints.length;
  if (count === 0) return [...state.coordinates];
  return [...state.coordinates, ...robot.module.joint_positions(...argumentsOf(robot, state)).slice(-count)];
}

// The poses of all frames in the base, the masses, and the forces of gravity.
export function postureOf(robot, state) {
  const { module, data } = robot;
  const given = argumentsOf(robot, state);
  const rows = module.frame_poses(...given), last = [0, 0, 0, 1];
  const poses = data.frames.map((_, f) => [...[0, 1, 2].map((r) => [0, 3, 6, 9].map((c) => rows[c + r][f])), last]);
  const masses = linksOf(robot, state.parameters).map((link, l) => massOf(link, poses[l]));
  return {
    poses,
    masses,
    carried: carried(robot, masses),
    positions: positions(robot, state),
    gravity: module.gravity_forces ? module.gravity_forces(...given) : null,
  };
}

export const jointAxis = (robot, posture, j) => axis(posture.poses[robot.joints[j].child], 2);
export const jointOrigin = (robot, posture, j) => origin(posture.poses[robot.jointFrames[j]]);

export const canSwing = (robot) => Boolean(robot.module.forward_dynamics) && robot.dof > 0;

// Advances the state by this many seconds without joint forces, by the Runge-Kutta method of fourth order. Joints stop
// at their limits. Returns false if the motion is too fast for the steps.
export function swing(robot, state, seconds) {
  const { joints } = robot.model, none = new Array(robot.dof).fill(0), h = seconds;
  const accelerate = (q, qd) =>
    robot.module.forward_dynamics(
      ...argumentsOf(robot, { ...state, q: closed(robot, state, normalised(joints, q)) }), qd, none);
  // Elements without a rate follow from the others.
  const ahead = (a, step, b) => a.map((value, k) => value + step * (b[k] ?? 0));
  const mean = (a, b, c, d) => a.map((value, k) => (value + 2 * b[k] + 2 * c[k] + d[k]) / 6);
  const { q, qd } = state;
  const r1 = ratesOf(joints, q, qd), k1 = accelerate(q, qd);
  const q2 = ahead(q, h / 2, r1), v2 = ahead(qd, h / 2, k1), r2 = ratesOf(joints, q2, v2), k2 = accelerate(q2, v2);
  const q3 = ahead(q, h / 2, r2), v3 = ahead(qd, h / 2, k2), r3 = ratesOf(joints, q3, v3), k3 = accelerate(q3, v3);
  const q4 = ahead(q, h, r3), v4 = ahead(qd, h, k3), r4 = ratesOf(joints, q4, v4), k4 = accelerate(q4, v4);
  state.q = closed(robot, state, normalised(joints, ahead(q, h, mean(r1, r2, r3, r4))));
  state.qd = ahead(qd, h, mean(k1, k2, k3, k4));
  visit(joints, () => {}, (k, j) => {
    const { lower, upper } = robot.joints[j];
    const stop = state.q[k] < lower ? lower : state.q[k] > upper ? upper : null;
    if (stop !== null) {
      state.q[k] = stop;
      state.qd[j] = 0;
    }
  });
  state.coordinates = coordinatesOf(joints, state.q);
  return state.q.every(Number.isFinite) && state.qd.every((v) => Math.abs(v) < 1e3);
}
