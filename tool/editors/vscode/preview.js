// The page of `robcogen view` next to a robot document, updated when its text changes.
'use strict';

const { execFile } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const vscode = require('vscode');

const kDelay = 400; // ms without a change
const previews = new Map(); // by the path of the document

// Says why the program cannot be started, and what to do.
const not_started = (program, fault) =>
  `RobCoGen: cannot start '${program}': ${fault.message}. The setting robcogen.path names the program.`;

const escaped = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;');

class Preview {
  constructor(document, program, imports) {
    this.document = document;
    this.program = program;
    this.imports = imports;
    this.name = path.basename(document.fileName);
    this.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'robcogen-'));
    this.has_page = false;
    this.panel = vscode.window.createWebviewPanel('robcogen.view', this.name, vscode.ViewColumn.Beside, {
      enableScripts: true,
      retainContextWhenHidden: true,
    });
    this.panel.onDidDispose(() => this.dispose());
  }

  // Renders the text as it is in the editor, saved or not. Imports are found next to the document.
  render() {
    const copy = path.join(this.folder, this.name);
    const page = path.join(this.folder, 'page.html');
    fs.writeFileSync(copy, this.document.getText());
    const beside = path.dirname(this.document.fileName);
    this.run = new Promise((done) => {
      execFile(this.program, ['view', copy, '-I', beside, ...this.imports, '-o', page], (fault, output, messages) => {
        if (!this.is_disposed) this.show(fault, page, messages.split(copy).join(this.name));
        done();
      });
    });
    return this.run;
  }

  // While the document has errors, the last page stays.
  show(fault, page, messages) {
    this.panel.title = fault ? `${this.name}: errors` : this.name;
    if (!fault) {
      this.has_page = true;
      this.panel.webview.html = fs.readFileSync(page, 'utf8');
    } else if (!this.has_page) {
      this.panel.webview.html = `<pre>${escaped(messages || not_started(this.program, fault))}</pre>`;
    }
  }

  changed() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.render(), kDelay);
  }

  dispose() {
    this.is_disposed = true;
    clearTimeout(this.timer);
    previews.delete(this.document.fileName);
    fs.rmSync(this.folder, { recursive: true, force: true });
  }
}

// Shows the robot of the active editor. A second call brings its page to the front.
function show(program, imports) {
  const editor = vscode.window.activeTextEditor;
  if (!editor) return undefined;
  const { document } = editor;
  const known = previews.get(document.fileName);
  if (known) {
    known.panel.reveal();
    return known.run;
  }
  const preview = new Preview(document, program, imports);
  previews.set(document.fileName, preview);
  return preview.render();
}

function changed(document) {
  const preview = previews.get(document.fileName);
  if (preview) preview.changed();
}

function close_all() {
  for (const preview of [...previews.values()]) preview.panel.dispose();
}

module.exports = { show, changed, close_all, not_started };
