// The failing run of an exploration: what is wrong in a sentence, and how it came to it.

import { executedAt, type Interleaving } from "@oncard/engine";
import { useState } from "preact/hooks";

import { Tabs } from "../controls/tabs.js";
import { present } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { failingRun, goToStep, useStepsOnCard } from "./failing_run.js";
import { InterleavingTable } from "./table.js";

export function InterleavingPanel() {
  const { value: found } = failingRun;
  const steps = useStepsOnCard();
  const [isBoth, setBoth] = useState(false);
  if (!found) return null;
  const { interleaving: failing } = found;
  const { interleaving: t } = texts.value;
  const { stale, orders } = failing;
  const now = steps && executedAt(steps, present.state.value?.moment ?? 0);
  return (
    <>
      <header class="interleaving-head">
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <circle cx="12" cy="12" r="11" />
          <path d="M8 8l8 8M16 8l-8 8" />
        </svg>
        <div>
          <h3>{failing.actual ?? failing.reason}</h3>
          {failing.culprit !== undefined ? (
            <p>{failing.culprit}</p>
          ) : (
            failing.actual !== undefined && <p>{failing.reason}</p>
          )}
        </div>
        {orders && (
          <Tabs
            label={t.orders}
            values={[false, true]}
            chosen={isBoth}
            nameOf={(both) => (both ? t.bothOrders : t.thisOrder)}
            onChoose={setBoth}
          />
        )}
      </header>
      {orders && isBoth ? (
        <BothOrders failing={failing} orders={orders} />
      ) : (
        <InterleavingTable
          run={failing}
          now={now}
          words={t}
          framed={stale ? [stale.read, stale.use] : (orders?.[0]?.racing ?? [])}
          name="step"
          onGoTo={(step) => void goToStep(step)}
        />
      )}
    </>
  );
}

/** The two orders of a data race side by side, each with its end. */
function BothOrders(props: { failing: Interleaving; orders: NonNullable<Interleaving["orders"]> }) {
  const { interleaving: t } = texts.value;
  const { threads, reason } = props.failing;
  return (
    <div class="orders">
      {props.orders.map(({ first, racing, end, rows }) => (
        <section key={first} aria-label={t.first(first)}>
          <h4>
            {t.first(first)} <span>{end === "" ? t.sameEnd : t.end(end)}</span>
          </h4>
          <InterleavingTable
            run={{ reason, threads, skipped: 0, rows }}
            now={undefined}
            words={{ ...t, label: t.first(first) }}
            framed={racing}
            name={`order-${first}`}
          />
        </section>
      ))}
    </div>
  );
}
