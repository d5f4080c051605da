// The page, which connects its state, its panels and the picture.
import { makeCamera, projection, resetCamera, steerBy } from "./camera.js";
import { element, makeJoints, makeOutline, makeParameters, makeWarnings, showLink } from "./panels.js";
import { linkAt, paint, sizesOf } from "./picture.js";
import { canSwing, makeRobot, makeState, postureOf, setCoordinate, swing } from "./posture.js";
import { linkOfTriangle } from "./shapes.js";

const byId = (id) => document.getElementById(id);
const data = JSON.parse(byId("data").textContent);
const robot = makeRobot(generated, data);
const state = makeState(robot, data.q, data.parameters);
const options = {
  selected: -1,
  show: {
    names: robot.joints.length <= 14, frames: true, fixed: false, axes: true, masses: true, inertia: false, links: false,
    shapes: true, collisions: false,
  },
};
let posture = postureOf(robot, state);
let sizes = sizesOf(robot, posture);
const camera = makeCamera(sizes.centre, sizes.around);
const canvas = byId("canvas"), context = canvas.getContext("2d");
let theme = {}, painted = { bars: [], triangles: [] }, isSwinging = false, isAsked = false;

function readTheme() {
  const style = getComputedStyle(document.documentElement);
  const names = ["paper", "ink", "soft", "accent", "x", "y", "z", "mass", "grid", "collision"];
  for (const name of ["bar", "chosen", "turn", "slide"]) names.push(name, `${name}-light`, `${name}-edge`);
  theme = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

function draw() {
  const size = { width: canvas.clientWidth, height: canvas.clientHeight }, ratio = devicePixelRatio || 1;
  if (size.width === 0 || size.height === 0) return;
  const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  painted = paint(context, size, projection(camera, size.width, size.height), robot, posture, sizes, options, theme);
}

// Drawing waits for the next animation frame, so that many changes make one picture.
function ask() {
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame((now) => {
    isAsked = false;
    if (isSwinging) advance(now);
    draw();
    if (isSwinging) ask();
  });
}

function update() {
  posture = postureOf(robot, state);
  showJoints(posture, options.selected);
  showLink(robot, posture, options.selected, byId("link"));
  ask();
}

function select(link) {
  options.selected = link === options.selected ? -1 : link;
  showOutline(options.selected);
  update();
}

const showOutline = makeOutline(robot, byId("outline"), select);
const setPosition = (j, value) => {
  setCoordinate(robot, state, j, value);
  update();
};
const reset = () => Object.assign(state, makeState(robot, data.q, state.parameters));
const showJoints = makeJoints(robot, state, sizes.around, byId("joints"), setPosition, select);
makeWarnings(robot, byId("warnings"), select);
makeParameters(state, byId("parameters"), (name, value) => {
  state.parameters[name] = value;
  update();
});

// Steps of 1/240 s, as long as they keep up with the clock; otherwise the motion is slower than real time.
const kStep = 1 / 240;
let clock = 0;
function advance(now) {
  const missing = Math.min(0.05, (now - clock) / 1000), began = performance.now();
  clock = now;
  for (let t = 0; t < missing && performance.now() - began < 11; t += kStep) {
    if (swing(robot, state, kStep)) continue;
    reset();
    setSwinging(false);
    byId("status").textContent = "The motion became too fast for the steps of this page.";
    break;
  }
  posture = postureOf(robot, state);
  showJoints(posture, options.selected);
  showLink(robot, posture, options.selected, byId("link"));
}

function setSwinging(on) {
  isSwinging = on;
  clock = performance.now();
  byId("swing").setAttribute("aria-pressed", String(on));
  byId("swing").textContent = on ? "Hold" : "Swing";
  if (!on) state.qd.fill(0);
  byId("status").textContent = "";
  ask();
}

byId("name").textContent = robot.model.name;
document.title = robot.model.name;
byId("about").textContent = data.about;
byId("swing").hidden = !canSwing(robot);
byId("swing").title = "Forward dynamics without joint forces, under gravity; the base is held";
byId("swing").addEventListener("click", () => setSwinging(!isSwinging));
byId("zero").addEventListener("click", () => {
  reset();
  update();
});
byId("view").addEventListener("click", () => {
  resetCamera(camera);
  ask();
});
const toggles = {
  names: "names",
  frames: "frames of joints",
  fixed: "other frames",
  links: "link frames",
  axes: "axes",
  masses: "centres of mass",
  inertia: "inertia",
};
if (robot.shapes.some((shape) => shape.isVisual)) toggles.shapes = "shapes";
if (robot.shapes.some((shape) => !shape.isVisual)) toggles.collisions = "collision shapes";
const boxes = {};
for (const [name, text] of Object.entries(toggles)) {
  const box = (boxes[name] = element("input", { type: "checkbox", checked: options.show[name] }));
  box.addEventListener("change", () => {
    options.show[name] = box.checked;
    ask();
  });
  byId("toggles").append(element("label", {}, box, text));
}
steerBy(canvas, camera, ask, (x, y) => {
  const onShape = linkOfTriangle(painted.triangles, x, y), link = onShape >= 0 ? onShape : linkAt(painted.bars, x, y);
  if (link >= 0 || options.selected >= 0) select(link);
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  readTheme();
  ask();
});
new ResizeObserver(ask).observe(canvas);
addEventListener("error", (event) => {
  byId("status").textContent = event.message;
});
readTheme();
update();

// For scripts: positions by names of joints, as the sliders show them, and poses by names of frames.
globalThis.robcogen = {
  positions: () => Object.fromEntries(robot.joints.map((joint, j) => [joint.name, posture.positions[j]])),
  poses: () => Object.fromEntries(data.frames.map((frame, f) => [frame.name, posture.poses[f]])),
  types: () => robot.joints.map((joint) => joint.type),
  gravity: () => posture.gravity,
  links: () =>
    robot.model.links.map((link, l) => ({ name: link.name, ...posture.masses[l], carried: posture.carried[l] })),
  bars: () => painted.bars,
  shapes: () => robot.shapes.map(({ body, kind, isVisual, link, points }) => ({ body, kind, isVisual, link, points })),
  show: (name, on) => {
    if (boxes[name].checked !== on) boxes[name].click();
  },
  selected: () => options.selected,
  setPosition: (name, value) => setPosition(robot.joints.findIndex((joint) => joint.name === name), value),
  select,
  // The milliseconds that a change of the position and its picture take.
  frameTime: () => {
    const began = performance.now();
    for (let k = 0; k < 10; ++k) {
      posture = postureOf(robot, state);
      showJoints(posture, options.selected);
      draw();
    }
    return (performance.now() - began) / 10;
  },
};
