// The failing run of an exploration: what is wrong in a sentence, and how it came to it.

import { present } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { failingRun, goToStep, useStepsOnCard } from "./failing_run.js";
import { executedAt } from "./moments.js";
import { InterleavingTable } from "./table.js";

export function InterleavingPanel() {
  const { value: found } = failingRun;
  const steps = useStepsOnCard();
  if (!found) return null;
  const { interleaving: failing } = found;
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
      </header>
      <InterleavingTable
        run={failing}
        now={now}
        words={texts.value.interleaving}
        onGoTo={(step) => void goToStep(step)}
      />
    </>
  );
}
