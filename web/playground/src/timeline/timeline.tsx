// The timeline: a row for each thread, who ran, waited and faulted when, and a cursor that can be
// dragged.

import { type Executed, executedAt, type Thread, type Turn } from "@oncard/engine";
import { effect, signal } from "@preact/signals";
import { useRef } from "preact/hooks";

import { Tabs } from "../controls/tabs.js";
import { namedLayout } from "../frame/current.js";
import { rowOf, touchesShared } from "../interleaving/cells.js";
import { failingRun, isOnCard, useStepsOnCard } from "../interleaving/failing_run.js";
import { useAsked } from "../session/asked.js";
import { bench, present, session } from "../session/bench.js";
import { seek } from "../session/seeking.js";
import { chooseUnit, settings, type Unit, units } from "../store/settings.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import {
  type Bar,
  barsOf,
  following,
  type Mark,
  marksOf,
  momentAt,
  momentOf,
  readable,
  type ScaleMark,
  type Span,
  ticks,
  timeAt,
  type TimeAt,
  timesOf,
  withPresent,
  wholeRun,
  zoomed,
} from "./rows.js";

/** More turns than this are not asked for; the rest is marked as not shown. */
const mostTurns = 50_000;
/** The same for states of threads. */
const mostSpans = 20_000;

/** More threads than these have low rows, of which one is chosen. */
const mostHighRows = 8;
const chosen = signal(0);

/** Undefined: the whole run. */
const span = signal<Span | undefined>(undefined);

effect(() => {
  const { value: state } = present.state;
  const now = span.peek();
  if (!state || !now) return;
  span.value = following(now, state.moment, state.head);
});

export function TimelinePanel() {
  const { timeline: t } = texts.value;
  const { value: state } = present.state;
  if (!state) return <p class="muted empty">{t.none}</p>;
  const shown = span.value ?? wholeRun(state.head);
  return (
    <div class="timeline">
      <div class="bar">
        {state.threads.length > mostHighRows && <ChosenThread threads={state.threads} />}
        <div class="row end grow">
          {!isOnCard.value && (
            <Tabs
              label={t.unit}
              values={units}
              chosen={unitNow()}
              nameOf={(unit) => t.units[unit]}
              onChoose={chooseUnit}
            />
          )}
          <Zoom shown={shown} factor={0.5} label={t.zoomIn} text="+" />
          <Zoom shown={shown} factor={2} label={t.zoomOut} text="−" />
          <button
            type="button"
            class="quiet"
            aria-pressed={span.value === undefined}
            onClick={() => (span.value = undefined)}
          >
            {t.whole}
          </button>
        </div>
      </div>
      <Rows span={shown} />
      {state.head === 0 && <p class="muted small note">{t.none}</p>}
    </div>
  );
}

/** The unit that the reader has chosen; otherwise that of what the lesson is about. */
function unitNow(): Unit {
  const { value: layout } = namedLayout;
  const isOfStatements = layout === "language" || layout === "threads";
  return settings.unit.value ?? (isOfStatements ? "moments" : "ms");
}

/** So many turns say what the time is where not all of them are asked for, each found in so many moments. */
const mostSamples = 20;
const sampleLength = 2000;

/** Single turns behind a moment, up to the end of what is shown. */
async function samples(after: number, { to }: Span): Promise<Turn[]> {
  const engine = await bench.engine();
  const places = Array.from({ length: mostSamples }, (_, index) =>
    Math.round(after + (index / mostSamples) * (to - after)),
  );
  const found = await Promise.all(
    places.map((moment) => engine.turns(moment, moment + sampleLength, 1)),
  );
  return found.flat();
}

/** Of many threads the one that is chosen: its state, and its next statement. */
function ChosenThread({ threads }: { threads: Thread[] }) {
  const thread = threads.find((each) => each.thread === chosen.value) ?? threads[0];
  if (!thread) return null;
  return (
    <div class="chosen-thread" title={thread.status}>
      <ThreadName thread={thread} />
      <span class={`lane-state ${thread.state}`}>{stateOf(thread)}</span>
      <NextStatement thread={thread} />
    </div>
  );
}

function Zoom(props: { shown: Span; factor: number; label: string; text: string }) {
  const { shown, factor, label, text } = props;
  return (
    <button
      type="button"
      class="quiet"
      aria-label={label}
      title={label}
      onClick={() => {
        const { moment = 0, head = 0 } = present.state.value ?? {};
        span.value = zoomed(shown, factor, moment, head);
      }}
    >
      {text}
    </button>
  );
}

