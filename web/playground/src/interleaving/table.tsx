// A failing run as a table with a column for each thread: what each statement made, the values of
// shared variables before and after, the step from which every continuation fails, and an arrow from a
// stale read to the write that it led to. It knows neither the page nor its session.

import type { Interleaving } from "@oncard/engine";
import { Fragment, type TargetedKeyboardEvent } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import { type ArrowWords, StaleArrow } from "./arrow.js";
import {
  inMemory,
  isLostWrite,
  isStatementRow,
  madeBy,
  numberOf,
  rowOf,
  sharedNames,
  type StatementRow,
} from "./cells.js";

/** The words of the table. */
export interface TableWords extends ArrowWords {
  label: string;
  step: string;
  shared: string;
  reads: (value: string) => string;
  statements: (count: number) => string;
  nothingShared: string;
  fatal: string;
  forever: string;
  skipped: (statements: number) => string;
}

export interface TableInputs {
  run: Interleaving;
  /** The step that was executed last; 0 before the first one, undefined if this run is not on the card. */
  now: number | undefined;
  words: TableWords;
  /** Steps with a frame. */
  framed: readonly number[];
  /** Begins the ids of the rows. */
  name: string;
  /** The reader wants to be after this step; missing: nothing can be wanted. */
  onGoTo?: (step: number) => void;
}

/** With more threads than this, they share one column. */
const mostColumns = 4;
/** So many rows are drawn at most: the last ones, where the run fails. */
const mostRows = 1000;

export function InterleavingTable({ run, now, words, framed, name, onGoTo }: TableInputs) {
  const table = useRef<HTMLTableElement>(null);
  const all = [...run.rows, ...(run.cycle ?? [])];
  const cut = Math.max(0, all.length - mostRows);
  const rows = all.slice(cut);
  const isShared = run.threads.length > mostColumns;
  const columns = isShared ? 1 : run.threads.length;
  const names = sharedNames(all);
  const at = now === undefined ? undefined : rowOf(all, now);
  const places = rows.filter(isStatementRow);
  const firstOfCycle = run.cycle?.[0];
  const skipped = run.skipped + (cut > 0 ? (places[0]?.step ?? 1) - 1 : 0);
  const span = columns + 2;

  // The run comes onto the card at its end; the table is then read from its top.
  const before = useRef<number | undefined>(undefined);
  useLayoutEffect(() => {
    if (before.current !== undefined) {
      table.current?.querySelector(".now")?.scrollIntoView({ block: "nearest" });
    }
    before.current = now;
  }, [now]);

  const move = (event: TargetedKeyboardEvent<HTMLTableElement>) => {
    const index = at ? places.findIndex(({ step }) => step === at.step) : -1;
    const to: Record<string, number> = {
      ArrowUp: Math.max(0, index - 1),
      ArrowDown: Math.min(places.length - 1, index + 1),
      Home: 0,
      End: places.length - 1,
    };
    const place = places[to[event.key] ?? -1];
    if (!place) return;
    event.preventDefault();
    onGoTo?.(place.last);
  };
  return (
    <div class={`interleaving-table scroll ${onGoTo ? "" : "still"}`}>
      {skipped > 0 && <p class="muted small">{words.skipped(skipped)}</p>}
      <div class="interleaving-sheet">
        <table
          ref={table}
          role="grid"
          aria-label={words.label}
          aria-readonly="true"
          aria-activedescendant={at && `${name}-${at.step}`}
          tabIndex={0}
          onKeyDown={move}
        >
          <thead>
            <tr>
              <th scope="col" class="number">
                {words.step}
              </th>
              {isShared ? (
                <th scope="col" />
              ) : (
                run.threads.map(({ thread, function: called }) => (
                  <th key={thread} scope="col" class={`t${thread % 8}`}>
                    <Badge thread={thread} /> {called}
                  </th>
                ))
              )}
              <th scope="col" class="memory">
                {names.length === 1 ? <code>{names[0]}</code> : words.shared}
              </th>
            </tr>
          </thead>
          <tbody>
            {rows.map((row, index) => (
              <Fragment key={index}>
                {row === firstOfCycle && <Band span={span} class="forever" text={words.forever} />}
                {isStatementRow(row) ? (
                  <Row
                    row={row}
                    run={run}
                    words={words}
                    isNow={row === at}
                    isShared={isShared}
                    named={names.length > 1}
                    isHit={framed.includes(row.step)}
                    id={`${name}-${row.step}`}
                    onGoTo={onGoTo}
                  />
                ) : (
                  <Band
                    span={span}
                    class="time"
                    text={`${row.ms} ms${row.kind === "host" ? `  ${row.statement}` : ""}`}
                  />
                )}
                {row.kind === "step" && row.fatal && (
                  <Band span={span} class="fatal" text={words.fatal} />
                )}
              </Fragment>
            ))}
          </tbody>
        </table>
        <StaleArrow
          table={table}
          run={run}
          rows={rows}
          words={words}
          isShared={isShared}
          name={name}
        />
      </div>
    </div>
  );
}

