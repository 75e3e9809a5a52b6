// What the reader can do with the card, and the keys for it: buttons and keys do the same.

import { openColumnOf, reveal } from "../frame/current.js";
import { focusPanel } from "../frame/focus.js";
import { failingRun } from "../interleaving/failing_run.js";
import { checkTask, explore } from "../lesson/checks.js";
import { showVerdict } from "../lesson/verdict.js";
import { bench, session } from "../session/bench.js";
import { isEdited, ready, toggleBreakpoint } from "../session/on_card.js";
import { record } from "../session/record.js";
import { layout, showPanel, showRun } from "../store/layout.js";
import { changeSpeed } from "../store/settings.js";

async function whenReady(action: () => Promise<void>): Promise<void> {
  if (await ready()) await action();
}

/** Checks or explores. The lesson says what is found, and beside it stands a failing run. */
async function judge(task: () => Promise<void>): Promise<void> {
  const judged = task();
  // The failing run of before has gone by now, and its layout with it.
  showPanel("lesson");
  reveal("lesson");
  await judged;
  openColumnOf("lesson");
  if (failingRun.peek()) reveal("interleaving");
  showVerdict();
}

export const actions = {
  run: () => {
    const isRunning = session.running.peek() && session.notice.peek().kind === "running";
    if (isRunning && !isEdited.peek()) bench.pause();
    else {
      void whenReady(() => {
        showRun();
        return bench.run();
      });
    }
  },
  start: () => void whenReady(() => bench.goTo({ moment: 0 })),
  step: () => void whenReady(() => bench.stepStatement()),
  back: () => void whenReady(() => bench.stepBack()),
  cycle: () => void whenReady(() => bench.cycle()),
  cycleBack: () => void whenReady(() => bench.cycleBack()),
  slower: () => {
    changeSpeed(-1);
  },
  faster: () => {
    changeSpeed(1);
  },
  explore: () => {
    if (record.peek()) return;
    void judge(explore).then(() => {
      if (failingRun.peek()) showPanel("interleaving");
    });
  },
  check: () => void judge(checkTask),
  breakpoint: () => {
    const line = layout.chosenLine.peek();
    if (line > 0) toggleBreakpoint(line);
  },
  nextPanel: () => {
    focusPanel(1);
  },
  previousPanel: () => {
    focusPanel(-1);
  },
};

export type Action = keyof typeof actions;

/** A key with what is held beside it. */
export interface Key {
  key: string;
  control?: boolean;
  shift?: boolean;
}

export const keys: Record<Action, Key> = {
  run: { key: "Enter", control: true },
  explore: { key: "Enter", control: true, shift: true },
  start: { key: "F4" },
  step: { key: "F8" },
  back: { key: "F8", shift: true },
  cycle: { key: "F9" },
  cycleBack: { key: "F9", shift: true },
  slower: { key: ",", control: true },
  faster: { key: ".", control: true },
  check: { key: "F7" },
  breakpoint: { key: "F8", control: true },
  nextPanel: { key: "F6" },
  previousPanel: { key: "F6", shift: true },
};

/** As keys are written: Ctrl+Enter. */
export function keyText(action: Action): string {
  const { key, control, shift } = keys[action];
  return [...(control ? ["Ctrl"] : []), ...(shift ? ["Shift"] : []), key].join("+");
}

/** As ARIA writes keys. */
export function ariaKeys(action: Action): string {
  return keyText(action).replace("Ctrl", "Control");
}

/** Listens to the keys, before the editor does. */
export function listenToKeys(): void {
  window.addEventListener(
    "keydown",
    (event) => {
      if (document.querySelector("dialog[open]")) return;
      const control = event.ctrlKey || event.metaKey;
      const found = Object.entries(keys).find(
        ([, { key, control: ctrl = false, shift = false }]) =>
          event.key === key && control === ctrl && event.shiftKey === shift && !event.altKey,
      );
      if (!found) return;
      event.preventDefault();
      event.stopPropagation();
      actions[found[0] as Action]();
    },
    { capture: true },
  );
}
