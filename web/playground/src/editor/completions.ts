// The words that can stand at a place of the text: while a word is typed, and with Ctrl+Space.
// Tested by test/completions.test.ts.

import {
  autocompletion,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete";
import type { Extension } from "@codemirror/state";
import type { Candidate } from "@oncard/engine";

/** A candidate, with its documentation as HTML. */
export type Word = Omit<Candidate, "documentation"> & { html?: string };

/** The candidates, the most likely first, and the part of the text that they replace. */
export type Complete = (
  index: number,
) => Promise<{ from: number; to: number; words: Word[] } | undefined>;

/** A word or a member that has begun; nobody is asked elsewhere unless the reader wishes it. */
const begun = /[\w#&]$|\w\.$/;

export async function completionAt(
  context: Pick<CompletionContext, "state" | "pos" | "explicit">,
  complete: Complete,
): Promise<CompletionResult | null> {
  const { state, pos, explicit } = context;
  const line = state.doc.lineAt(pos);
  if (!explicit && !begun.test(line.text.slice(0, pos - line.from))) return null;
  const found = await complete(pos);
  if (!found || found.words.length === 0) return null;
  const { from, to, words } = found;
  return {
    from,
    to,
    validFor: /^\w*$/,
    options: words.map(({ label, detail, insert, html }, index) => ({
      label,
      apply: insert ?? label,
      // Among those that fit equally well, the order of the engine.
      boost: -Math.min(index, 99),
      ...(detail === undefined ? {} : { detail }),
      ...(html === undefined ? {} : { info: () => elementOf(html) }),
    })),
  };
}

export function completions(complete: Complete): Extension {
  return autocompletion({
    icons: false,
    override: [(context) => completionAt(context, complete)],
  });
}

function elementOf(html: string): HTMLElement {
  const element = document.createElement("div");
  element.className = "cm-description";
  element.innerHTML = html;
  return element;
}
