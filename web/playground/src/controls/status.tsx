// The status line: what the card does, or why it has stopped, in words. What the clock says, too, is
// for those who listen.

import type { Stop } from "@oncard/engine";

import { type Notice, present, session } from "../session/bench.js";
import { lineOfCondition } from "../session/required.js";
import { keeps } from "../store/keep.js";
import { showWarnings } from "../store/layout.js";
import { source } from "../store/source.js";
import type { Texts } from "../texts/en.js";
import { texts } from "../texts/texts.js";

type Tone = "" | "good" | "bad";

/** Where a thread stands. */
function lineOf(thread: number): number {
  return present.state.value?.threads.find((each) => each.thread === thread)?.line ?? 0;
}

/** What does not hold, with its line in the scenario. */
function located({ status: t }: Texts, text: string): string {
  const { main = "", files = {} } = session.project.value ?? {};
  const line = lineOfCondition(text, files[main] ?? "");
  return line === undefined ? text : t.atLine(text, main, line);
}

function stopText(all: Texts, stop: Stop): [string, Tone] {
  const { status: t } = all;
  const { thread = 0, text = "", failed = [] } = stop;
  switch (stop.reason) {
    case "end": {
      const over = present.state.value?.over;
      if (failed.length > 0)
        return [t.failed(failed.map((each) => located(all, each)).join("; ")), "bad"];
      if (over === "deadlock") return [t.deadlock, "bad"];
      if (over === "host-end") return [t.hostEnd, "good"];
      return [over === "time-limit" ? t.finishedLimit : t.finished, "good"];
    }
    case "fault":
      return [t.fault(thread, text), "bad"];
    case "refusal":
      return [t.refusal(thread, text), "bad"];
    case "requirement":
      return [t.requirement(located(all, text)), "bad"];
    case "line":
      return [t.breakpoint(thread, lineOf(thread)), ""];
    case "deviation":
      return [t.deviation(text), "bad"];
    case "schedule-end":
      return [t.scheduleEnd, ""];
    case "start":
      return [t.start, ""];
    case "budget":
      return [t.budget, ""];
    default:
      return [t.stoppedAt, ""];
  }
}

function noticeText(all: Texts, notice: Notice): [string, Tone] {
  const { status: t } = all;
  switch (notice.kind) {
    case "starting":
      return [t.starting, ""];
    case "fetching":
      return [t.fetching, ""];
    case "ready":
      return [t.ready, ""];
    case "running":
      return [t.running, ""];
    case "stopped":
      return stopText(all, notice.stop);
    case "not-compiled":
      return [present.state.value ? t.keptBefore : t.notCompiled, "bad"];
    case "not-loaded":
    case "refused":
      return [notice.message, "bad"];
    case "engine-ended":
      return [t.engineEnded(notice.message), "bad"];
    case "no-engine":
      return [t.noEngine(notice.message), "bad"];
    case "no-records":
      return [t.noRecords(notice.message), "bad"];
  }
}

/** The clock has a word for it, and there is no more to say. */
function isInClock({ kind }: Notice, tone: Tone): boolean {
  return ["starting", "ready", "running"].includes(kind) || tone === "good";
}

export function StatusLine() {
  const { status: t } = texts.value;
  const [text, tone] = noticeText(texts.value, session.notice.value);
  const state = present.state.value;
  const warnings = state?.warnings.length ?? 0;
  const isSaid = isInClock(session.notice.value, tone);
  return (
    <div class="status">
      <span
        class={`status-text ${tone} ${isSaid ? "visually-hidden" : ""}`}
        role="status"
        aria-live="polite"
      >
        {text}
      </span>
      <span aria-live="polite">
        {warnings > 0 && (
          <button type="button" class="tag warning" onClick={showWarnings}>
            {t.warnings(warnings)}
          </button>
        )}
      </span>
      {session.choice.value !== "" && <span class="tag">{t.choice(session.choice.value)}</span>}
      {state?.follows_schedule && <span class="tag">{t.follows}</span>}
      {source.isElsewhere.value && <span class="tag warning">{t.elsewhere}</span>}
      {!keeps.value && <span class="tag bad">{t.notKept}</span>}
    </div>
  );
}
