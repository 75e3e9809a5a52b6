// The border of a column, which the pointer drags and the arrow keys move.

import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { type Side, widen } from "../store/places.js";
import { texts } from "../texts/texts.js";

/** Columns stay at least so wide, in pixels: what they show still has room there. */
export const least = { left: 240, middle: 240, right: 400 };
/** So far an arrow key moves the border. */
const step = 16;

interface Measured {
  /** The width of the column, and how wide it can be. */
  own: number;
  most: number;
  /** That of all columns. */
  whole: number;
}

function measure(splitter: HTMLElement | null, side: Side): Measured | undefined {
  const page = splitter?.parentElement;
  const widthOf = (name: string) =>
    page?.querySelector(`.column.${name}`)?.getBoundingClientRect().width ?? 0;
  const own = widthOf(side);
  const beside = widthOf("middle");
  if (!page || own === 0) return undefined;
  const { paddingLeft, paddingRight } = getComputedStyle(page);
  const whole = page.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
  return { own, most: Math.max(own, own + beside - least.middle), whole };
}

export function Splitter({ layout, side }: { layout: string; side: Side }) {
  const { frame: t } = texts.value;
  const element = useRef<HTMLDivElement>(null);
  const [measured, setMeasured] = useState<Measured>();
  const held = useRef<{ x: number; own: number }>();
  // To the right, the left column grows and the right one shrinks.
  const sign = side === "left" ? 1 : -1;

  useLayoutEffect(() => {
    const watch = new ResizeObserver(() => {
      setMeasured(measure(element.current, side));
    });
    const page = element.current?.parentElement;
    for (const column of page?.querySelectorAll(".column") ?? []) watch.observe(column);
    return () => {
      watch.disconnect();
    };
  }, []);

  const put = (wished: number) => {
    const now = measure(element.current, side);
    if (!now) return;
    widen(layout, side, Math.min(now.most, Math.max(least[side], wished)) / now.whole);
  };
  const drag = (event: TargetedPointerEvent<HTMLDivElement>) => {
    const { current: from } = held;
    if (from) put(from.own + sign * (event.clientX - from.x));
  };
  const walk = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    const now = measure(element.current, side);
    if (!now) return;
    const wishes: Record<string, number> = {
      ArrowLeft: now.own - sign * step,
      ArrowRight: now.own + sign * step,
      Home: least[side],
      End: now.most,
    };
    const wished = wishes[event.key];
    if (wished === undefined) return;
    event.preventDefault();
    put(wished);
  };
  const percent = (width: number) => Math.round((100 * width) / (measured?.whole ?? 1));
  return (
    <div
      ref={element}
      class={`splitter ${side}`}
      role="separator"
      tabIndex={0}
      aria-orientation="vertical"
      aria-label={t[side]}
      aria-valuenow={percent(measured?.own ?? 0)}
      aria-valuemin={percent(measured ? least[side] : 0)}
      aria-valuemax={percent(measured?.most ?? 0)}
      title={t.drag}
      onKeyDown={walk}
      onPointerDown={(event) => {
        const now = measure(element.current, side);
        if (!now) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        held.current = { x: event.clientX, own: now.own };
      }}
      onPointerMove={drag}
      onLostPointerCapture={() => {
        held.current = undefined;
      }}
      onDblClick={() => {
        widen(layout, side, undefined);
      }}
    />
  );
}
