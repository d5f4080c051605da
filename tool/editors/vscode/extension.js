// Starts `robcogen language-server` for the documents of robcogen and for URDFs, and shows their robots.
'use strict';

const path = require('path');
const vscode = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');
const preview = require('./preview');

let client;

const setting = (name) => vscode.workspace.getConfiguration('robcogen').get(name);

// The arguments that name the folders of imports, for previews. Relative ones are below each folder of the workspace.
function import_arguments() {
  const roots = (vscode.workspace.workspaceFolders || []).map((folder) => folder.uri.fsPath);
  const folders = (setting('importFolders') || []).flatMap((folder) =>
    path.isAbsolute(folder) ? [folder] : roots.map((root) => path.join(root, folder)));
  return folders.flatMap((folder) => ['-I', folder]);
}

function activate(context) {
  const program = () => setting('path') || 'robcogen';
  const command = program();
  const server = { command, args: ['language-server'], transport: TransportKind.stdio };
  const languages = ['kindsl', 'dtdsl', 'motdsl', 'ctdsl'];
  const documentSelector = languages.map((language) => ({ language }));
  documentSelector.push({ scheme: 'file', pattern: '**/*.urdf' });
  client = new LanguageClient('robcogen', 'RobCoGen', server, {
    documentSelector,
    initializationOptions: { importFolders: setting('importFolders') || [] },
    synchronize: { configurationSection: 'robcogen' }, // a change of the settings reaches the server
  });
  context.subscriptions.push(
    { dispose: () => client.stop() },
    vscode.commands.registerCommand('robcogen.view', () => preview.show(program(), import_arguments())),
    vscode.workspace.onDidChangeTextDocument((event) => preview.changed(event.document)),
    { dispose: preview.close_all });
  return client.start().catch((fault) => {
    vscode.window.showErrorMessage(preview.not_started(command, fault));
  });
}

function deactivate() {
  return client ? client.stop() : undefined;
}

module.exports = { activate, deactivate };
