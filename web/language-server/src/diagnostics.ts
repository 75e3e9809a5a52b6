// Keeps the diagnostics of an editor true while its documents change. Checks wait until the user
// pauses, and one that is overtaken by a change shows nothing.
// Tested by test/diagnostics.test.ts.

import type { Diagnostic } from "vscode-languageserver";

import type { Findings } from "./checker.js";
import { pathOf, uriOf } from "./paths.js";

/** So long after the last change of a document. */
export const pauseMs = 80;

/** Checks a document; nothing if it is none of ours. */
export type Check = (uri: string) => Promise<Findings | undefined>;
export type Publish = (uri: string, diagnostics: Diagnostic[]) => void;

export class Diagnostics {
  readonly #check: Check;
  readonly #publish: Publish;
  readonly #timers = new Map<string, NodeJS.Timeout>();
  /** How often each document was to be checked: an older check than the last shows nothing. */
  readonly #wishes = new Map<string, number>();
  /** What was found by checking each open document. */
  readonly #found = new Map<string, Findings>();

  constructor(check: Check, publish: Publish) {
    this.#check = check;
    this.#publish = publish;
  }

  /** A document has changed. */
  changed(uri: string): void {
    clearTimeout(this.#timers.get(uri));
    this.#timers.set(
      uri,
      setTimeout(() => void this.checkNow(uri), pauseMs),
    );
  }

  async checkNow(uri: string): Promise<void> {
    clearTimeout(this.#timers.get(uri));
    const wish = (this.#wishes.get(uri) ?? 0) + 1;
    this.#wishes.set(uri, wish);
    const findings = await this.#check(uri);
    if (this.#wishes.get(uri) === wish) this.#replace(uri, findings);
  }

  closed(uri: string): void {
    clearTimeout(this.#timers.get(uri));
    this.#timers.delete(uri);
    this.#wishes.delete(uri);
    this.#replace(uri, undefined);
  }

  /** What is shown in a document: each thing once, whoever found it. */
  shown(uri: string): Diagnostic[] {
    const path = pathOf(uri);
    const all = [...this.#found.values()].flatMap((findings) => findings.get(path) ?? []);
    return [...new Map(all.map((each) => [JSON.stringify(each), each])).values()];
  }

  #replace(uri: string, findings: Findings | undefined): void {
    const touched = new Set([...(this.#found.get(uri)?.keys() ?? []), ...(findings?.keys() ?? [])]);
    if (findings) this.#found.set(uri, findings);
    else this.#found.delete(uri);
    for (const path of touched) {
      const target = uriOf(path);
      this.#publish(target, this.shown(target));
    }
  }
}
