// Pages of robots in a browser: they load without a fault and without a network, their sliders move what they should,
// and clicks, parameters and the swing do what they say. Poses and forces are those of `robcogen eval`.
//
// node pages.mjs TOOL CHROMIUM FOLDER MODEL…
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { basename, extname, join } from "node:path";
import { pathToFileURL } from "node:url";

import { openPage, startBrowser } from "./browser.mjs";

const kTolerance = 1e-9; // m, N m: relative to the size of the numbers
const kFrames = 3; // frames of a robot that eval is asked for: a run each
const [tool, chromium, folder, ...models] = process.argv.slice(2);

// Runs the generator; what it says of the model stays away.
const run = (...words) => execFileSync(tool, words, { stdio: ["pipe", "pipe", "pipe"], encoding: "utf8" });
const evaluated = (model, name, given) => {
  const options = { input: JSON.stringify(given), stdio: ["pipe", "pipe", "ignore"] };
  return JSON.parse(execFileSync(tool, ["eval", model, name, "--quiet"], options));
};

function assertNear(actual, expected, what) {
  const largest = Math.max(1, ...expected.map(Math.abs));
  assert.equal(actual.length, expected.length, what);
  actual.forEach((value, k) =>
    assert.ok(Math.abs(value - expected[k]) <= kTolerance * largest, `${what}: ${value} instead of ${expected[k]}`));
}

const sliders = (page) =>
  page.evaluate(`[...document.querySelectorAll("#joints input[type=range]")].map((s) => ({
    joint: s.ariaLabel.split(", ")[0], low: Number(s.min), high: Number(s.max) }))`);
const moveSlider = (page, k, value) =>
  page.evaluate(`(() => {
    const slider = document.querySelectorAll("#joints input[type=range]")[${k}];
    slider.value = ${value};
    const set = Number(slider.value);
    slider.dispatchEvent(new Event("input"));
    return set;
  })()`);
const poses = (page) => page.evaluate("robcogen.poses()");

// Links that the joint carries, by the outline.
const carriedBy = (page, joint) =>
  page.evaluate(`(() => {
    const items = [...document.querySelectorAll("#outline li")];
    const item = items.find((i) => i.querySelector("button small")?.textContent === ${JSON.stringify(joint)} &&
      i.firstChild.querySelector("small"));
    return [...item.querySelectorAll("button")].map((b) => b.querySelector("span").textContent);
  })()`);

// Arguments q of functions from what sliders show: of a spherical joint, whose three are the vector of its turn, the
// unit quaternion of half the angle.
function elementsOf(joints, positions) {
  const q = [];
  for (let j = 0; j < joints.length; ++j) {
    if (joints[j] !== "spherical") {
      q.push(positions[j]);
      continue;
    }
    const turn = positions.slice(j, j + 3), angle = Math.hypot(...turn);
    q.push(Math.cos(angle / 2), ...turn.map((v) => (v / angle) * Math.sin(angle / 2)));
    j += 2;
  }
  return q;
}

// Each slider moves the links that its joint carries, and no others. Where loops are closed step by step, sliders move a
// little: far away a loop cannot be closed.
async function checkSliders(page) {
  const data = await page.evaluate("JSON.parse(document.getElementById('data').textContent)");
  const links = await page.evaluate("robcogen.links().map((l) => l.name)");
  const list = await sliders(page), q = [], types = await page.evaluate("robcogen.types()");
  const nameOf = (type, component) => (type === "spherical" ? component.slice(0, -2) : component);
  const start = Object.values(await page.evaluate("robcogen.positions()"));
  const share = start.length > list.length ? 0.004 : 0.06;
  for (let k = 0; k < list.length; ++k) {
    const before = await poses(page);
    const { joint, low, high } = list[k];
    q.push(await moveSlider(page, k, low + (0.5 + share * (1 + (k % 5))) * (high - low)));
    const after = await poses(page), positions = await page.evaluate("robcogen.positions()");
    assert.equal(positions[joint], q[k], `position of ${joint}`);
    const moved = data.frames
      .filter((f) => f.kind === "link" && JSON.stringify(before[f.name]) !== JSON.stringify(after[f.name]))
      .map((f) => links[f.link]);
    if (low === high) assert.deepEqual(moved, [], `${joint} cannot move`);
    else if (Object.keys(positions).length > list.length) assert.ok(moved.length > 0, `${joint} moves nothing`);
    else assert.deepEqual(moved.sort(), (await carriedBy(page, nameOf(types[k], joint))).sort(), `what ${joint} moves`);
  }
  return { q: elementsOf(types.slice(0, list.length), q), data };
}

