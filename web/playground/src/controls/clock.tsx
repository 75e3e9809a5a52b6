// The clock of the card: its time, what it does in a word, and the moment.

import { type Notice, present, session } from "../session/bench.js";
import { isEdited } from "../session/on_card.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";

type Word = "empty" | "ready" | "edited" | "running" | "stopped" | "ended" | "failed";

function wordOf(notice: Notice): Word {
  if (!present.state.value) return "empty";
  if (notice.kind === "running") return "running";
  // Said here: a line that comes and goes while somebody types would move the whole page.
  if (isEdited.value) return "edited";
  if (notice.kind !== "stopped") return "ready";
  const { reason, failed = [] } = notice.stop;
  if (["fault", "refusal", "requirement", "deviation"].includes(reason)) return "failed";
  if (reason !== "end") return "stopped";
  return failed.length > 0 || present.state.value.over === "deadlock" ? "failed" : "ended";
}

/** Of its lamp: lit at a moment of a run, red where that has ended badly. */
function lampOf(word: Word): string {
  if (word === "failed") return "bad";
  return word === "running" || word === "stopped" ? "now" : "";
}

export function Clock() {
  const { clock: t } = texts.value;
  const word = wordOf(session.notice.value);
  const state = present.state.value;
  return (
    <output class="clock" aria-live="off">
      <span class={`lamp-point ${lampOf(word)}`} aria-hidden="true" />
      <span>
        <strong>
          {number(state?.time_ms ?? 0)} <small>ms</small>
        </strong>
        <span class="clock-word" title={word === "edited" ? t.edited : undefined}>
          {t.words[word]}
          {state && <span class="clock-moment"> · {t.moment(state.moment, state.head)}</span>}
        </span>
      </span>
    </output>
  );
}
