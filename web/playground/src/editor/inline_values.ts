// What stands behind the lines of the program: what each thread made in a line when it executed the line
// last, and the units of the arguments of commands.
// Tested by test/inline_values.test.ts.

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, WidgetType } from "@codemirror/view";
import type { Hint, LineWrites } from "@oncard/engine";

/** Behind a line of the text, from 1 on. */
export type Beside = { line: number; text: string } & (
  | { kind: "unit" }
  | {
      kind: "made";
      thread: number;
      /** Of several threads each has its number. */
      isNumbered: boolean;
      /** By the statement before the present moment. */
      isNew: boolean;
    }
);

interface Shown {
  /** As `LineWrites` names it. */
  file: string;
  lines: readonly string[];
  /** The present moment. */
  moment: number;
}

/** In the order of the lines, and in a line of the threads. */
export function valuesBeside(written: readonly LineWrites[], shown: Shown): Beside[] {
  const isNumbered = new Set(written.map(({ thread }) => thread)).size > 1;
  const made = written.flatMap((each): Beside[] => {
    const { thread, line, moment } = each;
    const text = each.file === shown.file ? textOf(each, shown.lines[line - 1] ?? "") : "";
    const isNew = moment === shown.moment - 1;
    return text === "" ? [] : [{ line, text, kind: "made", thread, isNumbered, isNew }];
  });
  return made.sort((a, b) => a.line - b.line || threadOf(a) - threadOf(b));
}

function threadOf(beside: Beside): number {
  return beside.kind === "made" ? beside.thread : -1;
}

/** Without what stands in the line already, and what the translation of structured C needs for itself. */
function textOf({ values, result }: LineWrites, line: string): string {
  const names = new Set(line.match(/[A-Za-z_]\w*/g));
  const its = values.filter(({ name }) => names.has(/^\w+/.exec(name)?.[0] ?? ""));
  const said = line.replace(/\s+/g, "").split(";");
  const texts = its
    .filter(({ name, value }) => !said.includes(`${name}=${value}`))
    .map(({ name, value }) => `${name} = ${value}`);
  if (result !== undefined) texts.push(`→ ${result}`);
  return texts.join(", ");
}

/** Each unit of a line once. */
export function unitsBeside(hints: readonly Hint[]): Beside[] {
  const units = new Map<number, Set<string>>();
  for (const { line, unit } of hints) {
    if (unit === undefined) continue;
    units.set(line, (units.get(line) ?? new Set()).add(unit));
  }
  return [...units].map(([line, its]) => ({ line, text: [...its].join(", "), kind: "unit" }));
}

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
