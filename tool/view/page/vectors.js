// Vectors of three numbers, poses as rows of four, and symmetric matrices.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (s, a) => [s * a[0], s * a[1], s * a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);

export const origin = (pose) => [pose[0][3], pose[1][3], pose[2][3]];
export const axis = (pose, k) => [pose[0][k], pose[1][k], pose[2][k]];
export const rotate = (pose, v) => [0, 1, 2].map((r) => pose[r][0] * v[0] + pose[r][1] * v[1] + pose[r][2] * v[2]);
export const place = (pose, p) => add(origin(pose), rotate(pose, p));

// The eigenvalues, ascending, and unit eigenvectors of a symmetric 3 x 3 matrix, by Jacobi rotations.
export function principal(matrix) {
  const a = matrix.map((row) => [...row]);
  const v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 30; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (a[p][q] === 0) continue;
      const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
      const c = 1 / Math.hypot(t, 1), s = t * c;
      for (let k = 0; k < 3; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < 3; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      for (let k = 0; k < 3; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
  }
  return [0, 1, 2]
    .map((k) => ({ value: a[k][k], vector: [v[0][k], v[1][k], v[2][k]] }))
    .sort((x, y) => x.value - y.value);
}
