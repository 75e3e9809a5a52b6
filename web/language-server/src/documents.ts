// The documents of the editor and the files on disk as one: what is open counts as it is on the
// screen. And which of them oncard is for: an editor also has C files of hosts, and other TOML.
// Tested by test/documents.test.ts.

import { readdir } from "node:fs/promises";
import { posix } from "node:path";

import { textOnDisk } from "@oncard/engine/disk";

import { beside, normal, pathOf } from "./paths.js";

export { pathOf };

/** A document that is open. */
export interface OpenDocument {
  uri: string;
  languageId: string;
  getText(): string;
}

/** The language of a document that is a motion program because the user says so. */
export const programLanguage = "motion-program";

export type Kind = "program" | "scenario";

export class Documents {
  readonly #open: () => readonly OpenDocument[];

  /** @param open the documents that are open at the time */
  constructor(open: () => readonly OpenDocument[]) {
    this.#open = open;
  }

  /** The text of a file, as it is in the editor or on disk. */
  async text(path: string): Promise<string | undefined> {
    const wanted = normal(path);
    const open = this.#open().find(({ uri }) => pathOf(uri) === wanted);
    return open ? open.getText() : textOnDisk(wanted);
  }

  /** The texts of all open documents by their paths. */
  openTexts(): Record<string, string> {
    return Object.fromEntries(this.#open().map((each) => [pathOf(each.uri), each.getText()]));
  }

  /** What a document is to oncard; nothing if it is none of its business. */
  async kind(document: OpenDocument): Promise<Kind | undefined> {
    const path = pathOf(document.uri);
    if (path.endsWith(".toml")) {
      return programOf(document.getText()) === undefined ? undefined : "scenario";
    }
    if (document.languageId === programLanguage) return "program";
    if (!path.endsWith(".c")) return undefined;
    if (/^[ \t]*\/\/@[ \t]*[a-z]/m.test(document.getText())) return "program";
    return (await this.scenarioOf(path)) === undefined ? undefined : "program";
  }

  /** The first scenario that names a program: an open one, or one in its folder. */
  async scenarioOf(program: string): Promise<string | undefined> {
    const folder = posix.dirname(program);
    const open = this.#open().map(({ uri }) => pathOf(uri));
    const names = await readdir(folder).catch(() => [] as string[]);
    const there = names.map((name) => posix.join(folder, name));
    const scenarios = new Set([...there, ...open].filter((path) => path.endsWith(".toml")).sort());
    for (const scenario of scenarios) {
      const named = programOf((await this.text(scenario)) ?? "");
      if (named !== undefined && beside(scenario, named) === program) return scenario;
    }
    return undefined;
  }
}

/** Whether `oncard test` explores a scenario instead of running it. */
export function isExplored(scenario: string): boolean {
  const keys = scenario.split(/^[ \t]*\[/m)[0] ?? "";
  return /^[ \t]*explore\b/m.test(keys) || /^[ \t]*\[[ \t]*explore[ \t]*\]/m.test(scenario);
}

/** The program that a scenario names; a file that names none is no scenario for `oncard run`. */
export function programOf(scenario: string): string | undefined {
  const keys = scenario.split(/^[ \t]*\[/m)[0] ?? "";
  return /^[ \t]*program[ \t]*=[ \t]*(["'])([^"'\n]*\.(?:c|bin))\1/m.exec(keys)?.[2];
}
