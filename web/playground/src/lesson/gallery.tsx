// The samples with small pictures that move. A click opens one as a program of the reader's own.

import type { Lesson } from "@oncard/lessons";
import { pictures } from "virtual:lessons";

import { showPanel } from "../store/layout.js";
import { lessons } from "../store/lessons.js";
import { settings } from "../store/settings.js";
import { openSample } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { wantsStill } from "./opening.js";
import { across, height, partsOf, type Picture, pointsOf, width } from "./picture.js";

/** How long a picture takes. */
const seconds = "5s";

function Moving({ name, values }: { name: string; values: (number | string)[] }) {
  if (wantsStill()) return null;
  return (
    <animate
      attributeName={name}
      values={values.join(";")}
      dur={seconds}
      repeatCount="indefinite"
    />
  );
}

function Path({ axes }: { axes: number[][] }) {
  const points = pointsOf(axes);
  const [x, y] = points.at(-1) ?? [0, 0];
  return (
    <>
      <polyline points={points.join(" ")} class="way" pathLength={1} stroke-dasharray="1">
        <Moving name="stroke-dashoffset" values={partsOf(points).map((part) => 1 - part)} />
      </polyline>
      <circle cx={x} cy={y} r="3" class="thumb-tool">
        <Moving name="cx" values={points.map(([each]) => each)} />
        <Moving name="cy" values={points.map(([, each]) => each)} />
      </circle>
    </>
  );
}

function Rails({ axes }: { axes: number[][] }) {
  return axes.map((places, index) => {
    const y = (height * (index + 1)) / (axes.length + 1);
    const at = places.map((place) => across(place * 0.78));
    // Where it is after two thirds of the time, if nothing moves.
    const still = at[Math.floor((at.length * 2) / 3)];
    return (
      <g key={index} class={`a${index}`}>
        <rect x="14" y={y - 2} width="100" height="4" rx="2" class="rail-bed" />
        <rect x={still} y={y - 6} width="22" height="12" rx="3" class="carriage">
          <Moving name="x" values={at} />
        </rect>
      </g>
    );
  });
}

function Lanes({ turns }: { turns: [number, number, number][] }) {
  const ends = [across(0), across(100)];
  return (
    <>
      {turns.map(([thread, from, to]) => (
        <g key={`${thread} ${from}`} class={`t${thread}`}>
          <rect
            x={across(from)}
            y={14 + thread * 20}
            width={Math.max(1.5, to - from - 0.5)}
            height="12"
            rx="2"
            class="turn"
          />
        </g>
      ))}
      <line x1={ends[1]} x2={ends[1]} y1="6" y2={height - 6} class="thumb-now">
        <Moving name="x1" values={ends} />
        <Moving name="x2" values={ends} />
      </line>
    </>
  );
}

function Thumb({ picture }: { picture: Picture | undefined }) {
  return (
    <svg viewBox={`0 0 ${width} ${height}`} aria-hidden="true">
      {picture?.kind === "path" && <Path axes={picture.axes} />}
      {picture?.kind === "axes" && <Rails axes={picture.axes} />}
      {picture?.kind === "threads" && <Lanes turns={picture.turns} />}
    </svg>
  );
}

export function Gallery({ onChosen }: { onChosen?: () => void }) {
  const { value: language } = settings.language;
  const choose = (sample: Lesson) => {
    onChosen?.();
    showPanel("program");
    openSample(sample);
  };
  return (
    <ul class="gallery" aria-label={texts.value.welcome.samples}>
      {lessons.samples.value.map((sample) => (
        <li key={sample.id}>
          <button
            type="button"
            class="thumb"
            title={sample.text[language]}
            onClick={() => {
              choose(sample);
            }}
          >
            <Thumb picture={pictures[sample.id]} />
            <span>{sample.title[language]}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
