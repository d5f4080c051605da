// The camera: it turns about a point, moves and zooms, by mouse, touch and keys.
import { dot, subtract } from "./vectors.js";

export function makeCamera(centre, radius) {
  const initial = { azimuth: -0.95, elevation: 0.38, zoom: 1, target: [...centre] };
  return { ...structuredClone(initial), initial, radius };
}

export function resetCamera(camera) {
  Object.assign(camera, structuredClone(camera.initial));
}

// The projection onto a canvas of this size: `see(point)` gives pixels and `near`, which grows towards the viewer;
// `scaleAt(near)` gives pixels per metre.
export function projection(camera, width, height) {
  const { azimuth, elevation, radius, target } = camera;
  const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
  const right = [-sa, ca, 0], down = [se * ca, se * sa, -ce], towards = [ce * ca, ce * sa, se];
  const distance = 6 * radius, base = (0.42 * Math.min(width, height) * camera.zoom) / radius;
  const scaleAt = (near) => (base * distance) / Math.max(distance - near, 0.05 * distance);
  const see = (point) => {
    const p = subtract(point, target), near = dot(towards, p), s = scaleAt(near);
    return { x: width / 2 + s * dot(right, p), y: height / 2 + s * dot(down, p), near };
  };
  return { see, scaleAt, right, down, towards, base };
}

function pan(camera, dx, dy, size) {
  const { right, down, base } = projection(camera, size.width, size.height);
  for (let k = 0; k < 3; ++k) camera.target[k] -= (dx * right[k] + dy * down[k]) / base;
}

function turn(camera, dx, dy) {
  camera.azimuth -= dx * 0.008;
  camera.elevation = Math.min(1.57, Math.max(-1.57, camera.elevation + dy * 0.008));
}

const zoomBy = (camera, factor) => {
  camera.zoom = Math.min(40, Math.max(0.1, camera.zoom * factor));
};

// Calls `changed` when the view changes, and `picked(x, y)` for a click.
export function steerBy(element, camera, changed, picked) {
  const pointers = new Map();
  let moved = 0;
  const size = () => ({ width: element.clientWidth, height: element.clientHeight });
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) moved = 0;
  });
  element.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const dx = event.clientX - last.x, dy = event.clientY - last.y;
    moved += Math.abs(dx) + Math.abs(dy);
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      const before = Math.hypot(last.x - other.x, last.y - other.y);
      const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      if (before > 0) zoomBy(camera, after / before);
      pan(camera, dx / 2, dy / 2, size());
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
      pan(camera, dx, dy, size());
    } else {
      turn(camera, dx, dy);
    }
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    changed();
  });
  const release = (event) => {
    if (!pointers.delete(event.pointerId) || event.type !== "pointerup" || moved > 4) return;
    const box = element.getBoundingClientRect();
    picked(event.clientX - box.left, event.clientY - box.top);
  };
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
  element.addEventListener("contextmenu", (event) => event.preventDefault());
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomBy(camera, Math.exp(-event.deltaY * 0.0012));
    changed();
  }, { passive: false });
  element.addEventListener("keydown", (event) => {
    const turns = { ArrowLeft: [-12, 0], ArrowRight: [12, 0], ArrowUp: [0, -12], ArrowDown: [0, 12] }[event.key];
    const zoom = { "+": 1.15, "=": 1.15, "-": 1 / 1.15 }[event.key];
    if (turns) turn(camera, ...turns);
    else if (zoom) zoomBy(camera, zoom);
    else return;
    event.preventDefault();
    changed();
  });
}
