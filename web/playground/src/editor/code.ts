// The editor of one text: CodeMirror with the language C, underlined messages, and marked lines.
// It stands in a shadow root, where its styles need no exception in the page's security policy.

import { closeBrackets, closeBracketsKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import {
  bracketMatching,
  HighlightStyle,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from "@codemirror/language";
import { type Diagnostic as Underlined, lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState, StateEffect, StateField } from "@codemirror/state";
import {
  Decoration,
  type DecorationSet,
  drawSelection,
  EditorView,
  highlightActiveLine,
  keymap,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";

import type { Beside } from "./beside.js";
import { breakpointGutter, breakpointLines, setBreakpoints } from "./breakpoints.js";
import { type Complete, completions } from "./completions.js";
import { type Describe, descriptions } from "./descriptions.js";
import { inlineValues, setBeside } from "./inline_values.js";
import { motionProgram } from "./motion_program.js";

/** Lines that are marked, by their class. */
export type MarkedLines = { line: number; class: string }[];

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--code-comment)" },
  { tag: [tags.keyword, tags.processingInstruction], color: "var(--code-keyword)" },
  { tag: tags.typeName, color: "var(--code-type)" },
  { tag: tags.literal, color: "var(--code-number)" },
  { tag: tags.labelName, color: "var(--code-label)" },
]);

/** The line that a thread executes next has its colours; those of the page are not seen in here. */
function threadColours(): Record<string, Record<string, string>> {
  const all = Array.from({ length: 8 }, (_, index) => index);
  return Object.fromEntries(
    all.map((index) => [
      `.t${index}`,
      { "--thread": `var(--t${index})`, "--wash": `var(--w${index})` },
    ]),
  );
}

