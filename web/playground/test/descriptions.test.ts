import { EditorState, type TransactionSpec } from "@codemirror/state";
import { type EditorView, keymap, showTooltip } from "@codemirror/view";
import { expect, test } from "vitest";

import { descriptions } from "../src/editor/descriptions.js";

const html = "<p>Sets the velocity.</p>";

/** An editor without a page. Its descriptions come when `answer` is called. */
function begin() {
  let answerNow: () => void = () => undefined;
  const asked = new Promise<void>((resolve) => (answerNow = resolve));
  const describe = async () => {
    await asked;
    return { from: 0, to: 3, html };
  };
  const view = {
    state: EditorState.create({ doc: "GT_SetVel(1, 10);\n", extensions: descriptions(describe) }),
    dispatch(...specs: TransactionSpec[]) {
      this.state = this.state.update(...specs).state;
    },
  };
  const press = (key: string) => {
    const bindings = view.state.facet(keymap).flat();
    bindings.find((binding) => binding.key === key)?.run?.(view as unknown as EditorView);
  };
  const answer = async () => {
    answerNow();
    await new Promise((resume) => setTimeout(resume, 0));
  };
  const shown = () => view.state.facet(showTooltip).filter((tooltip) => tooltip !== null).length;
  return { view, press, answer, shown };
}

test("F1 shows what is at the cursor until Escape", async () => {
  const { press, answer, shown } = begin();
  press("F1");
  await answer();
  expect(shown()).toBe(1);
  press("Escape");
  expect(shown()).toBe(0);
});

test("messages that come while the answer is on its way do not keep it away", async () => {
  const { view, press, answer, shown } = begin();
  press("F1");
  view.dispatch({});
  await answer();
  expect(shown()).toBe(1);
});

test("an answer about a text that was edited meanwhile is not shown", async () => {
  const { view, press, answer, shown } = begin();
  press("F1");
  view.dispatch({ changes: { from: 0, insert: "int x;\n" } });
  await answer();
  expect(shown()).toBe(0);
});

test("an answer about a place that the cursor has left is not shown", async () => {
  const { view, press, answer, shown } = begin();
  press("F1");
  view.dispatch({ selection: { anchor: 5 } });
  await answer();
  expect(shown()).toBe(0);
});
