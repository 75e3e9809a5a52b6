// The last frame of a run, to see and to save.

import { useEffect, useRef, useState } from "preact/hooks";

import { save } from "../share/save.js";
import { isDark } from "../store/settings.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { paintFrame } from "./frame.js";
import { frameHeight, frameWidth } from "./layout.js";
import { lookNow } from "./look.js";
import type { ShownRun } from "./run.js";

export function Still({ run }: { run: ShownRun }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const isNight = isDark();
  useEffect(() => {
    if (canvas.current) paintEnd(canvas.current, run);
  }, [run, isNight]);
  return (
    <canvas
      ref={canvas}
      width={frameWidth}
      height={frameHeight}
      role="img"
      aria-label={texts.value.video.preview(number(run.endMs))}
    />
  );
}

export function SavePicture({ run }: { run: ShownRun }) {
  const { video: t } = texts.value;
  const [copied, setCopied] = useState<ShownRun>();
  const copy = async () => {
    try {
      // The browser wants the promise at once, while the click is fresh.
      await navigator.clipboard.write([new ClipboardItem({ "image/png": pictureOf(run) })]);
      setCopied(run);
    } catch {
      // Without permission the picture can be saved.
    }
  };
  return (
    <>
      <button
        type="button"
        onClick={() => {
          void pictureOf(run).then((picture) => {
            save("oncard.png", picture);
          });
        }}
      >
        {t.savePicture}
      </button>
      {typeof ClipboardItem !== "undefined" && (
        <button type="button" onClick={() => void copy()}>
          {t.copyPicture}
        </button>
      )}
      <span role="status">{copied === run ? t.copied : ""}</span>
    </>
  );
}

function paintEnd(canvas: HTMLCanvasElement, run: ShownRun): void {
  const context = canvas.getContext("2d");
  if (context) paintFrame(context, run, run.endMs, lookNow());
}

function pictureOf(run: ShownRun): Promise<Blob> {
  const canvas = document.createElement("canvas");
  canvas.width = frameWidth;
  canvas.height = frameHeight;
  paintEnd(canvas, run);
  return new Promise((resolve, reject) => {
    canvas.toBlob((picture) => {
      if (picture) resolve(picture);
      else reject(new Error("the browser makes no picture"));
    });
  });
}
