// What the cursors say of the chosen channel, on the screen where the least of the curves is. The table
// below says the same of all channels, to keyboards and screen readers, too.

import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { present } from "../session/bench.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { unitsOf } from "./channels.js";
import { type Corner, emptiestCorner } from "./corner.js";
import { perMs, readingOf } from "./readings.js";
import { drawn, scope } from "./settings.js";
import type { Sweep } from "./trigger.js";

interface Props {
  sweep: Sweep;
  cursors: [number, number];
  /** Of all divisions, in pixels. */
  width: number;
  height: number;
}

export function Plate({ sweep, cursors, width, height }: Props) {
  const { plate: t } = texts.value.scope;
  const element = useRef<HTMLDListElement>(null);
  const [size, setSize] = useState({ width: 0, height: 0 });
  const corner = useRef<Corner>();
  // As large as its texts, after whatever has changed them.
  useLayoutEffect(() => {
    const { offsetWidth = 0, offsetHeight = 0 } = element.current ?? {};
    if (offsetWidth === size.width && offsetHeight === size.height) return;
    setSize({ width: offsetWidth, height: offsetHeight });
  });
  const parts = { width: size.width / width, height: size.height / height };
  corner.current = emptiestCorner(sweep, drawn.value, parts, corner.current);

  const [a, b] = cursors;
  const index = drawn.value.findIndex(({ name }) => name === scope.chosen.value);
  const channel = drawn.value[index];
  const { gain, slope } = channel ? readingOf(sweep, channel, cursors) : {};
  const unit = unitsOf(present.card.value).get(scope.chosen.value);
  const rows = [
    [t.time, `${number(b - a)} ms`],
    [t.frequency, a !== b && `${number(1000 / Math.abs(b - a))} Hz`],
    [t.gain, gain !== undefined && `${number(gain)} ${unit ?? ""}`],
    [t.slope, slope !== undefined && `${number(slope)} ${perMs(unit)}`],
  ] as const;
  return (
    <dl class={`plate ${corner.current} of${index % 8}`} ref={element} aria-hidden="true">
      {rows.map(
        ([name, value]) =>
          value !== false && (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ),
      )}
    </dl>
  );
}
