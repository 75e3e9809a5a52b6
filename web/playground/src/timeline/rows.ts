// The part of a run that the timeline shows, and where its bars and the numbers of its scale are. Its
// lanes count moments: statements within a cycle, where no time passes, lie beside each other.
// Tested by test/rows.test.ts.

import type { ThreadSpan, Turn } from "@oncard/engine";

/** Moments from `from` to `to`. */
export interface Span {
  from: number;
  to: number;
}

const least = 20;

export function wholeRun(head: number): Span {
  return { from: 0, to: Math.max(least, head) };
}

/** Half or twice as much, around a moment that stays where it is. */
export function zoomed(span: Span, factor: number, around: number, head: number): Span {
  const whole = wholeRun(head);
  const length = Math.min(whole.to, Math.max(least, Math.round((span.to - span.from) * factor)));
  const part = (around - span.from) / (span.to - span.from);
  const from = Math.round(around - part * length);
  return moved({ from, to: from + length }, head);
}

/** The same length, within the run. */
export function moved({ from, to }: Span, head: number): Span {
  const whole = wholeRun(head);
  const length = Math.min(to - from, whole.to);
  const begin = Math.min(Math.max(0, from), whole.to - length);
  return { from: begin, to: begin + length };
}

/** The span with the moment in sight. */
export function following(span: Span, moment: number, head: number): Span {
  if (moment >= span.from && moment <= span.to) return moved(span, head);
  const length = span.to - span.from;
  const from =
    moment < span.from ? moment - Math.floor(length / 4) : moment - Math.ceil(length * 0.75);
  return moved({ from, to: from + length }, head);
}

export interface Bar {
  thread: number;
  /** From 0 to 1, in the span. */
  from: number;
  to: number;
}

/** Parts of the span that are closer than this become one. */
const together = 1 / 1500;

/** The bars of the turns, which are in their order. */
export function barsOf(turns: Turn[], { from, to }: Span): Bar[] {
  const part = (moment: number) => Math.min(1, Math.max(0, (moment - from) / (to - from)));
  const bars: Bar[] = [];
  const last = new Map<number, Bar>();
  for (const { moment, thread, statements } of turns) {
    if (moment + statements <= from || moment >= to) continue;
    const bar = { thread, from: part(moment), to: part(moment + statements) };
    const before = last.get(thread);
    if (before && bar.from - before.to < together && bar.to - bar.from < 4 * together) {
      before.to = bar.to;
    } else {
      bars.push(bar);
      last.set(thread, bar);
    }
  }
  return bars;
}

/** A time in which a thread does not run, or the place of its fault. */
export interface Mark extends Bar {
  kind: "waits" | "paused" | "faulted";
  /** What is to be said of it; missing for several that cannot be told apart. */
  of?: ThreadSpan;
}

/** The marks of the states, which are in their order. */
export function marksOf(spans: ThreadSpan[], { from, to }: Span): Mark[] {
  const part = (moment: number) => Math.min(1, Math.max(0, (moment - from) / (to - from)));
  const marks: Mark[] = [];
  const last = new Map<number, Mark>();
  for (const each of spans) {
    const kind = each.waits ? "waits" : each.state;
    if (kind === "running" || kind === "finished") continue;
    if (each.from > to || each.to < from || (kind === "faulted" && each.from < from)) continue;
    const end = kind === "faulted" ? each.from : each.to;
    const mark: Mark = {
      thread: each.thread,
      kind,
      from: part(each.from),
      to: part(end),
      of: each,
    };
    const before = last.get(each.thread);
    const isNear = before?.kind === kind && mark.from - before.to < together;
    if (isNear && kind !== "faulted" && mark.to - mark.from < 4 * together) {
      before.to = mark.to;
      delete before.of;
    } else {
      marks.push(mark);
      last.set(each.thread, mark);
    }
  }
  return marks;
}

/** The moment at a part of the span, within the run. */
export function momentAt({ from, to }: Span, part: number, head: number): number {
  return Math.min(head, Math.max(0, Math.round(from + part * (to - from))));
}

// --- Scale ---------------------------------------------------------------------------------------

/** A moment, and the time of the card there. */
export interface TimeAt {
  moment: number;
  ms: number;
}

/** What turns and states say of the time within a span, in the order of their moments. */
export function timesOf(turns: Turn[], spans: ThreadSpan[], { from, to }: Span): TimeAt[] {
  const times = [
    ...turns.flatMap(({ moment, time_ms: ms, statements }) => [
      { moment, ms },
      { moment: moment + statements, ms },
    ]),
    ...spans.flatMap((each) => [
      { moment: each.from, ms: each.from_ms },
      { moment: each.to, ms: each.to_ms },
    ]),
  ].sort((a, b) => a.moment - b.moment);
  const within = times.filter(({ moment }) => moment >= from && moment <= to);
  let last = -Infinity;
  return (within.length > 0 ? within : times).filter(({ moment }) => {
    if (moment - last < (to - from) * together) return false;
    last = moment;
    return true;
  });
}

/** The same with the present moment, up to which nothing may be known yet. */
export function withPresent(times: readonly TimeAt[], present: TimeAt): TimeAt[] {
  return [
    ...(times.length > 0 ? times : [{ moment: 0, ms: 0 }]).filter(
      ({ moment }) => moment < present.moment,
    ),
    present,
    ...times.filter(({ moment }) => moment > present.moment),
  ];
}

/** On the lines between points (x, y), which are in their order; beyond them lines rise by `slope`. */
function onLines(
  points: readonly (readonly [number, number])[],
  slope: number,
  at: number,
): number {
  const index = points.findIndex(([x]) => x >= at);
  const after = points[index];
  const before = index < 0 ? points.at(-1) : points[index - 1];
  if (before && after) {
    return before[1] + ((at - before[0]) / (after[0] - before[0])) * (after[1] - before[1]);
  }
  const [x, y] = after ?? before ?? [0, 0];
  return y + (at - x) * slope;
}

/** The time at a moment: where no statement is executed, each moment is a cycle. */
export function timeAt(times: readonly TimeAt[], cycleMs: number, at: number): number {
  return onLines(
    times.map(({ moment, ms }) => [moment, ms] as const),
    cycleMs,
    at,
  );
}

/** The first moment with a time. */
export function momentOf(times: readonly TimeAt[], cycleMs: number, at: number): number {
  return onLines(
    times.map(({ moment, ms }) => [ms, moment] as const),
    1 / cycleMs,
    at,
  );
}

/** A number of the scale, and where it stands: from 0 to 1, in the span. */
export interface ScaleMark {
  at: number;
  text: string;
}

/** So close to each other, two numbers could not be read. */
const leastApart = 0.09;

/** The marks that can be read beside each other, and beside what covers a part of the scale. */
export function readable(marks: ScaleMark[], covered: readonly [number, number]): ScaleMark[] {
  let last = -Infinity;
  return marks.filter(({ at }) => {
    const isFree = at >= 0 && at <= 1 && (at < covered[0] || at > covered[1]);
    if (!isFree || at - last < leastApart) return false;
    last = at;
    return true;
  });
}

/** Whole steps for a scale: about `count` of them. */
export function ticks({ from, to }: Span, count: number): number[] {
  const rough = (to - from) / count;
  const power = 10 ** Math.floor(Math.log10(Math.max(1, rough)));
  const step = ([1, 2, 5, 10].find((each) => each * power >= rough) ?? 10) * power;
  const marks: number[] = [];
  for (let mark = Math.ceil(from / step) * step; mark <= to; mark += step) marks.push(mark);
  return marks;
}
