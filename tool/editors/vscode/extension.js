// Starts `robcogen language-server` for the documents of robcogen and for URDFs.
'use strict';

const vscode = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');

let client;

function activate(context) {
  const command = vscode.workspace.getConfiguration('robcogen').get('path') || 'robcogen';
  const server = { command, args: ['language-server'], transport: TransportKind.stdio };
  const languages = ['kindsl', 'dtdsl', 'motdsl', 'ctdsl'];
  const documentSelector = languages.map((language) => ({ language }));
  documentSelector.push({ scheme: 'file', pattern: '**/*.urdf' });
  client = new LanguageClient('robcogen', 'RobCoGen', server, { documentSelector });
  context.subscriptions.push({ dispose: () => client.stop() });
  return client.start().catch((fault) => {
    vscode.window.showErrorMessage(
      `RobCoGen: cannot start '${command}': ${fault.message}. The setting robcogen.path names the program.`);
  });
}

function deactivate() {
  return client ? client.stop() : undefined;
}

module.exports = { activate, deactivate };
