// Panels beside the editor, and the page in one: a program and its style sheet, which build.mjs makes
// of view/.

import { join } from "node:path";

import { Uri, ViewColumn, type Webview, type WebviewPanel, window } from "vscode";

import { language } from "./texts";

/** A panel with one of the pages in the folder. */
export function openView(folder: string, view: string, title = ""): WebviewPanel {
  const root = Uri.file(folder);
  const panel = window.createWebviewPanel(
    `oncard.${view}`,
    title,
    { viewColumn: ViewColumn.Beside, preserveFocus: true },
    { enableScripts: true, localResourceRoots: [root] },
  );
  panel.webview.html = viewPage(panel.webview, root, view);
  return panel;
}

/** It may load what is in the folder alone. */
function viewPage(webview: Webview, folder: Uri, view: string): string {
  const at = (name: string) => webview.asWebviewUri(Uri.file(join(folder.fsPath, name))).toString();
  return `<!doctype html>
<html lang="${language()}">
  <head>
    <meta charset="utf-8" />
    <meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src ${webview.cspSource}; style-src ${webview.cspSource}" />
    <link rel="stylesheet" href="${at(`${view}.css`)}" />
  </head>
  <body>
    <main></main>
    <script src="${at(`${view}.js`)}"></script>
  </body>
</html>
`;
}
