// The panels next to the picture: the outline of links, numbers of the selected one, joints, parameters, warnings.
import { nameOf } from "./positions.js";
import { jointAxis } from "./posture.js";
import { origin } from "./vectors.js";

export function element(tag, properties = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || name === "role" || name === "for") node.setAttribute(name, value);
    else node[name] = value;
  }
  node.append(...children);
  return node;
}

const digits = (value) => {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-4 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
  return text.replace("-", "−");
};
const three = (v) => v.map((x) => digits(Math.abs(x) < 1e-12 ? 0 : x)).join(", ");
const unitOf = (joint) => (joint.type === "prismatic" ? "m" : "rad");
const forceUnit = (joint) => (joint.type === "prismatic" ? "N" : "N m");

// A name that a narrow panel breaks behind underscores.
function breakable(name) {
  return name.split(/(?<=_)/).flatMap((part, i) => (i > 0 ? [element("wbr"), part] : [part]));
}

export function makeOutline(robot, container, select) {
  const { links } = robot.model, buttons = [];
  const item = (l) => {
    const joint = robot.joints[links[l].parent_joint];
    const warned = robot.data.warnings.some((w) => w.link === l);
    const title = joint ? `${links[l].name}, moved by ${nameOf(joint)}` : links[l].name;
    const name = element("span", {}, ...breakable(links[l].name));
    const button = element("button", { type: "button", role: "treeitem", "aria-selected": "false", title }, name);
    if (joint) button.append(element("small", {}, ...breakable(nameOf(joint))));
    if (warned) button.append(element("span", { className: "mark", title: "has warnings" }, "⚠"));
    button.addEventListener("click", () => select(l));
    buttons[l] = button;
    const node = element("li", {}, button);
    if (robot.children[l].length)
      node.append(element("ul", { role: "group" }, ...robot.children[l].map((j) => item(robot.joints[j].child))));
    return node;
  };
  container.replaceChildren(element("ul", {}, item(0)));
  return (selected) => {
    buttons.forEach((button, l) => button.setAttribute("aria-selected", String(l === selected)));
    if (selected < 0) return;
    const panel = container.parentElement, own = buttons[selected].getBoundingClientRect();
    const { top, bottom } = panel.getBoundingClientRect();
    if (own.top < top) panel.scrollTop -= top - own.top + 20;
    if (own.bottom > bottom) panel.scrollTop += own.bottom - bottom + 20;
  };
}

export function makeWarnings(robot, container, select) {
  const { warnings } = robot.data;
  if (warnings.length === 0) return;
  container.replaceChildren(
    element("h2", {}, warnings.length === 1 ? "1 warning" : `${warnings.length} warnings`),
    ...warnings.map(({ message, hint, where, link }) => {
      const text = element("button", { type: "button" }, message);
      if (link >= 0) text.addEventListener("click", () => select(link));
      const more = [where, hint].filter(Boolean).join(" · ");
      return element("p", { className: "warning" }, text, element("small", {}, more));
    }));
}

function listed(pairs) {
  return element("dl", {}, ...pairs.flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)]));
}

export function showLink(robot, posture, selected, container) {
  if (selected < 0) {
    const hint = "Click a link in the picture or in the list to see its numbers.";
    container.replaceChildren(element("p", { className: "hint" }, hint));
    return;
  }
  const { links } = robot.model;
  const mass = posture.masses[selected], all = posture.carried[selected], j = links[selected].parent_joint;
  const pairs = [];
  if (mass) {
    pairs.push(["mass", `${digits(mass.mass)} kg`], ["centre of mass", `${three(mass.com)} m`]);
    pairs.push(["principal moments", `${three(mass.moments)} kg m²`]);
    pairs.push(["ellipsoid, semi-axes", `${three(mass.semi)} m`]);
  } else {
    pairs.push(["mass", "none"]);
  }
  if (all.centre && robot.children[selected].length) {
    pairs.push(["mass of the subtree", `${digits(all.mass)} kg`]);
    pairs.push(["its centre of mass, in the base", `${three(all.centre)} m`]);
  }
  pairs.push(["origin, in the base", `${three(origin(posture.poses[selected]))} m`]);
  if (j >= 0) {
    const joint = robot.joints[j], isBall = joint.type === "spherical";
    pairs.push(["joint", `${nameOf(joint)}, ${joint.type}`]);
    if (!isBall) pairs.push(["axis, in the base", three(jointAxis(robot, posture, j))]);
    if (joint.type === "helical") pairs.push(["pitch", `${digits(joint.pitch)} m/rad`]);
    const position = isBall ? three(posture.positions.slice(j, j + 3)) : digits(posture.positions[j]);
    pairs.push([isBall ? "rotation vector" : "position", `${position} ${unitOf(joint)}`]);
    const isFree = joint.lower === -Infinity && joint.upper === Infinity;
    pairs.push(["limits", isFree ? "none" : `${digits(joint.lower)} … ${digits(joint.upper)} ${unitOf(joint)}`]);
  }
  robot.data.frames.forEach((frame, f) => {
    const isOwn = frame.kind === "user" && frame.link === selected && frame.name !== links[selected].name;
    if (isOwn) pairs.push([frame.name, `${three(origin(posture.poses[f]))} m`]);
  });
  container.replaceChildren(element("h3", {}, links[selected].name), listed(pairs));
}

