// The picture: the robot, drawn on a canvas.
import { isFollower, nameOf } from "./positions.js";
import { jointAxis, jointOrigin } from "./posture.js";
import { cornersOf, paintCollisions, paintVisuals } from "./shapes.js";
import { add, axis, dot, length, origin, place, scale, subtract } from "./vectors.js";

// Sizes in metres that suit the robot.
export function sizesOf(robot, posture) {
  const base = origin(posture.poses[0]);
  const points = [...posture.poses.map(origin), ...cornersOf(robot.shapes, posture)];
  const radius = Math.max(1e-3, ...points.map((p) => length(subtract(p, base)))) || 1;
  const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
  const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
  const centre = scale(0.5, add(low, high));
  const around = Math.max(0.25 * radius, ...points.map((p) => length(subtract(p, centre))));
  const bars = robot.joints
    .map((joint, j) => length(subtract(jointOrigin(robot, posture, j), origin(posture.poses[joint.parent]))))
    .filter((l) => l > 1e-6)
    .sort((a, b) => a - b);
  const typical = bars.length ? bars[Math.floor(bars.length / 2)] : radius;
  const bar = Math.min(0.05 * around, 0.3 * typical);
  return { centre, around, bar, ground: Math.min(0, low[2]) };
}

// Whether a user's frame is where the joint of its link is, as those of URDF's links are.
export function isOfJoint(robot, posture, f) {
  const { link } = robot.data.frames[f];
  return link > 0 && length(subtract(origin(posture.poses[f]), origin(posture.poses[link]))) < 1e-9;
}

const isShown = (robot, posture, f, show) =>
  robot.data.frames[f].kind === "user" && (isOfJoint(robot, posture, f) ? show.frames : show.fixed);

// The ends of bars: a link reaches from its origin to the joints that it carries; a link that carries none reaches to
// its frames, or otherwise to its centre of mass.
function barsOf(robot, posture) {
  const bars = [];
  robot.model.links.forEach((_, l) => {
    const from = origin(posture.poses[l]);
    const ends = robot.children[l].map((j) => jointOrigin(robot, posture, j));
    if (ends.length === 0) {
      robot.data.frames.forEach((frame, f) => {
        if (frame.kind === "user" && frame.link === l) ends.push(origin(posture.poses[f]));
      });
      if (ends.length === 0 && posture.masses[l]) ends.push(posture.masses[l].centre);
    }
    for (const to of ends) if (length(subtract(to, from)) > 1e-9) bars.push({ link: l, from, to });
  });
  return bars;
}

const family = (theme, name) => ({ main: theme[name], light: theme[`${name}-light`], edge: theme[`${name}-edge`] });

function paintBar(context, view, { from, to }, width, colours) {
  const a = view.see(from), b = view.see(to);
  const pixels = Math.max(2, width * view.scaleAt((a.near + b.near) / 2));
  const line = (colour, size, dx, dy) => {
    context.strokeStyle = colour;
    context.lineWidth = size;
    context.beginPath();
    context.moveTo(a.x + dx, a.y + dy);
    context.lineTo(b.x + dx, b.y + dy);
    context.stroke();
  };
  context.lineCap = "round";
  line(colours.edge, pixels + 1.6, 0, 0);
  line(colours.main, pixels, 0, 0);
  const across = Math.hypot(b.x - a.x, b.y - a.y) || 1;
  const side = (0.2 * pixels) / across, up = b.x >= a.x ? 1 : -1;
  line(colours.light, 0.3 * pixels, up * side * (b.y - a.y), -up * side * (b.x - a.x));
}

