// What the compiler says of the source, whenever that has changed.

import { type Diagnostic, RefusedError } from "@oncard/engine";
import { effect, untracked } from "@preact/signals";

import { settings } from "../store/settings.js";
import { slice } from "../store/slice.js";
import { source } from "../store/source.js";
import { bench, present, session } from "./bench.js";
import { isEdited } from "./on_card.js";
import { forgetRecord, record } from "./record.js";

interface Messages {
  diagnostics: Diagnostic[];
  /** Why the project could not be checked, for example a mistake in the scenario. */
  complaint: string;
}

const [messages, change] = slice<Messages>({ diagnostics: [], complaint: "" });
export { messages };

/** So long, in ms, after the last edit the texts are checked. */
const pause = 150;
let timer: ReturnType<typeof setTimeout> | undefined;

/** An edit is loaded before the card has begun, and when the reader has tried to run one. */
function isWanted(): boolean {
  const { kind } = session.notice.peek();
  const { moment = 0 } = present.state.peek() ?? {};
  return moment === 0 || kind === "not-compiled" || kind === "not-loaded";
}

/** Checks the texts. What is opened is loaded, and what is edited as soon as it compiles. */
async function checkNow(onLoaded?: () => void): Promise<void> {
  clearTimeout(timer);
  const checked = source.project.peek();
  try {
    const { compiled, diagnostics } = await bench.check(checked);
    if (checked !== source.project.peek()) return;
    change({ diagnostics, complaint: "" });
    if (present.state.peek() && !isEdited.peek()) return;
    if (onLoaded) {
      if (await bench.load(checked)) onLoaded();
    } else if (!record.peek() && compiled && isWanted()) await bench.loadEdited(checked);
  } catch (error) {
    if (checked !== source.project.peek()) return;
    const complaint = error instanceof Error ? error.message : String(error);
    change({ diagnostics: [], complaint });
    // The card shall not go on with another program.
    if (onLoaded && error instanceof RefusedError) await bench.load(checked);
  }
}

/**
 * What is opened is checked at once, what is edited after a pause.
 * @param onLoaded what was opened is on the card
 */
export function followSource(onLoaded: () => void = () => undefined): void {
  let opened: number | undefined;
  effect(() => {
    source.project.value; // eslint-disable-line @typescript-eslint/no-unused-expressions
    const isOpening = source.opened.value !== opened;
    opened = source.opened.value;
    untracked(() => {
      clearTimeout(timer);
      if (isOpening) {
        forgetRecord();
        bench.wishStops([]);
        void checkNow(onLoaded);
      } else {
        timer = setTimeout(() => void checkNow(), pause);
      }
    });
  });
}

/** Says everything again in the language that is chosen. */
export function followLanguage(): void {
  let spoken = settings.language.peek();
  effect(() => {
    const { value } = settings.language;
    if (value === spoken) return;
    spoken = value;
    void bench.speak().then(() => checkNow());
  });
}
