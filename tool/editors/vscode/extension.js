// Starts `robcogen language-server` for the documents of robcogen and for URDFs, and shows their robots.
'use strict';

const vscode = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');
const preview = require('./preview');

let client;

function activate(context) {
  const program = () => vscode.workspace.getConfiguration('robcogen').get('path') || 'robcogen';
  const command = program();
  const server = { command, args: ['language-server'], transport: TransportKind.stdio };
  const languages = ['kindsl', 'dtdsl', 'motdsl', 'ctdsl'];
  const documentSelector = languages.map((language) => ({ language }));
  documentSelector.push({ scheme: 'file', pattern: '**/*.urdf' });
  client = new LanguageClient('robcogen', 'RobCoGen', server, { documentSelector });
  context.subscriptions.push(
    { dispose: () => client.stop() },
    vscode.commands.registerCommand('robcogen.view', () => preview.show(program())),
    vscode.workspace.onDidChangeTextDocument((event) => preview.changed(event.document)),
    { dispose: preview.close_all });
  return client.start().catch((fault) => {
    vscode.window.showErrorMessage(
      `RobCoGen: cannot start '${command}': ${fault.message}. The setting robcogen.path names the program.`);
  });
}

function deactivate() {
  return client ? client.stop() : undefined;
}

module.exports = { activate, deactivate };
