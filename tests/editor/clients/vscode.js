// Tests the VS Code extension with stand-ins for the modules of VS Code and npm.
//
//     node vscode.js EXTENSION ROBCOGEN ROBOT
'use strict';

const assert = require('assert');
const fs = require('fs');
const Module = require('module');
const os = require('os');
const path = require('path');

const kPart = `Part Nothing {
  root link_of_nothing via joint_of_nothing
  link link_of_nothing { children {} }
  r_joint joint_of_nothing { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
`;

const seen = { clients: [], messages: [], stopped: 0 };
let settings = {};
let fault = null;

class LanguageClient {
  constructor(id, name, server, options) {
    Object.assign(this, { id, name, server, options });
    seen.clients.push(this);
  }
  start() {
    return fault ? Promise.reject(fault) : Promise.resolve();
  }
  stop() {
    seen.stopped += 1;
    return Promise.resolve();
  }
}

const commands = {};
const panels = [];
let changed;
const disposable = { dispose() {} };

function createWebviewPanel(type, title) {
  const panel = { title, webview: { html: '' }, revealed: 0, disposed: false };
  panel.onDidDispose = (listener) => (panel.listener = listener);
  panel.reveal = () => (panel.revealed += 1);
  panel.dispose = () => {
    panel.disposed = true;
    panel.listener();
  };
  panels.push(panel);
  return panel;
}

const stand_ins = {
  vscode: {
    workspace: {
      getConfiguration: (section) => ({ get: (key) => settings[`${section}.${key}`] }),
      onDidChangeTextDocument: (listener) => {
        changed = listener;
        return disposable;
      },
    },
    window: { showErrorMessage: (text) => seen.messages.push(text), createWebviewPanel, activeTextEditor: undefined },
    commands: {
      registerCommand: (name, action) => {
        commands[name] = action;
        return disposable;
      },
    },
    ViewColumn: { Beside: -2 },
  },
  'vscode-languageclient/node': { LanguageClient, TransportKind: { stdio: 0 } },
};
const load = Module._load;
Module._load = (request, ...rest) => stand_ins[request] || load(request, ...rest);

const extension = require(process.argv[2]);
const context = () => ({ subscriptions: [] });

// Waits until the condition on the page or its title holds.
async function until(condition) {
  for (let i = 0; i < 200 && !condition(); ++i) await new Promise((done) => setTimeout(done, 50));
  assert.ok(condition(), condition.toString());
}

async function preview() {
  // The robot imports a part that is found only through a folder in the settings.
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'robcogen-test-'));
  fs.mkdirSync(path.join(folder, 'parts'));
  fs.writeFileSync(path.join(folder, 'parts', 'nothing.kindsl'), kPart);
  stand_ins.vscode.workspace.workspaceFolders = [{ uri: { fsPath: folder } }];
  settings = { 'robcogen.path': process.argv[3], 'robcogen.importFolders': ['parts', '/opt/parts'] };
  const subscribed = context();
  await extension.activate(subscribed);
  assert.strictEqual(await commands['robcogen.view'](), undefined); // no editor is active
  const fileName = process.argv[4];
  let text = 'import "nothing.kindsl"\n' + fs.readFileSync(fileName, 'utf8');
  const document = { fileName, getText: () => text };
  stand_ins.vscode.window.activeTextEditor = { document };

  await commands['robcogen.view']();
  const [panel] = panels;
  assert.match(panel.webview.html, /<canvas/);
  assert.match(panel.webview.html, /HyL/);
  await commands['robcogen.view']();
  assert.strictEqual(panels.length, 1);
  assert.strictEqual(panel.revealed, 1);

  const right = text;
  text = right.replace('Robot HyL', 'Robot HyL {');
  changed({ document });
  await until(() => panel.title === 'hyl.kindsl: errors');
  assert.match(panel.webview.html, /<canvas/);
  text = right.replace('Robot HyL', 'Robot Unsaved');
  changed({ document });
  await until(() => /Unsaved/.test(panel.webview.html));
  assert.strictEqual(panel.title, 'hyl.kindsl');

  panel.dispose();
  text = right.replace('Robot HyL', 'Robot');
  await commands['robcogen.view']();
  const messages = /^<pre>robcogen: warning: -I: [^\n]*'\/opt\/parts'[^\n]*\nhyl\.kindsl:\d+:\d+: error/;
  assert.match(panels[1].webview.html, messages);
  panels[1].dispose();
  settings['robcogen.path'] = '/nowhere/robcogen';
  await commands['robcogen.view']();
  assert.match(panels[2].webview.html, /cannot start '\/nowhere\/robcogen': .*robcogen\.path/);
  subscribed.subscriptions.forEach((s) => s.dispose());
  assert.ok(panels[2].disposed);
  assert.deepStrictEqual(seen.clients[0].server.args, ['language-server']);
  assert.deepStrictEqual(seen.clients[0].options.initializationOptions, { importFolders: ['parts', '/opt/parts'] });
  assert.strictEqual(seen.clients[0].options.synchronize.configurationSection, 'robcogen');
  stand_ins.vscode.workspace.workspaceFolders = undefined;
  fs.rmSync(folder, { recursive: true, force: true });
  seen.clients.pop();
  seen.stopped = 0;
  settings = {};
}

async function run() {
  await preview();

  await extension.activate(context());
  const [first] = seen.clients;
  assert.strictEqual(first.server.command, 'robcogen');
  assert.deepStrictEqual(first.server.args, ['language-server']);
  const languages = first.options.documentSelector.map((selector) => selector.language || selector.pattern);
  assert.deepStrictEqual(languages, ['kindsl', 'dtdsl', 'motdsl', 'ctdsl', '**/*.urdf']);
  assert.deepStrictEqual(seen.messages, []);

  settings = { 'robcogen.path': '/opt/bin/robcogen' };
  fault = new Error('no such file');
  const subscribed = context();
  await extension.activate(subscribed);
  assert.strictEqual(seen.clients[1].server.command, '/opt/bin/robcogen');
  assert.strictEqual(seen.messages.length, 1);
  assert.match(seen.messages[0], /cannot start '\/opt\/bin\/robcogen': no such file.*robcogen\.path/);

  await extension.deactivate();
  subscribed.subscriptions.forEach((s) => s.dispose());
  assert.strictEqual(seen.stopped, 2);
}

run().catch((wrong) => {
  console.error(wrong);
  process.exit(1);
});
