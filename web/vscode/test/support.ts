// The extension as the editor has it: packed, unpacked, with nothing else.

import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { unzipSync } from "fflate";
import { onTestFinished } from "vitest";

import { wasm } from "../../engine/test/support.js";
import { editor } from "./fake_vscode.js";

export { oncard, sample, withoutModule } from "../../engine/test/support.js";

export const folder = fileURLToPath(new URL("..", import.meta.url));

/** A new folder; it disappears with the test. */
export function newFolder(): string {
  const path = mkdtempSync(join(tmpdir(), "oncard-"));
  onTestFinished(() => {
    rmSync(path, { recursive: true });
  });
  return path;
}

/** Builds the package; gives its path. */
export function packed(into: string): string {
  const target = join(into, "oncard.vsix");
  const { status, stderr } = spawnSync(
    process.execPath,
    [join(folder, "build.mjs"), wasm, target],
    {
      encoding: "utf8",
    },
  );
  if (status !== 0 || !existsSync(target)) throw new Error(stderr);
  return target;
}

export function filesIn(vsix: string): Record<string, Uint8Array> {
  return unzipSync(readFileSync(vsix));
}

/** The settings and the environment of a computer without the command. */
export function withoutCommand(): void {
  const path = process.env["PATH"];
  process.env["PATH"] = "/nowhere";
  onTestFinished(() => {
    process.env["PATH"] = path;
  });
}

/** The manifest of the extension. */
export interface Manifest {
  contributes: {
    commands: { command: string; title: string }[];
    menus: Record<string, { command: string }[]>;
    taskDefinitions: { properties: { command: { enum: string[] } } }[];
    problemMatchers: { name: string; pattern: { regexp: string } & Record<string, number> }[];
    configuration: { properties: Record<string, { default: unknown }> };
    snippets: { language: string; path: string }[];
    debuggers: {
      type: string;
      configurationAttributes: {
        launch: { properties: Record<string, unknown> };
        attach: { properties: Record<string, unknown> };
      };
    }[];
    grammars: { scopeName: string; path: string }[];
  };
}

export const manifest = JSON.parse(readFileSync(join(folder, "package.json"), "utf8")) as Manifest;

/** A provider that the extension has registered; the caller knows its type. */
// eslint-disable-next-line @typescript-eslint/no-unnecessary-type-parameters
export function provider<Type>(kind: string): Type {
  const found = editor.providers.get(kind);
  if (found === undefined) throw new Error(`there is no provider of ${kind}`);
  return found as Type;
}