async function checkPoses(page, model, given, data) {
  const base = data.frames[0].name, all = await poses(page);
  const shown = data.frames.slice(1);
  const step = Math.max(1, Math.floor(shown.length / kFrames));
  for (let k = shown.length - 1; k >= 0; k -= step) {
    const { name } = shown[k];
    const { X } = evaluated(model, `transforms.homogeneous.${base}_X_${name}`, given);
    assertNear(all[name].flat(), X.flat(), `pose of ${name}`);
  }
  const positions = Object.values(await page.evaluate("robcogen.positions()"));
  const following = positions.length - (await sliders(page)).length;
  if (following > 0) {
    const [expected] = Object.values(evaluated(model, "joint_positions", given));
    assertNear(positions.slice(-following), expected.slice(-following), "positions of joints that follow");
  }
  const forces = await page.evaluate("robcogen.gravity()");
  if (forces && !data.about.includes("floating")) {
    const { tau } = evaluated(model, "gravity_forces", given);
    assertNear(forces, tau, "forces of gravity");
  }
}

const canvasBox = (page) => page.evaluate("document.getElementById('canvas').getBoundingClientRect().toJSON()");

// The outline selects, and so does a click on the bar of the link.
async function checkSelection(page) {
  await page.settle();
  const bars = await page.evaluate("robcogen.bars()");
  const box = await canvasBox(page);
  const middles = bars.map(({ a, b }) => [box.left + (a.x + b.x) / 2, box.top + (a.y + b.y) / 2]);
  const [x, y] = await page.evaluate(
    `${JSON.stringify(middles)}.find(([x, y]) => document.elementFromPoint(x, y)?.id === "canvas")`);
  await page.mouse("mousePressed", x, y, 1);
  await page.mouse("mouseReleased", x, y);
  const picked = await page.evaluate("robcogen.selected()");
  assert.ok(picked >= 0, "a click on a bar selects its link");
  const selected = await page.evaluate(`document.querySelector("#outline [aria-selected=true] span").textContent`);
  assert.equal(selected, await page.evaluate(`robcogen.links()[${picked}].name`));
  assert.equal(await page.evaluate(`document.querySelector("#link h3").textContent`), selected);
  const other = await page.evaluate(`(() => {
    const button = [...document.querySelectorAll("#outline button")].find((b) => b.ariaSelected !== "true");
    button.click();
    return button.querySelector("span").textContent;
  })()`);
  assert.equal(await page.evaluate("robcogen.links()[robcogen.selected()].name"), other, "the outline selects");
}

// The longest bar, in pixels.
const sizeOf = (bars) => Math.max(...bars.map(({ a, b }) => Math.hypot(b.x - a.x, b.y - a.y)));

// By mouse, by two fingers that part, and by keys.
async function checkTurning(page) {
  const bars = async () => {
    await page.settle();
    return page.evaluate("robcogen.bars()");
  };
  const first = await bars();
  const { left, top, width, height } = await canvasBox(page);
  const x = left + width / 2, y = top + height / 8;
  await page.mouse("mousePressed", x, y, 1);
  await page.mouse("mouseMoved", x + 60, y + 30, 1);
  await page.mouse("mouseReleased", x + 60, y + 30);
  const turned = await bars();
  assert.notDeepEqual(turned, first, "the mouse turns the robot");
  await page.touch("touchStart", [[x - 20, y], [x + 20, y]]);
  await page.touch("touchMove", [[x - 40, y], [x + 40, y]]);
  await page.touch("touchEnd", []);
  const larger = await bars();
  assert.ok(sizeOf(larger) > 1.2 * sizeOf(turned), "two fingers zoom");
  await page.evaluate(`document.getElementById("canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "-" }))`);
  assert.ok(sizeOf(await bars()) < sizeOf(larger), "keys zoom");
  await page.evaluate("document.getElementById('view').click()");
  assert.deepEqual(await bars(), first, "the initial view");
}

