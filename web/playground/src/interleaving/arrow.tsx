// The arrow of the table: from a stale read to the step that used it.

import type { Interleaving, InterleavingRow } from "@oncard/engine";
import { useLayoutEffect, useState } from "preact/hooks";

import { emptyPart, isStatementRow, rowOf } from "./cells.js";

/** What stands beside it. */
export interface ArrowWords {
  keeps: (thread: number, value: string) => string;
  meanwhile: (thread: number, value: string) => string;
}

interface Place {
  path: string;
  head: string;
  words?: { left: number; top: number; width: number } | undefined;
}

/** From the stale read to the step that used it, beside the numbers; its words where the column is empty. */
export function StaleArrow(props: {
  table: { current: HTMLTableElement | null };
  run: Interleaving;
  rows: readonly InterleavingRow[];
  words: ArrowWords;
  isShared: boolean;
  /** Begins the ids of the rows. */
  name: string;
}) {
  const { table, run, rows, words, isShared, name } = props;
  const { stale } = run;
  const [place, setPlace] = useState<Place>();
  useLayoutEffect(() => {
    const sheet = table.current;
    if (!sheet || !stale) {
      setPlace(undefined);
      return undefined;
    }
    const measure = () => {
      setPlace(placeOf(sheet, rows, stale, isShared, name));
    };
    measure();
    const watch = new ResizeObserver(measure);
    watch.observe(sheet);
    return () => {
      watch.disconnect();
    };
  }, [run, isShared, name]);
  if (!stale || !place) return null;
  const thread = rowOf(rows, stale.read)?.thread ?? 0;
  const other = rowOf(rows, stale.write)?.thread;
  return (
    <>
      <svg class="stale-arrow" aria-hidden="true">
        <path d={place.path} pathLength="1" />
        <path d={place.head} class="head" />
      </svg>
      {place.words && (
        <div
          class="stale-words"
          ref={(element) => {
            if (element && place.words) {
              for (const [key, value] of Object.entries(place.words)) {
                element.style.setProperty(key, `${value}px`);
              }
            }
          }}
        >
          <strong>{words.keeps(thread, stale.value)}</strong>
          {other !== undefined && <span>{words.meanwhile(other, stale.changed)}</span>}
        </div>
      )}
    </>
  );
}

/** The words need this much. */
const wordsHeight = 48;
const radius = 8;

function placeOf(
  table: HTMLTableElement,
  rows: readonly InterleavingRow[],
  stale: NonNullable<Interleaving["stale"]>,
  isShared: boolean,
  name: string,
): Place | undefined {
  const box = table.getBoundingClientRect();
  const rowAt = (index: number) => {
    const row = rows[index];
    return row && isStatementRow(row)
      ? table.querySelector<HTMLElement>(`#${name}-${row.step}`)
      : undefined;
  };
  const indexOf = (step: number) => rows.findIndex((row) => row === rowOf(rows, step));
  const [from, to] = [indexOf(stale.read), indexOf(stale.use)];
  const [read, use] = [rowAt(from), rowAt(to)].map((row) => row?.querySelector(".cell"));
  if (!read || !use || from === to) return undefined;
  const [a, b] = [read, use].map((cell) => {
    const { left, top, height } = cell.getBoundingClientRect();
    return { x: left - box.left, y: top - box.top + height / 2 };
  }) as [{ x: number; y: number }, { x: number; y: number }];
  const gutter = (table.querySelector("th")?.getBoundingClientRect().width ?? 0) - 6;
  const path =
    `M${a.x} ${a.y}H${gutter + radius}Q${gutter} ${a.y} ${gutter} ${a.y + radius}` +
    `V${b.y - radius}Q${gutter} ${b.y} ${gutter + radius} ${b.y}H${b.x - 3}`;
  const head = `M${b.x - 8} ${b.y - 5}l7 5-7 5`;
  const thread = rows[from] && "thread" in rows[from] ? rows[from].thread : undefined;
  const empty = isShared || thread === undefined ? undefined : emptyPart(rows, thread, from, to);
  const [first, last] = empty ? [rowAt(empty[0]), rowAt(empty[1] - 1)] : [];
  if (!first || !last) return { path, head };
  const top = first.getBoundingClientRect().top - box.top;
  const bottom = last.getBoundingClientRect().bottom - box.top;
  if (bottom - top < wordsHeight) return { path, head };
  const width = read.getBoundingClientRect().width + 8;
  return { path, head, words: { left: a.x - 4, top: (top + bottom) / 2, width } };
}
