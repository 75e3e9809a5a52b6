// Values and units behind the lines, in the editor of the page.
// Tested by e2e/inline_values.spec.ts.

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, WidgetType } from "@codemirror/view";

import type { Beside } from "./beside.js";

class BesideWidget extends WidgetType {
  constructor(private readonly beside: Beside) {
    super();
  }

  override eq({ beside }: BesideWidget): boolean {
    return JSON.stringify(beside) === JSON.stringify(this.beside);
  }

  toDOM(): HTMLElement {
    const element = document.createElement("span");
    element.className = this.#classes().join(" ");
    // Drawn by the style: it is no part of the text that is read, searched and copied.
    const { beside } = this;
    element.dataset["text"] = beside.text;
    if (beside.kind === "made" && beside.isNumbered) element.dataset["thread"] = `${beside.thread}`;
    // The values panel has the variables, and the words at a name its units.
    element.setAttribute("aria-hidden", "true");
    return element;
  }

  #classes(): string[] {
    if (this.beside.kind === "unit") return ["cm-unit"];
    const { thread, isNew } = this.beside;
    return ["cm-made", `t${thread % 8}`, ...(isNew ? ["cm-made-now"] : [])];
  }
}

/** What stands behind the lines from now on. */
export const setBeside = StateEffect.define<readonly Beside[]>();

/** It goes with its line through edits. */
const besides = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, { state, changes, effects }) {
    let next = value.map(changes);
    for (const effect of effects) {
      if (!effect.is(setBeside)) continue;
      const { doc } = state;
      const within = effect.value.filter(({ line }) => line >= 1 && line <= doc.lines);
      next = Decoration.set(
        within.map((each) =>
          Decoration.widget({ widget: new BesideWidget(each), side: 1 }).range(
            doc.line(each.line).to,
          ),
        ),
        true,
      );
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

export const inlineValues: Extension = [
  besides,
  EditorView.theme({
    ".cm-made, .cm-unit": {
      marginLeft: "16px",
      padding: "1px 6px",
      borderRadius: "4px",
      fontSize: "12px",
      lineHeight: "17px",
    },
    ".cm-made::after, .cm-unit::after": { content: "attr(data-text)" },
    ".cm-made[data-thread]::before": {
      content: "attr(data-thread)",
      marginRight: "4px",
      padding: "0 4px",
      borderRadius: "4px",
      color: "var(--surface)",
      backgroundColor: "var(--thread)",
      fontWeight: "700",
    },
    ".cm-made": { color: "var(--thread)", backgroundColor: "var(--wash)" },
    ".cm-unit": { color: "var(--muted)" },
    "@keyframes cm-made-now": { from: { backgroundColor: "var(--now-wash)" } },
    "@media (prefers-reduced-motion: no-preference)": {
      ".cm-made-now": { animation: "cm-made-now 600ms ease-out" },
    },
  }),
];