const look = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--surface)" },
  ".cm-scroller": { fontFamily: "var(--mono)", fontSize: "13px", lineHeight: "21px" },
  "&.cm-focused": { outline: "2px solid var(--focus)", outlineOffset: "-2px" },
  ".cm-content": { caretColor: "var(--ink)", padding: "6px 0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": {
    backgroundColor: "var(--surface)",
    color: "var(--muted)",
    border: "none",
  },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--well)" },
  ".cm-selectionBackground, &.cm-focused .cm-selectionBackground": {
    background: "var(--selection) !important",
  },
  ".cm-next": {
    backgroundColor: "var(--wash, var(--raised)) !important",
    boxShadow: "inset 3px 0 var(--thread)",
  },
  ...threadColours(),
  ".cm-linked, .cm-pointed": { backgroundColor: "var(--raised)" },
  ".cm-tooltip": {
    backgroundColor: "var(--raised)",
    color: "var(--ink)",
    border: "1px solid var(--edge)",
  },
  ".cm-panels": { backgroundColor: "var(--raised)", color: "var(--ink)" },
  ".cm-breakpoints .cm-gutterElement": { minWidth: "24px", textAlign: "center" },
  ".cm-breakpoints .cm-gutterElement, .cm-lineNumbers .cm-gutterElement": { cursor: "pointer" },
  ".cm-breakpoint": { color: "var(--bad)", display: "block", textAlign: "center" },
  ".cm-breakpoints .cm-gutterElement:empty:hover::before": {
    content: "'\\25cf'",
    color: "var(--bad)",
    opacity: "0.4",
  },
  ".cm-description": { maxWidth: "34em", maxHeight: "18em", overflow: "auto", padding: "2px 10px" },
  ".cm-description p, .cm-description pre": { margin: "6px 0" },
  ".cm-description pre": { whiteSpace: "pre-wrap" },
  ".cm-description td, .cm-description th": { padding: "1px 8px 1px 0", textAlign: "left" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { fontFamily: "var(--mono)", fontSize: "13px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li": { padding: "2px 8px", lineHeight: "20px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": {
    backgroundColor: "var(--ink)",
    color: "var(--on-ink)",
  },
  ".cm-completionDetail": { color: "var(--muted)", fontStyle: "normal" },
  "li[aria-selected] .cm-completionDetail": { color: "inherit" },
  ".cm-lint-marker": { width: "0.8em", height: "0.8em" },
});

const setMarks = StateEffect.define<MarkedLines>();
const marks = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    let next = value.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (!effect.is(setMarks)) continue;
      const { doc } = transaction.state;
      const lines = effect.value.filter(({ line }) => line >= 1 && line <= doc.lines);
      next = Decoration.set(
        lines.map((mark) => Decoration.line({ class: mark.class }).range(doc.line(mark.line).from)),
        true,
      );
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Says which line the pointer is at. */
function pointedLine(say: (line: number | undefined) => void) {
  return EditorView.domEventHandlers({
    pointermove({ clientY }, view) {
      const height = clientY - view.documentTop;
      const { from, top, bottom } = view.lineBlockAtHeight(height);
      const isAtLine = top <= height && height < bottom;
      say(isAtLine ? view.state.doc.lineAt(from).number : undefined);
    },
    pointerleave() {
      say(undefined);
    },
  });
}

export class CodeEditor {
  readonly #view: EditorView;
  readonly #language = new Compartment();
  readonly #label = new Compartment();

  constructor(
    host: HTMLElement,
    private readonly on: {
      edit: (text: string) => void;
      line: (line: number) => void;
      /** The pointer is at another line, or at none. */
      point: (line: number | undefined) => void;
      /** A click beside a line. */
      toggle: (line: number) => void;
      /** The text before breakpoints was edited: their lines now. */
      moved: (lines: number[]) => void;
      describe: Describe;
      complete: Complete;
    },
  ) {
    const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
    this.#view = new EditorView({
      parent: root as unknown as HTMLElement,
      root,
      state: this.#state("", ""),
    });
  }

  #state(name: string, text: string): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        breakpointGutter((line) => {
          this.on.toggle(line);
        }),
        history(),
        drawSelection(),
        bracketMatching(),
        closeBrackets(),
        indentOnInput(),
        completions(this.on.complete),
        highlightActiveLine(),
        highlightSelectionMatches(),
        search({ top: true }),
        lintGutter(),
        marks,
        inlineValues,
        descriptions(this.on.describe),
        pointedLine(this.on.point),
        indentUnit.of("  "),
        look,
        syntaxHighlighting(colours),
        this.#language.of(name.endsWith(".c") ? motionProgram : []),
        this.#label.of([]),
        keymap.of([
          ...closeBracketsKeymap,
          ...defaultKeymap,
          ...searchKeymap,
          ...historyKeymap,
          indentWithTab,
        ]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) {
            this.on.edit(update.state.doc.toString());
            const [was, is] = [update.startState, update.state].map(breakpointLines);
            if (String(was) !== String(is)) this.on.moved(is ?? []);
          }
          if (update.selectionSet || update.docChanged) {
            const { main } = update.state.selection;
            this.on.line(update.state.doc.lineAt(main.head).number);
          }
        }),
      ],
    });
  }

  /** Shows another text; what was done to the one before can no longer be undone. */
  show(name: string, text: string): void {
    this.#view.setState(this.#state(name, text));
  }

  /** Replaces the text by one edit, which can be undone. */
  replace(text: string): void {
    if (text === this.text) return;
    const old = this.text;
    let begin = 0;
    while (begin < old.length && begin < text.length && old[begin] === text[begin]) ++begin;
    let end = 0;
    const most = Math.min(old.length, text.length) - begin;
    while (end < most && old[old.length - 1 - end] === text[text.length - 1 - end]) ++end;
    const insert = text.slice(begin, text.length - end);
    this.#view.dispatch({ changes: { from: begin, to: old.length - end, insert } });
  }

  label(text: string): void {
    const effects = this.#label.reconfigure(
      EditorView.contentAttributes.of({
        "aria-label": text,
        "aria-multiline": "true",
        tabindex: "0", // a text that scrolls is reached with the keyboard, and checkers see it
      }),
    );
    this.#view.dispatch({ effects });
  }

  underline(messages: Underlined[]): void {
    const { length } = this.#view.state.doc;
    const within = messages.map((each) => ({
      ...each,
      from: Math.min(each.from, length),
      to: Math.min(each.to, length),
    }));
    this.#view.dispatch(setDiagnostics(this.#view.state, within));
  }

  mark(lines: MarkedLines): void {
    this.#view.dispatch({ effects: setMarks.of(lines) });
  }

  beside(values: readonly Beside[]): void {
    this.#view.dispatch({ effects: setBeside.of(values) });
  }

  breakpoints(lines: readonly number[]): void {
    if (String(lines) === String(breakpointLines(this.#view.state))) return;
    this.#view.dispatch({ effects: setBreakpoints.of(lines) });
  }

  /** Puts the cursor at an index and shows it. */
  select(index: number, focus: boolean): void {
    const anchor = Math.min(index, this.#view.state.doc.length);
    this.#view.dispatch({ selection: { anchor }, scrollIntoView: true });
    if (focus) this.#view.focus();
  }

  /** Shows a line without moving the cursor. */
  reveal(line: number): void {
    const { doc } = this.#view.state;
    if (line < 1 || line > doc.lines) return;
    const effects = EditorView.scrollIntoView(doc.line(line).from, { y: "nearest", yMargin: 40 });
    this.#view.dispatch({ effects });
  }

  get text(): string {
    return this.#view.state.doc.toString();
  }

  destroy(): void {
    this.#view.destroy();
  }
}
