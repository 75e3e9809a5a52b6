// A border that the pointer drags and the arrow keys move: of a column or of a panel.

import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { texts } from "../texts/texts.js";

/** So far an arrow key moves a border. */
const step = 16;

/** What the pointer leaves less than this part of its least size is closed. */
const closingPart = 0.5;

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
  isClosed?: boolean;
  /** Closes or opens what the border is of, if it can be closed. */
  onClose?: ((closes: boolean) => void) | undefined;
}

export function Splitter(props: Splitting) {
  const { class: kind, label, axis, isOfNext, measure, onPut, isClosed, onClose } = props;
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
  const drag = (wished: number) => {
    const closes = onClose !== undefined && wished < (now()?.least ?? 0) * closingPart;
    if (closes !== isClosed) onClose?.(closes);
    if (!closes) put(wished);
  };
  const walk = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    if (event.key === "Enter") onClose?.(!isClosed);
    const found = now();
    if (!found || isClosed) return;
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
      aria-valuemin={percent(Math.min(measured?.least ?? 0, measured?.own ?? 0))}
      aria-valuemax={percent(measured?.most)}
      title={onClose ? t.dragColumn : t.drag}
      onKeyDown={walk}
      onPointerDown={(event) => {
        const found = now();
        if (!found) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        held.current = { at: placeOf(event), own: found.own };
      }}
      onPointerMove={(event) => {
        const { current: from } = held;
        if (from) drag(from.own + sign * (placeOf(event) - from.at));
      }}
      onLostPointerCapture={() => {
        held.current = undefined;
      }}
      onDblClick={() => {
        onPut(undefined);
        onClose?.(false);
      }}
    />
  );
}
