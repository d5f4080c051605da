// Positions as sliders show them, one per element of joint arrays: the elements of q, except that a spherical joint has
// a rotation vector (rad, in axes of the child). In q, that joint has a unit quaternion w, x, y, z.

// A spherical joint is three consecutive components with the same child. isFollower says whether this is the second or
// third of them, isFirst whether it is the first.
export const isFollower = (joints, j) =>
  j > 0 && joints[j].type === "spherical" && joints[j - 1].child === joints[j].child;
const isFirst = (joints, j) => joints[j].type === "spherical" && !isFollower(joints, j);
export const nameOf = (joint) => (joint.type === "spherical" ? joint.name.slice(0, -2) : joint.name);

// Calls `quaternion` for each spherical joint, with its first elements in q and in joint arrays, and `number` for all
// others.
export function visit(joints, quaternion, number) {
  for (let j = 0, k = 0; j < joints.length;) {
    if (isFirst(joints, j)) {
      quaternion(k, j);
      k += 4;
      j += 3;
    } else {
      number(k++, j++);
    }
  }
}

// The remaining terms of the sine quotient's series are below rounding.
const sineQuotient = (a) => (a < 1e-4 ? 1 - (a * a) / 6 : Math.sin(a) / a);

// Converts a rotation vector to a quaternion, and back to a rotation of at most half a turn.
export function quaternionOf(turn) {
  const half = Math.hypot(...turn) / 2, s = sineQuotient(half) / 2;
  return [Math.cos(half), s * turn[0], s * turn[1], s * turn[2]];
}

export function turnOf([w, x, y, z]) {
  const sine = Math.hypot(x, y, z);
  const factor = (w < 0 ? -2 : 2) * (sine > 0 ? Math.atan2(sine, Math.abs(w)) / sine : 1);
  return [factor * x, factor * y, factor * z];
}

export function elementsOf(joints, coordinates) {
  const q = [];
  visit(
    joints,
    (k, j) => q.push(...quaternionOf(coordinates.slice(j, j + 3))),
    (k, j) => q.push(coordinates[j]));
  return q;
}

export function coordinatesOf(joints, q) {
  const coordinates = [];
  visit(
    joints,
    (k) => coordinates.push(...turnOf(q.slice(k, k + 4))),
    (k) => coordinates.push(q[k]));
  return coordinates;
}

// dq/dt. For a quaternion Q it is Q (0, w) / 2, where w is in axes of the child.
export function ratesOf(joints, q, qd) {
  const rates = [];
  visit(
    joints,
    (k, j) => {
      const [w, x, y, z] = q.slice(k, k + 4), [a, b, c] = qd.slice(j, j + 3).map((v) => v / 2);
      rates.push(-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a);
    },
    (k, j) => rates.push(qd[j]));
  return rates;
}

// Returns q with quaternions of unit length.
export function normalised(joints, q) {
  const result = [...q];
  visit(
    joints,
    (k) => {
      const norm = Math.hypot(...q.slice(k, k + 4));
      for (let i = k; i < k + 4; ++i) result[i] /= norm;
    },
    () => {});
  return result;
}
