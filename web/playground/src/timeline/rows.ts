// The part of a run that the timeline shows, and where its bars are. Its scale is that of moments:
// statements within a cycle, where no time passes, lie beside each other.
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

/** Bars of one thread that are closer than this become one. */
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

/** Whole steps for a scale: about `count` of them. */
export function ticks({ from, to }: Span, count: number): number[] {
  const rough = (to - from) / count;
  const power = 10 ** Math.floor(Math.log10(Math.max(1, rough)));
  const step = ([1, 2, 5, 10].find((each) => each * power >= rough) ?? 10) * power;
  const marks: number[] = [];
  for (let mark = Math.ceil(from / step) * step; mark <= to; mark += step) marks.push(mark);
  return marks;
}