/** In a longer span the numbers of steps would have no room. */
const mostNumbers = 64;

/** A statement of the failing run, with its number there. */
interface Step extends Bar {
  step: number;
  isShared: boolean;
  isHit: boolean;
}

/** What the lanes show of the failing run: its steps in the span, and where it was lost. */
function stepsIn(
  { from, to }: Span,
  executed: readonly Executed[],
): { steps: Step[]; fatal?: number } {
  const failing = failingRun.peek()?.interleaving;
  if (!failing) return { steps: [] };
  const rows = [...failing.rows, ...(failing.cycle ?? [])];
  const fatalRow = rows.find((row) => row.kind === "step" && row.fatal === true);
  const fatal = fatalRow && "step" in fatalRow ? executed[fatalRow.step - 1] : undefined;
  const part = (moment: number) => (moment - from) / (to - from);
  const steps = executed.flatMap(({ thread, moment }, index): Step[] => {
    if (moment <= from || moment > to || to - from > mostNumbers) return [];
    const row = rowOf(rows, index + 1);
    return [
      {
        thread,
        from: part(moment - 1),
        to: part(moment),
        step: index + 1,
        isShared: row !== undefined && touchesShared(row),
        isHit: failing.stale?.read === index + 1 || failing.stale?.use === index + 1,
      },
    ];
  });
  return fatal && fatal.moment >= from && fatal.moment <= to
    ? { steps, fatal: part(fatal.moment) }
    : { steps };
}

function Rows({ span: shown }: { span: Span }) {
  const { timeline: t } = texts.value;
  const track = useRef<HTMLDivElement>(null);
  const state = present.state.value;
  const head = state?.head ?? 0;
  const moment = state?.moment ?? 0;
  const key = `${shown.from} ${shown.to} ${head} ${session.history.value}`;
  const nothing = { bars: [], marks: [], times: [], isCut: false };
  const { bars, marks, times, isCut } =
    useAsked(
      key,
      async () => {
        if (head === 0) return nothing;
        const engine = await bench.engine();
        const turns = await engine.turns(shown.from, Math.min(shown.to, head), mostTurns);
        const isLong = turns.length === mostTurns;
        // No further than what is shown of the turns: each moment costs time.
        const end = isLong ? (turns.at(-1)?.moment ?? head) : Math.min(shown.to, head);
        const spans = await engine.spans(shown.from, end, mostSpans);
        return {
          bars: barsOf(turns, shown),
          marks: marksOf(spans, shown),
          times: timesOf([...turns, ...(isLong ? await samples(end, shown) : [])], spans, shown),
          isCut: isLong || spans.length === mostSpans,
        };
      },
      session.running.value,
    ) ?? nothing;
  const executed = useStepsOnCard();
  const { steps, fatal } = stepsIn(shown, executed ?? []);
  const isMany = (state?.threads.length ?? 0) > mostHighRows;
  const unit = unitNow();
  const now = executed
    ? t.afterStep(executedAt(executed, moment))
    : unit === "ms"
      ? `${number(state?.time_ms ?? 0)} ms`
      : t.moment(moment);
  const cycleMs = state && state.cycle > 0 ? state.time_ms / state.cycle : 1;
  const scale = executed
    ? scaleOfSteps(shown, executed)
    : unit === "ms"
      ? scaleOfTime(shown, withPresent(times, { moment, ms: state?.time_ms ?? 0 }), cycleMs)
      : ticks(shown, 6).map((mark) => markAt(shown, mark, mark));
  const atCursor = (moment - shown.from) / (shown.to - shown.from);
  const atHead = Math.min(1, (head - shown.from) / (shown.to - shown.from));

  const drag = (event: PointerEvent) => {
    const box = track.current?.getBoundingClientRect();
    if (!box) return;
    seek(momentAt(shown, (event.clientX - box.left) / box.width, head));
  };
  return (
    <>
      <div class={`rows ${isMany ? "many" : ""}`} role="group" aria-label={t.label}>
        {isMany ? (
          <ThreadList threads={state?.threads ?? []} />
        ) : (
          <div class="row-heads">
            {state?.threads.map((thread) => (
              <RowHead key={thread.thread} thread={thread} />
            ))}
          </div>
        )}
        <div
          class="track"
          ref={track}
          onPointerDown={(event) => {
            event.currentTarget.setPointerCapture(event.pointerId);
            drag(event);
          }}
          onPointerMove={(event) => {
            if (event.currentTarget.hasPointerCapture(event.pointerId)) drag(event);
          }}
        >
          {state?.threads.map((thread) => (
            <Row
              key={thread.thread}
              thread={thread}
              bars={steps.length > 0 && !isMany ? [] : bars}
              marks={marks}
              steps={isMany ? [] : steps}
              head={atHead}
            />
          ))}
          {fatal !== undefined && (
            <div class="fatal-line" title={texts.value.interleaving.fatal} ref={placed(fatal)} />
          )}
          {steps.length === 0 && <Scale marks={readable(scale, pillAt(atCursor))} />}
          <div
            class="cursor"
            role="slider"
            tabIndex={0}
            aria-label={t.cursor}
            aria-valuemin={0}
            aria-valuemax={head}
            aria-valuenow={moment}
            aria-valuetext={t.position(moment, number(state?.time_ms ?? 0))}
            ref={(element) => {
              if (element) element.style.left = `${Math.min(1, Math.max(0, atCursor)) * 100}%`;
            }}
            onKeyDown={(event) => {
              const page = Math.max(1, Math.round((shown.to - shown.from) / 10));
              const steps: Record<string, number> = {
                ArrowLeft: moment - 1,
                ArrowRight: moment + 1,
                PageUp: moment - page,
                PageDown: moment + page,
                Home: 0,
                End: head,
              };
              const to = steps[event.key];
              if (to === undefined) return;
              event.preventDefault();
              seek(Math.min(head, Math.max(0, to)));
            }}
          >
            <span
              class={`now-pill ${atCursor > 0.9 ? "at-end" : atCursor < 0.1 ? "at-start" : ""}`}
              aria-hidden="true"
            >
              {now}
            </span>
          </div>
        </div>
      </div>
      {isCut && <p class="muted small note">{t.cut}</p>}
    </>
  );
}