function Badge({ thread }: { thread: number }) {
  return <span class={`badge t${thread % 8}`}>{thread}</span>;
}

function Band(props: { span: number; class: string; text: string }) {
  return (
    <tr class={`band ${props.class}`}>
      <td />
      <td colSpan={props.span - 1}>{props.text}</td>
    </tr>
  );
}

function Row(props: {
  row: StatementRow;
  run: Interleaving;
  words: TableWords;
  isNow: boolean;
  isShared: boolean;
  /** Values have the names of their variables. */
  named: boolean;
  isHit: boolean;
  id: string;
  onGoTo: TableInputs["onGoTo"];
}) {
  const { row, run, words, isNow, isShared, named, isHit, id, onGoTo } = props;
  const column = isShared ? 0 : run.threads.findIndex(({ thread }) => thread === row.thread);
  const columns = isShared ? 1 : run.threads.length;
  const cell = (
    <div class={`cell ${row.kind} ${isHit ? "hit" : ""} t${(row.thread ?? 6) % 8}`}>
      {isShared && row.thread !== undefined && <Badge thread={row.thread} />}
      {row.kind === "gap" ? (
        <span>
          {words.statements(row.last - row.step + 1)}
          <span class="wide-alone">{words.nothingShared}</span>
        </span>
      ) : (
        <>
          <code>{row.statement ?? (row.kind === "step" ? row.line : "")}</code>
          <span class="made">
            {madeBy(row).map(({ name, after }) => (
              <span key={name}>
                <span class="wide-alone">{name}</span> {after}
              </span>
            ))}
          </span>
        </>
      )}
    </div>
  );
  return (
    <tr
      id={id}
      class={isNow ? "now" : ""}
      aria-selected={isNow}
      onClick={() => {
        onGoTo?.(row.last);
      }}
    >
      <td class="number">{numberOf(row)}</td>
      {column < 0 ? (
        <td colSpan={columns}>{cell}</td>
      ) : (
        Array.from({ length: columns }, (_, index) => (
          <td key={index}>{index === column && cell}</td>
        ))
      )}
      <Memory row={row} words={words} named={named} isLost={isLostWrite(run, row.step)} />
    </tr>
  );
}

function Memory(props: { row: StatementRow; words: TableWords; named: boolean; isLost: boolean }) {
  const { row, words, named, isLost } = props;
  const { writes, reads } = inMemory(row);
  return (
    <td class="memory">
      {writes.map(({ name, before, after }) => (
        <div key={name} class={isLost ? "lost" : ""}>
          {named && <code>{name}</code>} {before} → {after}
        </div>
      ))}
      {reads.map(({ name, value }) => (
        <div key={name} class="muted">
          {named && <code>{name}</code>} {words.reads(value)}
        </div>
      ))}
    </td>
  );
}
