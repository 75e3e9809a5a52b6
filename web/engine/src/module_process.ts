#!/usr/bin/env node
// The module in a process of its own: requests on standard input, answers on standard output, as
// `oncard debug --stdio` has them. It has no files: its client reads those that it lacks.
//   module_process.js MODULE
// Tested by test/module_process.test.ts.

import { readFileSync } from "node:fs";
import { StringDecoder } from "node:string_decoder";

import { EngineModule, ModuleError } from "../engine_module.js";

/** As for `oncard`: the end of memory. */
const exitExhausted = 6;

async function main(): Promise<void> {
  const path = process.argv[2];
  if (path === undefined) throw new Error("the path of the module is missing");
  const module = await EngineModule.create(readFileSync(path));
  const decoder = new StringDecoder("utf8");
  let begun = "";
  process.stdin.on("data", (data: Buffer) => {
    const lines = (begun + decoder.write(data)).split("\n");
    begun = lines.pop() ?? "";
    for (const line of lines) if (line !== "") answer(module, line);
  });
}

function answer(module: EngineModule, line: string): void {
  try {
    process.stdout.write(module.handle(line));
  } catch (error) {
    if (!(error instanceof ModuleError)) throw error;
    // Its session is lost; whoever needs it starts a new process.
    process.stderr.write(`${error.message}\n`, () => process.exit(exitExhausted));
  }
}

void main();
