// A failing run: what is wrong in a sentence, and how it came to it. It knows neither the page nor its
// session; the extension for Visual Studio Code shows it, too.

import type { Interleaving } from "@oncard/engine";
import { useState } from "preact/hooks";

import { Tabs } from "../controls/tabs.js";
import { InterleavingTable, type TableInputs, type TableWords } from "./table.js";

/** The words of the table, and of the two orders of a data race. */
export interface FailingRunWords extends TableWords {
  orders: string;
  thisOrder: string;
  bothOrders: string;
  first: (thread: number) => string;
  end: (values: string) => string;
  sameEnd: string;
}

interface FailingRunInputs extends Pick<TableInputs, "run" | "now" | "onGoTo"> {
  words: FailingRunWords;
}

export function FailingRunView({ run, now, words, onGoTo }: FailingRunInputs) {
  const [isBoth, setBoth] = useState(false);
  const { stale, orders } = run;
  return (
    <>
      <header class="interleaving-head">
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <circle cx="12" cy="12" r="11" />
          <path d="M8 8l8 8M16 8l-8 8" />
        </svg>
        <div>
          <h3>{run.actual ?? run.reason}</h3>
          {run.culprit !== undefined ? (
            <p>{run.culprit}</p>
          ) : (
            run.actual !== undefined && <p>{run.reason}</p>
          )}
        </div>
        {orders && (
          <Tabs
            label={words.orders}
            values={[false, true]}
            chosen={isBoth}
            nameOf={(both) => (both ? words.bothOrders : words.thisOrder)}
            onChoose={setBoth}
          />
        )}
      </header>
      {orders && isBoth ? (
        <BothOrders run={run} orders={orders} words={words} />
      ) : (
        <InterleavingTable
          run={run}
          now={now}
          words={words}
          framed={stale ? [stale.read, stale.use] : (orders?.[0]?.racing ?? [])}
          name="step"
          {...(onGoTo && { onGoTo })}
        />
      )}
    </>
  );
}

/** The two orders of a data race side by side, each with its end. */
function BothOrders(props: {
  run: Interleaving;
  orders: NonNullable<Interleaving["orders"]>;
  words: FailingRunWords;
}) {
  const { words } = props;
  const { threads, reason } = props.run;
  return (
    <div class="orders">
      {props.orders.map(({ first, racing, end, rows }) => (
        <section key={first} aria-label={words.first(first)}>
          <h4>
            {words.first(first)} <span>{end === "" ? words.sameEnd : words.end(end)}</span>
          </h4>
          <InterleavingTable
            run={{ reason, threads, skipped: 0, rows }}
            now={undefined}
            words={{ ...words, label: words.first(first) }}
            framed={racing}
            name={`order-${first}`}
          />
        </section>
      ))}
    </div>
  );
}
