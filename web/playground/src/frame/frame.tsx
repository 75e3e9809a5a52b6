// The columns of the page, as wide as the layout wants them or the reader has made them, and the
// button with which a panel fills it.

import type { ColumnName } from "../store/arrangement.js";
import {
  closeColumn,
  openColumn,
  placesOf,
  type Side,
  sides,
  widen,
  type WholePanel,
} from "../store/places.js";
import { texts } from "../texts/texts.js";
import { Column, type Panels } from "./column.js";
import {
  canClose,
  closedColumns,
  fillPage,
  layoutName,
  namedLayout,
  wholePanel,
} from "./current.js";
import { type Measured, Splitter } from "./splitter.js";

/** Columns stay at least so wide, in pixels: what they show still has room there. */
const least = { left: 240, middle: 240, right: 400 };

export function Frame({ class: kind, ...panels }: Panels & { class: string }) {
  const { value: layout } = layoutName;
  const places = placesOf(layout);
  return (
    <main
      class={kind}
      data-layout={namedLayout.value}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || event.defaultPrevented || !wholePanel.peek()) return;
        event.preventDefault();
        fillPage(undefined);
      }}
      ref={(element) => {
        for (const side of sides) {
          const { [side]: part } = places;
          // In a narrower window the columns share what there is beyond that.
          const from = `min(${least[side]}px, 50%)`;
          const track = part === undefined ? "" : `minmax(${from}, ${(100 * part).toFixed(2)}%)`;
          element?.style.setProperty(`--${side}`, track);
        }
        const isChosen = sides.some((side) => places[side] !== undefined);
        element?.style.setProperty("--least", isChosen ? `${least.middle}px` : "");
      }}
    >
      <Column name="left" {...panels} />
      <ColumnSplitter key={`left ${layout}`} layout={layout} side="left" />
      <Column name="middle" {...panels} />
      <ColumnSplitter key={`right ${layout}`} layout={layout} side="right" />
      <Column name="right" {...panels} />
    </main>
  );
}

/** What takes the room that the column at this side leaves; undefined: only rails are there. */
function takerBeside(side: Side): ColumnName | undefined {
  const { value: closed } = closedColumns;
  if (!closed.includes("middle")) return "middle";
  return side === "left" && !closed.includes("right") ? "right" : undefined;
}

function ColumnSplitter({ layout, side }: { layout: string; side: Side }) {
  if (!takerBeside(side)) return null;
  const isClosed = closedColumns.value.includes(side);
  const put = (closes: boolean) => {
    if (closes) closeColumn(layout, side);
    else openColumn(layout, side);
  };
  return (
    <Splitter
      class={side}
      label={texts.value.frame[side]}
      axis="x"
      isOfNext={side === "right"}
      measure={(splitter) => widthOf(splitter.parentElement, side)}
      onPut={(part) => {
        widen(layout, side, part);
      }}
      isClosed={isClosed}
      onClose={isClosed || canClose.value ? put : undefined}
    />
  );
}

function widthOf(page: HTMLElement | null, side: Side): Measured | undefined {
  const of = (name: string) =>
    page?.querySelector(`.column.${name}`)?.getBoundingClientRect().width ?? 0;
  const own = of(side);
  const taker = takerBeside(side);
  if (!page || !taker || own === 0) return undefined;
  const { paddingLeft, paddingRight } = getComputedStyle(page);
  const whole = page.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
  const most = Math.max(own, own + of(taker) - least[taker]);
  return { own, least: least[side], most, whole };
}

/** Lets a panel fill the page, or shows the others again. */
export function WholeButton({ panel, title }: { panel: WholePanel; title: string }) {
  const { frame: t } = texts.value;
  const isWhole = wholePanel.value === panel;
  return (
    <button
      type="button"
      class="quiet"
      aria-label={`${t.whole}: ${title}`}
      aria-pressed={isWhole}
      title={isWhole ? t.all : t.whole}
      onClick={() => {
        fillPage(isWhole ? undefined : panel);
      }}
    >
      <svg viewBox="0 0 16 16" aria-hidden="true">
        <path d={isWhole ? "M2 6h4V2M14 10h-4v4" : "M2 6V2h4M14 10v4h-4"} />
      </svg>
    </button>
  );
}
