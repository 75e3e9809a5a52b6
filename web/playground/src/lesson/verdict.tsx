// What a check or an exploration says, in words.

import type { ExploreAnswer, Interleaving } from "@oncard/engine";

import { source } from "../store/source.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { stopCheck, verdict } from "./checks.js";

/** Scrolls to what was said, where a screen is too low for it. */
export function showVerdict(): void {
  requestAnimationFrame(() => {
    document.querySelector(".verdict")?.scrollIntoView({ block: "nearest" });
  });
}

export function VerdictBox() {
  const { lessons: t, explore: e, controls, status } = texts.value;
  const said = verdict.value;
  if (said.kind === "none") return null;
  return (
    <section class="verdict" aria-live="polite" role="status">
      {said.kind === "busy" && (
        <div class="row">
          <span class="grow">{said.what === "check" ? t.checking : controls.exploring}</span>
          <button type="button" onClick={stopCheck}>
            {controls.stop}
          </button>
        </div>
      )}
      {said.kind === "stopped" && <p>{e.stopped}</p>}
      {said.kind === "not-compiled" && <p class="bad">{t.broken}</p>}
      {said.kind === "refused" && <pre class="bad complaint">{said.message}</pre>}
      {said.kind === "run" && said.run.choice !== undefined && (
        <p class="muted">{status.choice(said.run.choice)}</p>
      )}
      {said.kind === "run" &&
        (said.run.passed ? (
          <>
            <p class="good">{t.passed}</p>
            <Warnings warnings={said.run.warnings} />
          </>
        ) : (
          <>
            {said.isHidden && <p>{t.otherInputs}</p>}
            <p class="bad">{t.ended[said.run.end] ?? t.failed}</p>
            <ul>
              {said.run.failures.map(({ expectation, message }) => (
                <li key={expectation}>
                  <code>{expectation}</code>
                  <br />
                  {message}
                </li>
              ))}
            </ul>
            <p class="muted small">{number(said.run.time_ms)} ms</p>
            <Warnings warnings={said.run.warnings} />
          </>
        ))}
      {said.kind === "explored" && (
        <>
          {said.isHidden && <p>{t.otherInputs}</p>}
          <Explored exploration={said.exploration} isCheck={said.isCheck} />
        </>
      )}
    </section>
  );
}

function Warnings({ warnings }: { warnings: string[] }) {
  return (
    <>
      {warnings.map((warning) => (
        <p key={warning} class="muted small">
          {warning}
        </p>
      ))}
    </>
  );
}

function Explored({ exploration, isCheck }: { exploration: ExploreAnswer; isCheck: boolean }) {
  const { explore: e, lessons: t } = texts.value;
  const { report, text = "", interleaving } = exploration;
  if (!report) return null;
  const isGood = report.verdict === "PROVED" || report.verdict === "PASSED";
  const isTask = isCheck && source.lesson.value.task === "explore" && report.verdict === "PROVED";
  return (
    <>
      <p class={isGood ? "good" : "bad"}>{isTask ? t.proved : e.verdicts[report.verdict]}</p>
      {interleaving && <Failure interleaving={interleaving} />}
      <details>
        <summary>{e.report}</summary>
        <pre class="report" tabIndex={0}>
          {text}
        </pre>
      </details>
    </>
  );
}

/** What does not hold, in which case of what the scenario leaves open, and, if known, which step caused it. */
function Failure({ interleaving }: { interleaving: Interleaving }) {
  const { explore: e, status } = texts.value;
  const { reason, actual, choice, culprit } = interleaving;
  return (
    <>
      <p>{actual === undefined ? reason : e.because(reason, actual)}</p>
      {choice !== undefined && <p>{status.choice(choice)}</p>}
      {culprit !== undefined && <p class="culprit">{culprit}</p>}
      <p>{e.opened}</p>
    </>
  );
}
