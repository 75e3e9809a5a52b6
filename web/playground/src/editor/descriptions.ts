// What a name or number in the text is: under the pointer, and at the cursor with F1.
// Tested by test/descriptions.test.ts.

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { type EditorView, hoverTooltip, keymap, showTooltip, type Tooltip } from "@codemirror/view";

/** HTML and the part of the text that it is about; nothing if there is nothing to say. */
export type Describe = (
  index: number,
) => Promise<{ from: number; to: number; html: string } | undefined>;

const setShown = StateEffect.define<Tooltip | null>();

/** The description at the cursor: it goes with the next edit or movement. */
const shown = StateField.define<Tooltip | null>({
  create: () => null,
  update(value, { docChanged, selection, effects }) {
    for (const effect of effects) if (effect.is(setShown)) return effect.value;
    return docChanged || selection ? null : value;
  },
  provide: (field) => showTooltip.from(field),
});

export function descriptions(describe: Describe): Extension {
  const tooltipAt = async (index: number, announced: boolean): Promise<Tooltip | null> => {
    const found = await describe(index);
    if (!found) return null;
    const { from, to, html } = found;
    return { pos: from, end: to, above: true, create: () => ({ dom: elementOf(html, announced) }) };
  };
  const showAtCursor = (view: EditorView) => {
    const { state } = view;
    void tooltipAt(state.selection.main.head, true).then((tooltip) => {
      // The text or the cursor is another one meanwhile.
      const { doc, selection } = view.state;
      if (!doc.eq(state.doc) || !selection.eq(state.selection)) return;
      view.dispatch({ effects: setShown.of(tooltip) });
    });
    return true;
  };
  const hide = (view: EditorView) => {
    if (!view.state.field(shown)) return false;
    view.dispatch({ effects: setShown.of(null) });
    return true;
  };
  return [
    shown,
    hoverTooltip((_, index) => tooltipAt(index, false)),
    keymap.of([
      { key: "F1", run: showAtCursor },
      { key: "Escape", run: hide },
    ]),
  ];
}

/** @param announced screen readers say it: nobody has pointed at it */
function elementOf(html: string, announced: boolean): HTMLElement {
  const element = document.createElement("div");
  element.className = "cm-description";
  element.setAttribute("role", announced ? "status" : "tooltip");
  element.innerHTML = html;
  return element;
}
