// The page in a panel: a program and its style sheet, which build.mjs makes of view/.

import { join } from "node:path";

import { Uri, type Webview } from "vscode";

import { language } from "./texts";

/** It may load what is in the folder alone. */
export function viewPage(webview: Webview, folder: Uri, view: string): string {
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