async function checkSwing(page) {
  if (await page.evaluate("document.getElementById('swing').hidden")) return;
  await page.evaluate("document.getElementById('swing').click()");
  await page.evaluate("new Promise((done) => setTimeout(done, 150))");
  const { status, isOn } = await page.evaluate(`({
    status: document.getElementById("status").textContent,
    isOn: document.getElementById("swing").ariaPressed === "true",
  })`);
  assert.equal(isOn, status === "", "the swing goes on, or says why it does not");
  if (isOn) await page.evaluate("document.getElementById('swing').click()");
  const { q } = await page.evaluate("({ q: Object.values(robcogen.positions()) })");
  assert.ok(q.every(Number.isFinite), "positions stay finite");
  return status;
}

// Nothing is wider than its page, and the picture shows something on both papers.
async function checkLayout(page) {
  for (const [width, height] of [[1400, 900], [900, 700], [390, 800]]) {
    await page.resize(width, height);
    await page.settle();
    const wide = await page.evaluate("document.documentElement.scrollWidth - innerWidth");
    assert.ok(wide <= 0, `the page is ${wide} pixels too wide at ${width}`);
  }
  await page.resize(1400, 900);
  const cut = await page.evaluate(`[...document.querySelectorAll("#outline span, #outline small")]
    .filter((name) => name.scrollWidth > name.clientWidth + 1).map((name) => name.textContent)`);
  assert.deepEqual(cut, [], "the list shows whole names");
  const off = await page.evaluate(`[...document.querySelectorAll("#toggles label")]
    .filter((label) => !label.firstChild.checked).map((label) => label.textContent)`);
  assert.ok(off.includes("other frames"), "frames that are not at a joint are off at first");
  const papers = [];
  for (const scheme of ["dark", "light"]) {
    await page.prefer(scheme);
    await page.settle();
    papers.push(await page.evaluate("getComputedStyle(document.body).backgroundColor"));
    const colours = await page.evaluate(`(() => {
      const canvas = document.getElementById("canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    })()`);
    assert.ok(colours > 50, `the picture on ${scheme} paper has ${colours} colours`);
  }
  assert.notEqual(papers[0], papers[1]);
}

async function checkParameters(page, model, q, data) {
  const names = Object.keys(data.parameters);
  if (names.length === 0) return;
  const parameters = { ...data.parameters };
  for (let k = 0; k < names.length; ++k) {
    parameters[names[k]] *= 1.3;
    await page.evaluate(`(() => {
      const field = document.querySelectorAll("#parameters input")[${k}];
      field.value = ${parameters[names[k]]};
      field.dispatchEvent(new Event("input"));
    })()`);
  }
  await checkPoses(page, model, { q, parameters }, data);
}

async function checkRobot(browser, model) {
  const name = basename(model, extname(model)), file = join(folder, `${name}.html`);
  const isDocument = extname(model) !== ".urdf";
  run("view", model, "-o", file, ...(isDocument ? [] : ["--free-mimic-joints", "--allow-implausible"]));
  const page = await openPage(browser, 1400, 900);
  await page.open(pathToFileURL(file).href);
  assert.deepEqual(page.faults, [], "the page loads");
  const { q, data } = await checkSliders(page);
  if (isDocument) {
    const given = Object.keys(data.parameters).length ? { q, parameters: data.parameters } : { q };
    await checkPoses(page, model, given, data);
    await checkParameters(page, model, q, data);
  }
  await page.settle();
  writeFileSync(join(folder, `${name}.png`), await page.picture());
  await checkSelection(page);
  await checkTurning(page);
  await checkLayout(page);
  const status = await checkSwing(page);
  const time = await page.evaluate("robcogen.frameTime()");
  assert.deepEqual(page.faults, []);
  await page.close();
  console.log(`${name}: ${q.length} positions, ${time.toFixed(1)} ms a frame. ${status ?? "It cannot swing."}`);
}

mkdirSync(folder, { recursive: true });
const browser = await startBrowser(chromium);
let failures = 0;
try {
  for (const model of models) {
    try {
      await checkRobot(browser, model);
    } catch (fault) {
      failures += 1;
      console.error(`${model}: ${fault.stack}`);
    }
  }
} finally {
  await browser.stop();
}
console.log(`${models.length - failures} of ${models.length} pages are right`);
process.exitCode = failures > 0 || models.length === 0 ? 1 : 0;