function stateOf({ state, waits }: Thread): string {
  const { timeline: t } = texts.value;
  if (state === "faulted") return t.fault;
  if (state === "finished") return t.ended;
  return waits ? t.waits : "";
}

function ThreadName({ thread: { thread, function: name } }: { thread: Thread }) {
  return (
    <span class={`thread-name t${thread % 8}`}>
      {thread} {name}
    </span>
  );
}

function NextStatement({ thread: { thread, ready } }: { thread: Thread }) {
  const { timeline: t } = texts.value;
  return (
    <button
      type="button"
      class="quiet"
      disabled={!ready}
      aria-label={t.next(thread)}
      title={t.next(thread)}
      onClick={() => void bench.stepThread(thread)}
    >
      {t.nextShort}
    </button>
  );
}

function RowHead({ thread }: { thread: Thread }) {
  const state = stateOf(thread);
  return (
    <div class="row-head" title={thread.status}>
      <ThreadName thread={thread} />
      {state !== "" && <span class={`lane-state ${thread.state}`}>{state}</span>}
      <NextStatement thread={thread} />
    </div>
  );
}

/** The heads of low rows: one list, in which the pointer or the arrows choose. */
function ThreadList({ threads }: { threads: Thread[] }) {
  const { timeline: t } = texts.value;
  const at = Math.max(
    0,
    threads.findIndex(({ thread }) => thread === chosen.value),
  );
  const choose = (index: number) => {
    const thread = threads[Math.min(threads.length - 1, Math.max(0, index))];
    if (thread) chosen.value = thread.thread;
  };
  return (
    <div
      class="row-heads"
      role="listbox"
      tabIndex={0}
      aria-label={t.threads}
      aria-activedescendant={`thread-${threads[at]?.thread ?? 0}`}
      onKeyDown={(event) => {
        const steps: Record<string, number> = {
          ArrowUp: at - 1,
          ArrowDown: at + 1,
          Home: 0,
          End: threads.length,
        };
        const to = steps[event.key];
        if (to === undefined) return;
        event.preventDefault();
        choose(to);
      }}
    >
      {threads.map((thread, index) => (
        <div
          key={thread.thread}
          id={`thread-${thread.thread}`}
          role="option"
          aria-selected={index === at}
          class="row-head"
          title={thread.status}
          onClick={() => {
            choose(index);
          }}
        >
          <ThreadName thread={thread} />
          <span class={`lane-state ${thread.state}`}>{stateOf(thread)}</span>
        </div>
      ))}
    </div>
  );
}

/** Puts an element at a part of the track. */
function placed(from: number, to = from) {
  return (element: HTMLElement | null): void => {
    if (!element) return;
    element.style.left = `${from * 100}%`;
    if (to > from) element.style.width = `${(to - from) * 100}%`;
  };
}

