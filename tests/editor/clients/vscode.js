// The extension of VS Code, with stand-ins for the modules that VS Code and npm give it.
'use strict';

const assert = require('assert');
const Module = require('module');

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

const stand_ins = {
  vscode: {
    workspace: { getConfiguration: (section) => ({ get: (key) => settings[`${section}.${key}`] }) },
    window: { showErrorMessage: (text) => seen.messages.push(text) },
  },
  'vscode-languageclient/node': { LanguageClient, TransportKind: { stdio: 0 } },
};
const load = Module._load;
Module._load = (request, ...rest) => stand_ins[request] || load(request, ...rest);

const extension = require(process.argv[2]);
const context = () => ({ subscriptions: [] });

async function run() {
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