// A link that carries several joints, such as a torso, is their convex hull together with its own origin. Its outline is that
// of the points on the canvas.
function paintBody(context, view, points, width, colours) {
  const seen = points.map(view.see), near = seen.reduce((sum, p) => sum + p.near, 0) / seen.length;
  const pixels = Math.max(2, width * view.scaleAt(near));
  context.lineJoin = "round";
  const shape = (colour, size) => {
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = size;
    context.beginPath();
    for (const p of hull(seen)) context.lineTo(p.x, p.y);
    context.closePath();
    context.stroke();
    context.fill();
  };
  shape(colours.edge, pixels + 1.6);
  shape(colours.main, pixels);
  shape(colours.light, 0.3 * pixels);
  shape(colours.main, 0.3 * pixels - 2);
}

// The convex hull of points of the plane, around (Andrew 1979).
function hull(points) {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const turn = (a, b, c) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const half = (list) => {
    const chain = [];
    for (const p of list) {
      while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), p) <= 0) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

// A cylinder about a unit vector.
function paintCylinder(context, view, centre, direction, half, radius, colours) {
  const towards = dot(direction, view.towards) >= 0 ? 1 : -1;
  const near = view.see(add(centre, scale(towards * half, direction)));
  const far = view.see(add(centre, scale(-towards * half, direction)));
  const r = Math.max(2.5, radius * view.scaleAt(near.near));
  const flat = Math.abs(dot(direction, view.towards));
  const angle = Math.atan2(dot(direction, view.down), dot(direction, view.right));
  const nx = -Math.sin(angle) * r, ny = Math.cos(angle) * r;
  context.lineWidth = 1;
  context.strokeStyle = colours.edge;
  context.fillStyle = colours.main;
  context.beginPath();
  context.ellipse(far.x, far.y, Math.max(0.01, r * flat), r, angle, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.beginPath();
  context.moveTo(far.x + nx, far.y + ny);
  context.lineTo(near.x + nx, near.y + ny);
  context.lineTo(near.x - nx, near.y - ny);
  context.lineTo(far.x - nx, far.y - ny);
  context.fill();
  context.beginPath();
  context.moveTo(far.x + nx, far.y + ny);
  context.lineTo(near.x + nx, near.y + ny);
  context.moveTo(near.x - nx, near.y - ny);
  context.lineTo(far.x - nx, far.y - ny);
  context.stroke();
  context.fillStyle = colours.light;
  context.beginPath();
  context.ellipse(near.x, near.y, Math.max(0.01, r * flat), r, angle, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

function paintBall(context, view, centre, radius, colours) {
  const { x, y, near } = view.see(centre), r = Math.max(3, radius * view.scaleAt(near));
  context.lineWidth = 1;
  context.strokeStyle = colours.edge;
  context.fillStyle = colours.main;
  context.beginPath();
  context.arc(x, y, r, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillStyle = colours.light;
  context.beginPath();
  context.arc(x - 0.3 * r, y - 0.3 * r, 0.35 * r, 0, 2 * Math.PI);
  context.fill();
}

function paintArrow(context, view, from, to, colour, width) {
  const a = view.see(from), b = view.see(to);
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = width;
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(a.x, a.y);
  context.lineTo(b.x, b.y);
  context.stroke();
  const l = Math.hypot(b.x - a.x, b.y - a.y);
  if (l < 5) return;
  const ux = (b.x - a.x) / l, uy = (b.y - a.y) / l, head = Math.min(9, l / 2) * (0.6 + 0.2 * width);
  context.beginPath();
  context.moveTo(b.x + 0.4 * head * ux, b.y + 0.4 * head * uy);
  context.lineTo(b.x - head * ux - 0.4 * head * uy, b.y - head * uy + 0.4 * head * ux);
  context.lineTo(b.x - head * ux + 0.4 * head * uy, b.y - head * uy - 0.4 * head * ux);
  context.fill();
}

function paintTriad(context, view, pose, size, width, theme) {
  ["x", "y", "z"]
    .map((name, k) => ({ name, tip: add(origin(pose), scale(size, axis(pose, k))) }))
    .sort((a, b) => view.see(a.tip).near - view.see(b.tip).near)
    .forEach(({ name, tip }) => paintArrow(context, view, origin(pose), tip, theme[name], width));
}

function paintCentre(context, view, point, radius, theme) {
  const { x, y } = view.see(point);
  context.lineWidth = 1.4;
  context.strokeStyle = theme.mass;
  context.fillStyle = theme.paper;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.fillStyle = theme.mass;
  for (const start of [-Math.PI / 2, Math.PI / 2]) {
    context.beginPath();
    context.moveTo(x, y);
    context.arc(x, y, radius, start, start + Math.PI / 2);
    context.fill();
  }
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
}

// The outline of an ellipsoid is an ellipse; its principal sections are drawn fainter.
function paintEllipsoid(context, view, { centre, axes }, colour) {
  const c = view.see(centre), s = view.scaleAt(c.near);
  const flat = axes.map((a) => [s * dot(a, view.right), s * dot(a, view.down)]);
  const xx = flat.reduce((sum, p) => sum + p[0] * p[0], 0), yy = flat.reduce((sum, p) => sum + p[1] * p[1], 0);
  const xy = flat.reduce((sum, p) => sum + p[0] * p[1], 0);
  const middle = (xx + yy) / 2, spread = Math.hypot((xx - yy) / 2, xy);
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = 1.2;
  context.beginPath();
  context.ellipse(
    c.x, c.y, Math.sqrt(middle + spread), Math.sqrt(Math.max(0, middle - spread)), Math.atan2(2 * xy, xx - yy) / 2, 0,
    2 * Math.PI);
  context.globalAlpha = 0.14;
  context.fill();
  context.globalAlpha = 0.75;
  context.stroke();
  context.globalAlpha = 0.35;
  for (const [a, b] of [[0, 1], [0, 2], [1, 2]]) {
    context.beginPath();
    for (let k = 0; k <= 40; ++k) {
      const t = (k * Math.PI) / 20, u = Math.cos(t), v = Math.sin(t);
      context.lineTo(c.x + u * flat[a][0] + v * flat[b][0], c.y + u * flat[a][1] + v * flat[b][1]);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}

function paintGround(context, view, sizes, theme) {
  const decade = 10 ** Math.floor(Math.log10(sizes.around));
  const step = decade * (sizes.around / decade > 3 ? 0.5 : 0.25);
  const count = Math.ceil((1.6 * sizes.around) / step);
  const x = Math.round(sizes.centre[0] / step) * step, y = Math.round(sizes.centre[1] / step) * step;
  context.strokeStyle = theme.grid;
  context.lineWidth = 1;
  context.beginPath();
  for (let k = -count; k <= count; ++k) {
    for (const [from, to] of [
      [[x + k * step, y - count * step], [x + k * step, y + count * step]],
      [[x - count * step, y + k * step], [x + count * step, y + k * step]],
    ]) {
      const a = view.see([...from, sizes.ground]), b = view.see([...to, sizes.ground]);
      context.moveTo(a.x, a.y);
      context.lineTo(b.x, b.y);
    }
  }
  context.stroke();
}

function paintBase(context, view, pose, size, ground, theme) {
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => place(pose, [x * size, y * size, 0]));
  const shape = (points) => {
    context.beginPath();
    for (const p of points.map(view.see)) context.lineTo(p.x, p.y);
    context.closePath();
  };
  // The footprint of the base, if it stands above the ground.
  context.fillStyle = context.strokeStyle = theme.soft;
  context.lineWidth = 1;
  shape(corners.map((p) => [p[0], p[1], ground]));
  context.globalAlpha = 0.18;
  context.fill();
  shape(corners);
  context.globalAlpha = 0.45;
  context.fill();
  context.globalAlpha = 1;
  context.stroke();
}

// Paints names near their points if there is room; where points are crowded, only the first names. The name of a frame gives
// way to other names at its point.
function paintNames(context, view, names, size, theme) {
  const taken = [], places = [], known = new Set();
  context.font = "12px system-ui, sans-serif";
  context.lineJoin = "round";
  for (const { at, text, strong, isFrame } of names) {
    if (known.has(text)) continue;
    known.add(text);
    const { x, y } = view.see(at);
    if (isFrame && places.some((p) => Math.hypot(p.x - x, p.y - y) < 8)) continue;
    const width = context.measureText(text).width;
    const left = -9 - width, middle = -width / 2;
    for (const [dx, dy] of [[9, -5], [9, 15], [left, -5], [left, 15], [middle, -16], [middle, 26]]) {
      const box = { left: x + dx - 2, right: x + dx + width + 2, top: y + dy - 12, bottom: y + dy + 4 };
      const outside = box.left < 0 || box.top < 0 || box.right > size.width || box.bottom > size.height - 30;
      const meets = (o) => box.left < o.right && o.left < box.right && box.top < o.bottom && o.top < box.bottom;
      if (outside || taken.some(meets)) continue;
      taken.push(box);
      places.push({ x, y });
      context.strokeStyle = theme.paper;
      context.lineWidth = 3;
      context.strokeText(text, x + dx, y + dy);
      context.fillStyle = strong ? theme.accent : theme.ink;
      context.fillText(text, x + dx, y + dy);
      break;
    }
  }
}

function namesOf(robot, posture, { show, selected }) {
  const { links } = robot.model, names = [];
  const linkName = (l) => ({ at: origin(posture.poses[l]), text: links[l].name });
  if (selected >= 0) {
    const m = posture.masses[selected];
    names.push({ at: m ? m.centre : origin(posture.poses[selected]), text: links[selected].name, strong: true });
  }
  if (!show.names) return names;
  if (selected !== 0) names.push(linkName(0));
  robot.joints.forEach((joint) => names.push({ at: origin(posture.poses[joint.child]), text: nameOf(joint) }));
  robot.data.frames.forEach((frame, f) => {
    if (isShown(robot, posture, f, show)) names.push({ at: origin(posture.poses[f]), text: frame.name, isFrame: true });
  });
  return names;
}

// The colours of a surface, from dark to light.
function shades(hue, saturation) {
  const kCount = 32;
  const list = Array.from({ length: kCount }, (_, i) => `hsl(${hue} ${saturation}% ${32 + (54 * i) / (kCount - 1)}%)`);
  return (shade) => list[Math.min(kCount - 1, Math.floor(shade * kCount))];
}
const plainShade = shades(212, 14), chosenShade = shades(212, 75);

// Draws the robot, and returns what clicks can meet: the bars with their ends on the canvas, and the triangles of
// visual shapes. The joints, axes and frames inside shapes are seen through them.
export function paint(context, size, view, robot, posture, sizes, options, theme) {
  const { show, selected } = options;
  context.clearRect(0, 0, size.width, size.height);
  paintGround(context, view, sizes, theme);
  const items = [];
  const put = (at, bias, draw) => items.push({ near: view.see(at).near + bias * sizes.around, draw });
  put(origin(posture.poses[0]), -0.02, () =>
    paintBase(context, view, posture.poses[0], 0.13 * sizes.around, sizes.ground, theme));
  const bars = barsOf(robot, posture);
  const isCovered = (l) => show.shapes && robot.shapes.some((shape) => shape.isVisual && shape.link === l);
  robot.model.links.forEach((_, l) => {
    if (isCovered(l)) return;
    const own = bars.filter((bar) => bar.link === l), colours = family(theme, l === selected ? "chosen" : "bar");
    if (own.length > 1) {
      const points = [own[0].from, ...own.map(({ to }) => to)];
      const middle = scale(1 / points.length, points.reduce(add));
      put(middle, 0, () => paintBody(context, view, points, sizes.bar, colours));
    }
    if (own.length === 1)
      put(scale(0.5, add(own[0].from, own[0].to)), 0, () => paintBar(context, view, own[0], sizes.bar, colours));
  });
  robot.joints.forEach((joint, j) => {
    if (isFollower(robot.joints, j)) return;
    if (joint.type === "spherical") {
      const centre = origin(posture.poses[joint.child]);
      put(centre, 0.01, () => paintBall(context, view, centre, 1.15 * sizes.bar, family(theme, "turn")));
      return;
    }
    const slides = joint.type === "prismatic";
    const colours = family(theme, slides ? "slide" : "turn");
    const at = origin(posture.poses[joint.child]), along = jointAxis(robot, posture, j);
    const foot = jointOrigin(robot, posture, j);
    if (slides) {
      const end = (limit, otherwise) => add(foot, scale(Number.isFinite(limit) ? limit : otherwise, along));
      const reach = 3 * sizes.bar, slid = posture.positions[j];
      const from = end(joint.lower, Math.min(0, slid) - reach), to = end(joint.upper, Math.max(0, slid) + reach);
      const rail = { from, to };
      put(scale(0.5, add(rail.from, rail.to)), 0.002, () => paintBar(context, view, rail, 0.35 * sizes.bar, colours));
    }
    const [half, radius] = (slides ? [0.9, 0.7] : [0.75, 0.85]).map((factor) => factor * sizes.bar);
    put(at, 0.01, () => paintCylinder(context, view, at, along, half, radius, colours));
    if (show.axes)
      put(at, 0.012, () => paintArrow(context, view, at, add(at, scale(3.2 * sizes.bar, along)), colours.main, 2));
  });
  // A loop is closed by a ball, or by a rod between frames that keep a distance.
  for (const { frames } of robot.data.loops) {
    const [from, to] = frames.map((f) => origin(posture.poses[f]));
    const middle = scale(0.5, add(from, to)), ends = [from, to];
    if (length(subtract(to, from)) > 1e-6 * sizes.around)
      put(middle, 0, () => paintBar(context, view, { from, to }, 0.5 * sizes.bar, family(theme, "bar")));
    for (const at of ends) put(at, 0.01, () => paintBall(context, view, at, 0.7 * sizes.bar, family(theme, "turn")));
  }
  robot.data.frames.forEach((frame, f) => {
    const pose = posture.poses[f], isBase = frame.kind === "link" && frame.index === 0;
    const isOfLink = frame.kind === "link" && (show.links || frame.index === selected);
    const [size, width] = isBase ? [0.26, 2.4] : [0.11, 1.8];
    if (isBase || isOfLink || isShown(robot, posture, f, show))
      put(origin(pose), 0.03, () => paintTriad(context, view, pose, size * sizes.around, width, theme));
  });
  posture.masses.forEach((mass, l) => {
    if (!mass) return;
    if (show.inertia || l === selected)
      put(mass.centre, 0.04, () => paintEllipsoid(context, view, mass, l === selected ? theme.accent : theme.soft));
    if (show.masses) put(mass.centre, 0.05, () => paintCentre(context, view, mass.centre, 4.5, theme));
  });
  const whole = posture.carried[0];
  if (show.masses && whole.centre) put(whole.centre, 0.06, () => paintCentre(context, view, whole.centre, 9, theme));
  const colourOf = (link, shade) => (link === selected ? chosenShade : plainShade)(shade);
  const triangles = show.shapes ? paintVisuals(context, view, posture, robot.shapes, colourOf) : [];
  items.sort((a, b) => a.near - b.near).forEach(({ draw }) => draw());
  if (show.collisions)
    paintCollisions(context, view, posture, robot.shapes, (link) => theme[link === selected ? "accent" : "collision"]);
  paintNames(context, view, namesOf(robot, posture, options), size, theme);
  return { triangles, bars: bars.map(({ link, from, to }) => ({ link, a: view.see(from), b: view.see(to) })) };
}

// The link whose bar is nearest to the point, or -1.
export function linkAt(bars, x, y) {
  let best = -1, least = 12;
  for (const { link, a, b } of bars) {
    const dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy || 1;
    const t = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / l2));
    const distance = Math.hypot(x - a.x - t * dx, y - a.y - t * dy);
    if (distance < least) [best, least] = [link, distance];
  }
  return best;
}
