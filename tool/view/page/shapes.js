// Shapes of links: visual shapes as faces, collision shapes as outlines.
import { add, axis, dot, length, place, rotate, scale, subtract } from "./vectors.js";

const kAround = 24;  // corners of a circle

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// A body of revolution about z, from circles [radius, height] upwards.
function revolved(circles) {
  const points = [], faces = [];
  circles.forEach(([radius, height], i) => {
    for (let k = 0; k < kAround; ++k) {
      const angle = (2 * Math.PI * k) / kAround, next = (k + 1) % kAround, low = (i - 1) * kAround, high = i * kAround;
      points.push([radius * Math.cos(angle), radius * Math.sin(angle), height]);
      if (i > 0) faces.push([low + k, low + next, high + next], [low + k, high + next, high + k]);
    }
  });
  return { points, faces };
}

function capsule(radius, span) {
  const circles = [], kSteps = kAround / 4;
  for (const side of [-1, 1]) {
    for (let k = 0; k <= kSteps; ++k) {
      const angle = ((side < 0 ? k - kSteps : k) * Math.PI) / 2 / kSteps;
      const isPole = k === (side < 0 ? 0 : kSteps);
      circles.push([isPole ? 0 : radius * Math.cos(angle), (side * span) / 2 + radius * Math.sin(angle)]);
    }
  }
  return revolved(circles);
}

function box(size) {
  const points = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => size.map((s, k) => (((i >> k) & 1) - 0.5) * s));
  const faces = [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
                 [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]];
  return { points, faces };
}

function numbersOf(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)), numbers = [];
  for (let i = 0; i + 1 < bytes.length; i += 2) numbers.push(bytes[i] + 256 * bytes[i + 1]);
  return numbers;
}

const triples = (numbers) => Array.from({ length: numbers.length / 3 }, (_, i) => numbers.slice(3 * i, 3 * i + 3));

function meshOf({ low, step, points, faces }) {
  const at = (p) => p.map((x, k) => low[k] + step * x);
  return { points: triples(numbersOf(points)).map(at), faces: triples(numbersOf(faces)) };
}

function surfaceOf({ kind, size, mesh }, meshes) {
  if (kind === "sphere") return capsule(size[0], 0);
  if (kind === "capsule") return capsule(size[0], size[1]);
  if (kind === "cylinder") {
    const [radius, height] = [size[0], size[1] / 2];
    return revolved([[0, -height], [radius, -height], [radius, height], [0, height]]);
  }
  if (kind === "box") return box(size);
  const { points, faces } = meshes[mesh], isMirrored = size[0] * size[1] * size[2] < 0;
  const scaled = points.map((p) => p.map((x, k) => x * size[k]));
  return { points: scaled, faces: isMirrored ? faces.map(([a, b, c]) => [a, c, b]) : faces };
}

// Edges with the normals of the two faces that they join; an edge of one face has one.
function edgesOf(points, faces, normals) {
  const edges = new Map(), key = (p) => p.map((x) => Math.round(x * 1e6) + 0).join();  // one zero instead of two
  const names = points.map(key);
  faces.forEach((face, f) => {
    face.forEach((a, k) => {
      const b = face[(k + 1) % 3], name = [names[a], names[b]].sort().join(" ");
      if (names[a] === names[b]) return;
      if (!edges.has(name)) edges.set(name, { a: points[a], b: points[b], normals: [] });
      edges.get(name).normals.push(normals[f]);
    });
  });
  const kSharp = Math.cos(0.6);  // of an angle that outlines show from every side
  return [...edges.values()].map((edge) => ({
    ...edge, isSharp: edge.normals.length !== 2 || dot(edge.normals[0], edge.normals[1]) < kSharp,
  }));
}

// The shapes of the page's data, in the frames of their links.
export function makeShapes({ shapes = [], meshes = [] }) {
  const decoded = meshes.map(meshOf);
  return shapes.map((shape) => {
    const surface = surfaceOf(shape, decoded);
    const points = surface.points.map((p) => place(shape.pose, p));
    const unit = (v) => scale(1 / (length(v) || 1), v);
    const normalOf = ([a, b, c]) => cross(subtract(points[b], points[a]), subtract(points[c], points[a]));
    const faces = surface.faces.filter((face) => length(normalOf(face)) > 0);
    const normals = faces.map((face) => unit(normalOf(face)));
    const edges = shape.isVisual ? [] : edgesOf(points, faces, normals);
    return { ...shape, points, faces, normals, edges };
  });
}

// Paints the visual shapes, far triangles first. Returns them, near ones last, with their links, for clicks.
export function paintVisuals(context, view, posture, shapes, colourOf) {
  const triangles = [];
  const light = add(view.towards, scale(-0.6, view.down));
  const bright = 1 / length(light);
  for (const { link, points, faces, normals, isVisual } of shapes) {
    if (!isVisual) continue;
    const pose = posture.poses[link], seen = points.map((p) => view.see(place(pose, p)));
    faces.forEach(([a, b, c], f) => {
      const corners = [seen[a], seen[b], seen[c]];
      const shade = Math.abs(dot(rotate(pose, normals[f]), light)) * bright;
      triangles.push({ link, corners, near: corners[0].near + corners[1].near + corners[2].near, shade });
    });
  }
  triangles.sort((x, y) => x.near - y.near);
  context.lineJoin = "round";
  context.lineWidth = 0.7;  // closes the gaps between neighbours
  for (const { link, corners: [a, b, c], shade } of triangles) {
    context.fillStyle = context.strokeStyle = colourOf(link, shade);
    context.beginPath();
    context.moveTo(a.x, a.y);
    context.lineTo(b.x, b.y);
    context.lineTo(c.x, c.y);
    context.closePath();
    context.fill();
    context.stroke();
  }
  return triangles;
}

// Paints the sharp edges of collision shapes, and those between faces that are turned to the viewer and away from it.
export function paintCollisions(context, view, posture, shapes, colourOf) {
  context.lineWidth = 1.1;
  for (const { link, edges, isVisual } of shapes) {
    if (isVisual) continue;
    const pose = posture.poses[link];
    const towards = [0, 1, 2].map((k) => dot(view.towards, axis(pose, k)));
    context.strokeStyle = colourOf(link);
    context.beginPath();
    for (const { a, b, normals, isSharp } of edges) {
      if (!isSharp && dot(normals[0], towards) > 0 === dot(normals[1], towards) > 0) continue;
      const from = view.see(place(pose, a)), to = view.see(place(pose, b));
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
    }
    context.stroke();
  }
}

// The link of the nearest of these triangles at the point, or -1.
export function linkOfTriangle(triangles, x, y) {
  const side = (p, q) => (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
  for (let i = triangles.length; i-- > 0;) {
    const [a, b, c] = triangles[i].corners, sides = [side(a, b), side(b, c), side(c, a)];
    if (sides.every((s) => s >= 0) || sides.every((s) => s <= 0)) return triangles[i].link;
  }
  return -1;
}

// Corners of the visual shapes of a page in the base, for the size of the picture.
export function cornersOf(shapes, posture) {
  return shapes.flatMap(({ link, points }) => {
    const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
    return [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
      place(posture.poses[link], low.map((x, k) => ((i >> k) & 1 ? high[k] : x))));
  });
}
