// The breakpoints of a text, beside its lines. They move with the lines while the text is edited.
// Tested by test/breakpoints.test.ts.

import {
  type EditorState,
  type Extension,
  RangeSet,
  StateEffect,
  StateField,
} from "@codemirror/state";
import {
  type BlockInfo,
  type EditorView,
  gutter,
  GutterMarker,
  lineNumbers,
} from "@codemirror/view";

class Marker extends GutterMarker {
  override toDOM(): Node {
    const element = document.createElement("span");
    element.className = "cm-breakpoint";
    element.textContent = "\u25cf";
    return element;
  }
}

const marker = new Marker();

/** Replaces them; lines that the text does not have are left out. */
export const setBreakpoints = StateEffect.define<readonly number[]>();

const field = StateField.define<RangeSet<GutterMarker>>({
  create: () => RangeSet.empty,
  update(value, { changes, effects, state }) {
    let next = value.map(changes);
    for (const effect of effects) {
      if (!effect.is(setBreakpoints)) continue;
      const { doc } = state;
      const lines = effect.value.filter((line) => line >= 1 && line <= doc.lines);
      next = RangeSet.of(
        lines.map((line) => marker.range(doc.line(line).from)),
        true,
      );
    }
    return next;
  },
});

/** The lines with a breakpoint, each once, in their order. */
export function breakpointLines(state: EditorState): number[] {
  const lines = new Set<number>();
  const at = state.field(field).iter();
  while (at.value) {
    lines.add(state.doc.lineAt(at.from).number);
    at.next();
  }
  return [...lines];
}

/** With the numbers of the lines. @param onClick beside a line, or at its number */
export function breakpointGutter(onClick: (line: number) => void): Extension {
  const domEventHandlers = {
    mousedown: (view: EditorView, block: BlockInfo) => {
      onClick(view.state.doc.lineAt(block.from).number);
      return true;
    },
  };
  return [
    field,
    gutter({
      class: "cm-breakpoints",
      markers: (view) => view.state.field(field),
      initialSpacer: () => marker,
      // Each shows under the pointer that it can have one.
      renderEmptyElements: true,
      domEventHandlers,
    }),
    lineNumbers({ domEventHandlers }),
  ];
}
