// The columns of the page, as wide as the layout wants them or the reader has made them.

import type { ComponentChildren } from "preact";

import { widthsOf, sides } from "../store/places.js";
import { layoutName, namedLayout } from "./current.js";
import { least, Splitter } from "./splitter.js";

interface Columns {
  class: string;
  left: ComponentChildren;
  middle: ComponentChildren;
  right: ComponentChildren;
}

export function Frame({ class: kind, left, middle, right }: Columns) {
  const { value: layout } = layoutName;
  const widths = widthsOf(layout);
  return (
    <main
      class={kind}
      data-layout={namedLayout.value}
      ref={(element) => {
        for (const side of sides) {
          const { [side]: part } = widths;
          // In a narrower window the columns share what there is beyond that.
          const from = `min(${least[side]}px, 50%)`;
          const track = part === undefined ? "" : `minmax(${from}, ${(100 * part).toFixed(2)}%)`;
          element?.style.setProperty(`--${side}`, track);
        }
        const isChosen = Object.keys(widths).length > 0;
        element?.style.setProperty("--least", isChosen ? `${least.middle}px` : "");
      }}
    >
      <div class="column left">{left}</div>
      <Splitter key={`left ${layout}`} layout={layout} side="left" />
      <div class="column middle">{middle}</div>
      <Splitter key={`right ${layout}`} layout={layout} side="right" />
      <div class="column right">{right}</div>
    </main>
  );
}
