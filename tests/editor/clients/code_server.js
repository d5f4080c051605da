// The extension in a real Visual Studio Code: code-server, driven through Chromium.
//
//     node code_server.js NODE_MODULES robcogen.vsix ROBCOGEN ROBOT CHROMIUM
//
// To create NODE_MODULES (Debian: libkrb5-dev libxkbfile-dev libsecret-1-dev chromium):
//
//     npm install --ignore-scripts code-server playwright-core && npm rebuild argon2
//     cd node_modules/code-server/lib/vscode && npm install --ignore-scripts --omit=dev
//     npm rebuild node-pty @vscode/spdlog        # builds what is needed even if it ends with an error
'use strict';

const { execFileSync, spawn } = require('child_process');
const assert = require('assert');
const fs = require('fs');
const os = require('os');
const path = require('path');

const [modules, extension, robcogen, robot, browser_path] = process.argv.slice(2).map((p) => path.resolve(p));
const { chromium } = require(path.join(modules, 'playwright-core'));
const kPort = 18921;
const home = fs.mkdtempSync(path.join(os.tmpdir(), 'robcogen-code-'));
const workspace = path.join(home, 'robots');
const file = path.basename(robot);
const settings = path.join(home, 'user', 'User', 'settings.json');
const entry = path.join(modules, 'code-server', 'out', 'node', 'entry.js');
const options = ['--user-data-dir', path.join(home, 'user'), '--extensions-dir', path.join(home, 'extensions')];

function write_settings(more) {
  fs.mkdirSync(path.dirname(settings), { recursive: true });
  fs.writeFileSync(settings, JSON.stringify({ 'workbench.startupEditor': 'none', 'editor.minimap.enabled': false, 'files.autoSave': 'off', ...more }));
}

async function run(page) {
  const texts = (selector) => page.$$eval(selector, (all) => all.map((e) => e.innerText.replace(/\u00a0/g, ' ')));
  const until = async (what, condition) => {
    for (let i = 0; i < 100; ++i) {
      if (await condition()) return console.log(`ok ${what}`);
      await page.waitForTimeout(200);
    }
    await page.screenshot({ path: 'code_server.png' });
    assert.fail(`${what} (see code_server.png)`);
  };
  const command = async (name) => {
    await page.keyboard.press('F1');
    await page.waitForSelector('.quick-input-widget input:focus');
    await page.keyboard.type(name);
    await page.locator('.quick-input-list .monaco-list-row', { hasText: name }).first().click();
  };
  const titles = () => texts('.tab .label-name');
  const first_line = () => page.locator('.editor-instance .view-line').first();

  await page.goto(`http://127.0.0.1:${kPort}/?folder=${workspace}`);
  await page.locator('.explorer-folders-view .label-name', { hasText: file }).first().dblclick();
  await until('the file is of our language', async () => (await texts('.statusbar-item')).join().includes('Kinematics-DSL'));

  await until('without the program a message names the setting', async () =>
    (await texts('.notification-list-item')).join().includes('robcogen.path'));
  await first_line().click();
  await command('RobCoGen: Show the Robot');
  const pages = async () => {
    const found = [];
    for (const frame of page.frames())
      if (frame !== page.mainFrame()) found.push(await frame.evaluate(() => document.body.innerText).catch(() => ''));
    return found;
  };
  await until('so does the preview', async () => (await pages()).some((text) => text.includes('robcogen.path')));

  write_settings({ 'robcogen.path': robcogen });
  await page.reload();
  await page.locator('.tab .label-name', { hasText: file }).first().click();
  await page.locator('.pane-header', { hasText: 'Outline' }).click();
  await until('the outline is the tree', async () => (await texts('.outline-element .label-name')).includes('base'));
  await until('hints say what a link carries', async () => (await texts('.view-line')).join().match(/carr|kg/));
  await page.locator('.view-line span span', { hasText: /^upperleg$/ }).first().hover();
  await until('a text at the pointer', async () => (await texts('.monaco-hover')).join().includes('mass 2.638 kg'));
  await command('RobCoGen: Show the Robot');
  const canvas = async () => (await Promise.all(page.frames().map((f) => f.$('canvas').catch(() => null)))).some(Boolean);
  await until('the preview draws the robot', canvas);

  await first_line().click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('\nnonsense');
  const problems = async () => page.$$eval('.statusbar-item', (all) => all.map((e) => e.getAttribute('aria-label')).join());
  await until('a message as one types', async () => /Errors: [1-9]/.test(await problems()));
  await until('the preview says so', async () => (await titles()).includes(`${file}: errors`));
  await until('and keeps the last page', canvas);
  await command('File: Revert File');
  await until('the message is gone', async () => !/Errors: [1-9]/.test(await problems()));
  await until('and from the preview', async () => !(await titles()).includes(`${file}: errors`));

  await command('Format Document');
  await page.keyboard.press('Control+s');
  const canonical = execFileSync(robcogen, ['print', robot], { encoding: 'utf8' });
  await until('formatting is the canonical print', async () => fs.readFileSync(path.join(workspace, file), 'utf8') === canonical);
}

async function main() {
  fs.mkdirSync(workspace);
  fs.copyFileSync(robot, path.join(workspace, file));
  write_settings({ 'robcogen.path': '/nowhere/robcogen' });
  execFileSync(process.execPath, [entry, ...options, '--install-extension', extension]);
  const server = spawn(
    process.execPath,
    [entry, ...options, '--auth', 'none', '--bind-addr', `127.0.0.1:${kPort}`, '--disable-workspace-trust', workspace],
    { stdio: ['ignore', 'pipe', 'inherit'] });
  await new Promise((ready) => server.stdout.on('data', (data) => String(data).includes('HTTP server listening') && ready()));
  const browser = await chromium.launch({ executablePath: browser_path, args: ['--no-sandbox'] });
  try {
    await run(await browser.newPage({ viewport: { width: 1600, height: 900 } }));
  } finally {
    await browser.close();
    server.kill();
    fs.rmSync(home, { recursive: true, force: true });
  }
}

main().then(() => process.exit(0), (fault) => {
  console.error(fault);
  process.exit(1);
});
