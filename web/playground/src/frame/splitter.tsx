// A border that the pointer drags and the arrow keys move: of a column or of a panel.

import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { texts } from "../texts/texts.js";

/** So far an arrow key moves a border. */
const step = 16;

/** What a border makes wider or higher, in pixels. */
export interface Measured {
  own: number;
  least: number;
  most: number;
  /** Of what the border gives a part. */
  whole: number;
}

interface Splitting {
  class: string;
  label: string;
  /** Between parts that lie beside each other, or below each other. */
  axis: "x" | "y";
  /** What lies after the border grows when it moves back. */
  isOfNext?: boolean;
  measure: (splitter: HTMLElement) => Measured | undefined;
  /** Gives what the border is of a part of the whole; undefined: as much as usual. */
  onPut: (part: number | undefined) => void;
}

export function Splitter({ class: kind, label, axis, isOfNext, measure, onPut }: Splitting) {
  const { frame: t } = texts.value;
  const element = useRef<HTMLDivElement>(null);
  const [measured, setMeasured] = useState<Measured>();
  const held = useRef<{ at: number; own: number }>();
  const sign = isOfNext ? -1 : 1;
  const now = () => (element.current ? measure(element.current) : undefined);

  useLayoutEffect(() => {
    const watch = new ResizeObserver(() => {
      setMeasured(now());
    });
    for (const part of element.current?.parentElement?.children ?? []) watch.observe(part);
    return () => {
      watch.disconnect();
    };
  }, []);

  const put = (wished: number) => {
    const found = now();
    if (!found) return;
    onPut(Math.min(found.most, Math.max(found.least, wished)) / found.whole);
  };
  const placeOf = (event: TargetedPointerEvent<HTMLDivElement>) =>
    axis === "x" ? event.clientX : event.clientY;
  const walk = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    const found = now();
    if (!found) return;
    const wishes: Record<string, number> = {
      [axis === "x" ? "ArrowLeft" : "ArrowUp"]: found.own - sign * step,
      [axis === "x" ? "ArrowRight" : "ArrowDown"]: found.own + sign * step,
      Home: found.least,
      End: found.most,
    };
    const wished = wishes[event.key];
    if (wished === undefined) return;
    event.preventDefault();
    put(wished);
  };
  const percent = (size = 0) => Math.round((100 * size) / (measured?.whole ?? 1));
  return (
    <div
      ref={element}
      class={`splitter ${kind}`}
      role="separator"
      tabIndex={0}
      aria-orientation={axis === "x" ? "vertical" : "horizontal"}
      aria-label={label}
      aria-valuenow={percent(measured?.own)}
      aria-valuemin={percent(measured?.least)}
      aria-valuemax={percent(measured?.most)}
      title={t.drag}
      onKeyDown={walk}
      onPointerDown={(event) => {
        const found = now();
        if (!found) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        held.current = { at: placeOf(event), own: found.own };
      }}
      onPointerMove={(event) => {
        const { current: from } = held;
        if (from) put(from.own + sign * (placeOf(event) - from.at));
      }}
      onLostPointerCapture={() => {
        held.current = undefined;
      }}
      onDblClick={() => {
        onPut(undefined);
      }}
    />
  );
}