function Row(props: { thread: Thread; bars: Bar[]; marks: Mark[]; steps: Step[]; head: number }) {
  const { thread, bars, marks, steps, head } = props;
  const isOwn = (each: Bar) => each.thread === thread.thread;
  const own = bars.filter(isOwn);
  const rests = marks.filter((mark) => isOwn(mark) && mark.kind !== "faulted");
  const faults = marks.filter((mark) => isOwn(mark) && mark.kind === "faulted");
  return (
    <div class={`lane t${thread.thread % 8}`}>
      <svg viewBox="0 0 1000 20" preserveAspectRatio="none">
        <line x1="0" x2={head * 1000} y1="10" y2="10" class="lane-line" />
        {rests.map((mark) => (
          <StateMark key={mark.from} mark={mark} />
        ))}
        {own.map((bar) => (
          <rect
            key={bar.from}
            x={bar.from * 1000}
            width={Math.max(1.5, (bar.to - bar.from) * 1000 - 0.5)}
            y="3"
            height="14"
            class="turn"
          />
        ))}
        {faults.map((mark) => (
          <StateMark key={mark.from} mark={mark} />
        ))}
      </svg>
      {steps.filter(isOwn).map(({ step, from, to, isShared, isHit }) => (
        <div
          key={step}
          class={`lane-step ${isShared ? "shared" : ""} ${isHit ? "hit" : ""}`}
          ref={placed(from, to)}
        >
          <span>{step}</span>
        </div>
      ))}
    </div>
  );
}

/** Of a thousand. A fault is marked before the moment after it, where the cursor then stands. */
const faultWidth = 12;

/** What a thread did when it did not run: a pale bar for a wait, a narrow one for a fault. */
function StateMark({ mark: { kind, from, to, of } }: { mark: Mark }) {
  const isFault = kind === "faulted";
  const x = Math.max(0, from * 1000 - (isFault ? faultWidth : 0));
  const name = titleOf(kind, of);
  return (
    <rect
      role="img"
      aria-label={name}
      x={x}
      width={isFault ? faultWidth : Math.max(1.5, (to - from) * 1000)}
      y={isFault ? 0 : 6}
      height={isFault ? 20 : 8}
      class={`mark ${kind}`}
    >
      <title>{name}</title>
    </rect>
  );
}

function titleOf(kind: Mark["kind"], of: Mark["of"]): string {
  const { timeline: t } = texts.value;
  if (!of) return kind === "waits" ? t.waits : t.paused;
  const { name, value, until_ms: until } = of.waits ?? {};
  const what =
    kind === "faulted"
      ? t.faulted(of.text ?? "")
      : kind === "paused"
        ? t.paused
        : until === undefined
          ? t.waitsFor(name ?? t.variable, value ?? 0)
          : t.waitsUntil(number(until));
  return t.atLine(of.line, what);
}

/** Where the number at the cursor is; it covers others of the scale. */
function pillAt(cursor: number): [number, number] {
  const width = 0.24;
  const from = cursor > 0.9 ? cursor - width : cursor < 0.1 ? cursor : cursor - width / 2;
  return [from, from + width];
}

function markAt({ from, to }: Span, moment: number, text: number): ScaleMark {
  return { at: (moment - from) / (to - from), text: String(text) };
}

function scaleOfTime(shown: Span, times: readonly TimeAt[], cycleMs: number): ScaleMark[] {
  const [from, to] = [shown.from, shown.to].map((moment) => timeAt(times, cycleMs, moment));
  const marks = ticks({ from: from ?? 0, to: to ?? 0 }, 6);
  return marks.map((ms) => markAt(shown, momentOf(times, cycleMs, ms), ms));
}

function scaleOfSteps(shown: Span, executed: readonly Executed[]): ScaleMark[] {
  const [from, to] = [shown.from, shown.to].map((moment) => executedAt(executed, moment));
  return ticks({ from: from ?? 0, to: to ?? 0 }, 6).flatMap((step) => {
    const { moment } = executed[step - 1] ?? {};
    return moment === undefined ? [] : [markAt(shown, moment, step)];
  });
}

function Scale({ marks }: { marks: ScaleMark[] }) {
  return (
    <div class="scale" aria-hidden="true">
      {marks.map(({ at, text }) => (
        <span key={text} ref={placed(at)}>
          {text}
        </span>
      ))}
    </div>
  );
}
