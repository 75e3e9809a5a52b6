// A video while it is recorded: its frames, how far it is, and Cancel.

import { useEffect, useRef, useState } from "preact/hooks";

import { texts } from "../texts/texts.js";
import { paintFrame } from "./frame.js";
import { frameHeight, frameWidth } from "./layout.js";
import { lookNow } from "./look.js";
import { recordVideo } from "./record.js";
import type { ShownRun } from "./run.js";
import { speedOf, timeShown, videoLength } from "./timing.js";

interface RecordingProps {
  run: ShownRun;
  type: string;
  /** Nothing if it has failed. */
  onEnd: (video: Blob | undefined) => void;
  onCancel: () => void;
}

/** Records until the video is whole, or this goes away. */
export function Recording({ run, type, onEnd, onCancel }: RecordingProps) {
  const { video: t, cancel } = texts.value;
  const canvas = useRef<HTMLCanvasElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  const [passed, setPassed] = useState(0);
  const lengthMs = videoLength(run.endMs);
  useEffect(() => {
    button.current?.focus();
    const { current } = canvas;
    const context = current?.getContext("2d");
    if (!context) return undefined;
    const control = new AbortController();
    const look = lookNow();
    const note = speedText(run.endMs);
    const paint = (videoMs: number) => {
      paintFrame(context, run, timeShown(videoMs, run.endMs), look, note);
      setPassed(videoMs);
    };
    const { signal } = control;
    void recordVideo({ canvas: context.canvas, type, lengthMs, paint, signal }).then((video) => {
      if (!signal.aborted) onEnd(video);
    });
    return () => {
      control.abort();
    };
  }, []);
  return (
    <>
      <canvas ref={canvas} width={frameWidth} height={frameHeight} aria-hidden="true" />
      <div class="row">
        <progress aria-label={t.recording} max={lengthMs} value={passed} />
        <button ref={button} type="button" onClick={onCancel}>
          {cancel}
        </button>
      </div>
    </>
  );
}

/** Nothing if the video is as fast as the card. */
function speedText(runMs: number): string {
  const times = Number(speedOf(runMs).toPrecision(2));
  return times === 1 ? "" : texts.peek().video.speed(String(times));
}
