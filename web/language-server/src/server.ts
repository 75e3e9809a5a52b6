#!/usr/bin/env node
// The language server on its standard streams (`--stdio`), or however the editor that starts it says.

import { createConnection, ProposedFeatures } from "vscode-languageserver/node.js";

import { openEngine } from "./engines.js";
import { LanguageServer } from "./language_server.js";

const program = process.argv[1] ?? "";
if (!process.argv.some((each) => /^--(?:stdio|node-ipc|pipe|socket)/.test(each))) {
  process.argv.push("--stdio");
}
new LanguageServer(createConnection(ProposedFeatures.all), () =>
  openEngine(process.env, program),
).listen();
