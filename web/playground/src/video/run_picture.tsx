// A picture of the run as it is now.

import { useAsked } from "../session/asked.js";
import { present, session } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { frameHeight, frameWidth } from "./layout.js";
import { SavePicture, Still } from "./picture.js";
import type { ShownRun } from "./run.js";
import { runKey, runNow } from "./run_now.js";

export function RunPicture() {
  const { video: t } = texts.value;
  const run = useAsked(runKey(), runNow, session.running.value);
  return (
    <section class="run-picture" aria-labelledby="run-picture-title">
      <h3 id="run-picture-title">{t.title}</h3>
      {(present.state.value?.time_ms ?? 0) === 0 ? (
        <Nothing />
      ) : run ? (
        <Shown run={run} />
      ) : (
        <canvas width={frameWidth} height={frameHeight} aria-hidden="true" />
      )}
    </section>
  );
}

function Nothing() {
  const { video: t } = texts.value;
  return (
    <>
      <p id="run-picture-why" class="muted">
        {t.nothing}
      </p>
      <div class="row">
        <button type="button" disabled aria-describedby="run-picture-why">
          {t.savePicture}
        </button>
      </div>
    </>
  );
}

function Shown({ run }: { run: ShownRun }) {
  return (
    <>
      <Still run={run} />
      <div class="row">
        <SavePicture run={run} />
      </div>
    </>
  );
}
