// What the card's supervisor warns of, each warning once: going back and forward again does not
// repeat it. Tested by test/warnings.test.ts.

import type { CardWarning } from "@oncard/engine";

import type { Editor } from "./editor.js";
import type { Launched } from "./launched.js";

export class Warnings {
  readonly #shown = new Set<string>();

  /** Shows those of the present state that have not been shown. */
  show({ state, code }: Launched, editor: Editor): void {
    const sites = new Map<string, number>();
    for (const warning of state.warnings) {
      // A place can have several of one name, for several axes; their texts can change.
      const site = siteOf(warning);
      const count = (sites.get(site) ?? 0) + 1;
      sites.set(site, count);
      const key = `${count} ${site}`;
      if (this.#shown.has(key)) continue;
      this.#shown.add(key);
      editor.showWarning(warning, code.source(warning.file ?? ""));
    }
  }
}

function siteOf({ name, thread, file, line, call }: CardWarning): string {
  return JSON.stringify([name, thread, file, line, call]);
}