// A slider for each coordinate. Without limits, it ranges over half a turn, or as far as the robot is long. The sliders
// of a spherical joint are its rotation vector.
export function makeJoints(robot, state, around, container, changed, select) {
  if (robot.joints.length === 0) return () => {};
  const rows = robot.joints.map((joint, j) => {
    const slides = joint.type === "prismatic", free = slides ? around : Math.PI;
    const name = element("b", { title: "Select the link" }, joint.name);
    name.addEventListener("click", () => select(joint.child));
    const force = element("output", {});
    if (j >= robot.dof) {
      const value = element("output", {});
      const follows = element("small", {}, "follows");
      const node = element("div", { className: "joint" }, element("div", { className: "row" }, name, follows, value));
      return { node, joint, j, value };
    }
    const lower = Number.isFinite(joint.lower) ? joint.lower : Math.min(-free, state.coordinates[j]);
    const upper = Number.isFinite(joint.upper) ? joint.upper : Math.max(free, state.coordinates[j]);
    const label = `${joint.name}, ${unitOf(joint)}`;
    const slider = element("input", { type: "range", min: lower, max: upper, step: "any", "aria-label": label });
    const field = element("input", { type: "number", step: "any", "aria-label": label });
    slider.addEventListener("input", () => changed(j, Number(slider.value)));
    field.addEventListener("change", () => {
      const value = Number(field.value);
      const inside = field.value !== "" && Number.isFinite(value) && !(value < joint.lower) && !(value > joint.upper);
      field.setCustomValidity(inside ? "" : `between ${digits(joint.lower)} and ${digits(joint.upper)}`);
      field.reportValidity();
      if (inside) changed(j, value);
    });
    const unit = element("small", {}, unitOf(joint));
    const row = element("div", { className: "row" }, name, field, unit);
    const node = element("div", { className: "joint" }, row, slider, force);
    return { node, joint, j, slider, field, force };
  });
  container.replaceChildren(element("h2", {}, "Joints"), ...rows.map((row) => row.node));
  // Unchanged text is not written again, because the browser would lay it out anew.
  const write = (output, text) => {
    if (output.textContent !== text) output.textContent = text;
  };
  return (posture, selected) => {
    const largest = posture.gravity ? Math.max(...posture.gravity.map(Math.abs)) : 0;
    for (const { node, joint, j, slider, field, force, value } of rows) {
      node.classList.toggle("chosen", joint.child === selected);
      const position = posture.positions[j];
      if (value) {
        write(value, `${digits(position)} ${unitOf(joint)}`);
        continue;
      }
      if (Number(slider.value) !== position) slider.value = position;
      const shown = String(Number(position.toPrecision(5)));
      if (document.activeElement !== field && field.value !== shown) field.value = shown;
      const turn = joint.type === "prismatic" ? "" : `${digits((position * 180) / Math.PI)}°`;
      const own = posture.gravity && Math.abs(posture.gravity[j]) > 1e-12 * largest ? posture.gravity[j] : 0;
      const weight = posture.gravity ? `gravity ${digits(own)} ${forceUnit(joint)}` : "";
      write(force, [weight, turn].filter(Boolean).join(" · "));
    }
  };
}

export function makeParameters(state, container, changed) {
  const names = Object.keys(state.parameters);
  if (names.length === 0) return;
  container.replaceChildren(element("h2", {}, "Parameters"), ...names.map((name) => {
    const field = element("input", { type: "number", step: "any", value: state.parameters[name], "aria-label": name });
    field.addEventListener("input", () => {
      const value = Number(field.value), good = field.value !== "" && Number.isFinite(value);
      field.setCustomValidity(good ? "" : "a number");
      if (good) changed(name, value);
    });
    return element("label", { className: "parameter" }, element("span", {}, name), field);
  }));
}
