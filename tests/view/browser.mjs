// Chromium without a window, driven over a pipe: pages, what they say, clicks, pictures.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const kPatience = 60000; // ms, for one answer

export async function startBrowser(program) {
  const folder = mkdtempSync(join(tmpdir(), "robcogen-chromium-"));
  const options = [
    "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run", "--disable-extensions",
    "--disable-background-networking", "--disable-dev-shm-usage", "--remote-debugging-pipe",
    `--user-data-dir=${folder}`,
  ];
  const stdio = ["ignore", "ignore", "ignore", "pipe", "pipe"];
  const browser = spawn(program, [...options, "about:blank"], { stdio });
  const waiting = new Map(), listeners = [];
  let count = 0, rest = "";
  const fail = (message) => {
    for (const { refuse } of waiting.values()) refuse(new Error(message));
    waiting.clear();
  };
  browser.on("exit", () => fail("the browser has ended"));
  browser.on("error", (fault) => fail(`${program}: ${fault.message}`));
  browser.stdio[3].on("error", () => fail("the browser does not listen"));
  browser.stdio[4].setEncoding("utf8").on("data", (text) => {
    const messages = (rest + text).split("\0");
    rest = messages.pop();
    for (const message of messages.map((m) => JSON.parse(m))) {
      const asked = waiting.get(message.id);
      waiting.delete(message.id);
      if (!asked) listeners.forEach((listen) => listen(message));
      else if (message.error) asked.refuse(new Error(`${asked.method}: ${message.error.message}`));
      else asked.accept(message.result);
    }
  });
  const send = (method, params = {}, sessionId = undefined) =>
    new Promise((accept, refuse) => {
      count += 1;
      const clock = setTimeout(() => refuse(new Error(`${method}: no answer`)), kPatience);
      const end = (call) => (value) => {
        clearTimeout(clock);
        call(value);
      };
      waiting.set(count, { method, accept: end(accept), refuse: end(refuse) });
      browser.stdio[3].write(`${JSON.stringify({ id: count, method, params, sessionId })}\0`);
    });
  const stop = async () => {
    const ended = new Promise((done) => browser.on("exit", done));
    if (browser.exitCode === null) browser.kill("SIGKILL");
    await ended;
    try {
      rmSync(folder, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
    } catch (error) {
      console.log(`${folder} remains: ${error.code}`);  // Chromium still writes to it
    }
  };
  return { send, stop, listen: (listener) => listeners.push(listener) };
}

// A page of that size. `faults` collects exceptions, messages of errors, and everything that was loaded but the page.
export async function openPage(browser, width, height) {
  const { targetId } = await browser.send("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await browser.send("Target.attachToTarget", { targetId, flatten: true });
  const send = (method, params) => browser.send(method, params, sessionId);
  const page = { faults: [], loaded: () => {}, url: "" };
  browser.listen((message) => {
    if (message.sessionId !== sessionId) return;
    const { method, params } = message;
    if (method === "Runtime.exceptionThrown")
      page.faults.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type))
      page.faults.push(params.args.map((a) => a.value).join(" "));
    if (method === "Log.entryAdded" && params.entry.level === "error") page.faults.push(params.entry.text);
    if (method === "Network.requestWillBeSent" && params.request.url !== page.url)
      page.faults.push(`loads ${params.request.url.slice(0, 80)}`);
    if (method === "Page.loadEventFired") page.loaded();
  });
  for (const domain of ["Page", "Runtime", "Log", "Network"]) await send(`${domain}.enable`);
  const resize = (w, h) =>
    send("Emulation.setDeviceMetricsOverride", { width: w, height: h, deviceScaleFactor: 1, mobile: false });
  await resize(width, height);
  const evaluate = async (expression) => {
    const asked = { expression, returnByValue: true, awaitPromise: true };
    const { result, exceptionDetails } = await send("Runtime.evaluate", asked);
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description}`);
    return result.value;
  };
  return {
    faults: page.faults,
    resize,
    evaluate,
    open: async (url) => {
      page.url = url;
      const isLoaded = new Promise((done) => (page.loaded = done));
      await send("Page.navigate", { url });
      await isLoaded;
    },
    close: () => browser.send("Target.closeTarget", { targetId }),
    // Two frames: what was asked for is drawn.
    settle: () =>
      evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"),
    mouse: (type, x, y, buttons = 0) =>
      send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons, clickCount: 1 }),
    touch: (type, points) =>
      send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) }),
    prefer: (scheme) =>
      send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] }),
    picture: async () => Buffer.from((await send("Page.captureScreenshot", { format: "png" })).data, "base64"),
  };
}
