// A picture of the run as it is now, and a video of how it got there.

import { useEffect, useRef, useState } from "preact/hooks";

import { useAsked } from "../session/asked.js";
import { present, session } from "../session/bench.js";
import { save } from "../share/save.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { frameHeight, frameWidth } from "./layout.js";
import { SavePicture, Still } from "./picture.js";
import { typeOfVideo, videoName } from "./record.js";
import { Recording } from "./recording.js";
import type { ShownRun } from "./run.js";
import { runKey, runNow } from "./run_now.js";
import { videoLength } from "./timing.js";
import { Video } from "./video.js";

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
        {[t.record, t.savePicture].map((text) => (
          <button key={text} type="button" disabled aria-describedby="run-picture-why">
            {text}
          </button>
        ))}
      </div>
    </>
  );
}

function Shown({ run }: { run: ShownRun }) {
  const type = typeOfVideo();
  /** The run that is being recorded: it stays as it was, whatever the card does meanwhile. */
  const [recorded, setRecorded] = useState<ShownRun>();
  const [video, setVideo] = useState<Blob>();
  const [hasFailed, setFailed] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const wasRecorded = useRef(false);
  useEffect(() => {
    // The button with the focus has gone.
    if (wasRecorded.current && !recorded) button.current?.focus();
    wasRecorded.current = recorded !== undefined;
  }, [recorded]);
  if (recorded && type !== undefined) {
    return (
      <Recording
        run={recorded}
        type={type}
        onEnd={(result) => {
          setRecorded(undefined);
          setVideo(result);
          setFailed(result === undefined);
        }}
        onCancel={() => {
          setRecorded(undefined);
        }}
      />
    );
  }
  return (
    <>
      {video ? <Video video={video} /> : <Still run={run} />}
      <div class="row">
        {video && <SaveVideo video={video} />}
        <button
          ref={button}
          type="button"
          disabled={type === undefined}
          aria-describedby="record-note"
          onClick={() => {
            setVideo(undefined);
            setFailed(false);
            setRecorded(run);
          }}
        >
          {texts.value.video.record}
        </button>
        <SavePicture run={run} />
      </div>
      <p id="record-note" class="muted small" role="status">
        {noteOf(run, type !== undefined, hasFailed)}
      </p>
    </>
  );
}

function SaveVideo({ video }: { video: Blob }) {
  return (
    <button
      type="button"
      onClick={() => {
        save(videoName(video.type), video);
      }}
    >
      {texts.value.video.saveVideo}
    </button>
  );
}

function noteOf(run: ShownRun, isAble: boolean, hasFailed: boolean): string {
  const { video: t } = texts.value;
  if (!isAble) return t.unable;
  return hasFailed ? t.failed : t.seconds(number(videoLength(run.endMs) / 1000, 1));
}
