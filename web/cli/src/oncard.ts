#!/usr/bin/env node
// The command `oncard` of the npm package: what the installed one does is done by the same code, in
// WebAssembly; `lsp` and `dap` are the servers for editors. Tested by test/package.test.ts.

import { readFileSync } from "node:fs";
import { isatty } from "node:tty";
import { fileURLToPath } from "node:url";
import { isMainThread } from "node:worker_threads";

import { type CommandLine, runCommand } from "./command.js";
import { runTests, TestRunner } from "./tests.js";

/** Exit codes, as `oncard --help` lists them. */
const exitInternal = 4;

const onWindows = process.platform === "win32";

function beside(name: string): string {
  return fileURLToPath(new URL(name, import.meta.url));
}

/** The present folder and arguments with `/`, which the command knows; variables that it reads. */
function commandLine(): CommandLine {
  const slashes = (text: string) => (onWindows ? text.replaceAll("\\", "/") : text);
  const environment: Record<string, string> = {};
  for (const [name, value] of Object.entries(process.env)) {
    if (value !== undefined) environment[name] = value;
  }
  environment["PWD"] = slashes(process.cwd());
  environment["ONCARD_TERMINAL_WIDTH"] = String(isatty(1) ? process.stdout.columns : 0);
  if (onWindows) {
    // Windows says neither in its environment.
    environment["LANG"] ??= Intl.DateTimeFormat().resolvedOptions().locale;
    environment["TERM"] ??= "windows";
  }
  return { args: process.argv.slice(2).map(slashes), environment };
}

function run(): number {
  const line = commandLine();
  const module = new WebAssembly.Module(readFileSync(beside("oncard-cli.wasm")));
  try {
    return runCommand(module, line, new TestRunner(module, line, new URL(import.meta.url)));
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError) && !(error instanceof RangeError)) throw error;
    process.stderr.write(`oncard: internal error: ${error.message}\n`);
    return exitInternal;
  }
}

async function main(): Promise<void> {
  const command = process.argv[2];
  if (command === "lsp" || command === "dap") {
    process.env["ONCARD_MODULE"] = beside("oncard.wasm");
    delete process.env["ONCARD"];
    process.argv.splice(2, 1);
    await (command === "lsp"
      ? import("@oncard/language-server/server")
      : import("@oncard/debug-adapter/adapter"));
    return;
  }
  process.exitCode = run();
}

if (isMainThread) {
  await main();
} else {
  runTests();
}
