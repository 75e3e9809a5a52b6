// What a check or an exploration says, in words.

import type { ExploreAnswer } from "@oncard/engine";

import { source } from "../store/source.js";
import { number, texts } from "../texts/texts.js";
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
  const { report, text = "", schedule } = exploration;
  if (!report) return null;
  const isGood = report.verdict === "PROVED" || report.verdict === "PASSED";
  const isTask = isCheck && source.lesson.value.task === "explore" && report.verdict === "PROVED";
  // The report for people is in the reader's language: the sentence after its values is the culprit.
  return (
    <>
      <p class={isGood ? "good" : "bad"}>{isTask ? t.proved : e.verdicts[report.verdict]}</p>
      {report.verdict === "FAILED" && (
        <Culprit
          text={text}
          hasChoice={report.choice !== undefined}
          isKnown={report.culprit !== undefined}
        />
      )}
      {schedule !== undefined && <p>{e.opened}</p>}
      <details>
        <summary>{e.report}</summary>
        <pre class="report" tabIndex={0}>
          {text}
        </pre>
      </details>
    </>
  );
}

/** What the report says does not hold, in which case of its choices, and, if known, which step caused it. */
function Culprit(props: { text: string; hasChoice: boolean; isKnown: boolean }) {
  const { text, hasChoice, isKnown } = props;
  const paragraph = text.split("\n\n")[1] ?? "";
  const culprit = hasChoice ? 2 : 1;
  const lines = paragraph.split("\n").slice(0, isKnown ? culprit + 1 : culprit);
  return (
    <>
      {lines.map((line, index) => (
        <p key={line} class={index === culprit ? "culprit" : ""}>
          {line}
        </p>
      ))}
    </>
  );
}
