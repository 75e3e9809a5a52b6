// The failing run of an exploration, and its place on the card.

import { executedAt } from "@oncard/engine";

import { present } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { failingRun, goToStep, useStepsOnCard } from "./failing_run.js";
import { FailingRunView } from "./view.js";

export function InterleavingPanel() {
  const { value: found } = failingRun;
  const steps = useStepsOnCard();
  if (!found) return null;
  return (
    <FailingRunView
      run={found.interleaving}
      now={steps && executedAt(steps, present.state.value?.moment ?? 0)}
      words={texts.value.interleaving}
      onGoTo={(step) => void goToStep(step)}
    />
  );
}
