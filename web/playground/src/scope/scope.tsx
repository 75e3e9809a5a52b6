// The oscilloscope: controls, the screen with its cursors, and what can be saved.

import { useEffect, useRef, useState } from "preact/hooks";

import { useAsked } from "../session/asked.js";
import { bench, present, session } from "../session/bench.js";
import { save } from "../share/save.js";
import { isDark, settings } from "../store/settings.js";
import { source } from "../store/source.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { ChannelList } from "./channel_list.js";
import { csvOf, legendOf, unitsOf } from "./channels.js";
import { Controls } from "./controls.js";
import { Cursors } from "./cursors.js";
import { csvOfCycles, cyclesIn } from "./every_cycle.js";
import { Handles } from "./handles.js";
import { Plate } from "./plate.js";
import { divisionsHeight, lanesOf, Plot, screenPadding } from "./plot.js";
import { drawn, putCursors, scope, type Shown, sweepKey, sweepNow } from "./settings.js";
import type { Sweep } from "./trigger.js";

const emptySweep: Sweep = { fromMs: 0, toMs: 1000, endMs: 0, channels: [] };

function saveTable(name: string, csv: string): void {
  save(name, new Blob([csv], { type: "text/csv" }));
}

/** What the screen shows, with a row for each cycle. */
async function saveCycles(sweep: Sweep): Promise<void> {
  const { value: state } = present.state;
  if (!state) return;
  const names = sweep.channels.map(({ name }) => name);
  const units = unitsOf(present.card.value);
  try {
    const engine = await bench.engine();
    const csv = await csvOfCycles(engine, names, cyclesIn(sweep, state), units);
    saveTable("oncard-cycles.csv", csv);
  } catch {
    // The session was replaced or has ended; the status line says so.
  }
}

export function ScopePanel() {
  const { scope: t } = texts.value;
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<Plot>();
  const [size, setSize] = useState({ width: 600, height: 200 });
  const parts = Math.max(100, Math.round(size.width));
  const shown: Shown = useAsked(sweepKey(parts), () => sweepNow(parts), session.running.value) ?? {
    sweep: emptySweep,
  };
  const { sweep, trigger } = shown;
  const { value: cursors } = scope.cursors;
  const lanes = lanesOf(drawn.value).length;

  useEffect(() => {
    const { current } = host;
    if (!current) return undefined;
    const screen = new Plot(current);
    plot.current = screen;
    const watch = new ResizeObserver(() => {
      setSize({ width: current.clientWidth, height: current.clientHeight });
    });
    watch.observe(current);
    return () => {
      watch.disconnect();
      screen.destroy();
    };
  }, []);

  const look = isDark() ? "dark" : "light";
  useEffect(() => {
    if (size.width < 20 || size.height < 20) return;
    const { value: channels } = drawn;
    const scaleOf = channels.findIndex(({ name }) => name === scope.chosen.value);
    plot.current?.draw(
      sweep,
      channels,
      { cursors: scope.cursors.value ?? [], trigger, scaleOf },
      look,
    );
  }, [sweep, trigger, drawn.value, scope.chosen.value, scope.cursors.value, look, size]);

  const held = useRef<0 | 1>(0);
  const put = (which: 0 | 1, time: number) => {
    const [a, b] = scope.cursors.value ?? [sweep.fromMs, sweep.toMs];
    const at = Math.max(0, time);
    putCursors(which === 0 ? [at, b] : [a, at]);
  };

  return (
    <div class="scope">
      <Controls
        trigger={trigger}
        onCsv={() => {
          saveTable("oncard.csv", csvOf(sweep, unitsOf(present.card.value)));
        }}
        onCycles={() => {
          void saveCycles(sweep);
        }}
        onPng={() => {
          const { value: channels } = drawn;
          const legend = legendOf(sweep, channels, unitsOf(present.card.value));
          const { title } = source.lesson.value;
          const heading = `${title[settings.language.value]}, ${number(sweep.fromMs)} … ${number(sweep.toMs)} ms`;
          void plot.current?.picture(heading, legend).then((picture) => {
            if (picture) save("oncard.png", picture);
          });
        }}
      />
      <div class="scope-body">
        <ChannelList sweep={sweep} />
        <div
          class="screen-box"
          ref={(element) => {
            element?.style.setProperty("--lanes", String(lanes));
          }}
        >
          <div
            class="screen"
            data-to-ms={sweep.toMs}
            ref={host}
            role="img"
            aria-label={`${t.label}: ${scope.channels.value.map(({ name }) => name).join(", ")}`}
            onPointerDown={(event) => {
              const time = plot.current?.timeAt(event.clientX);
              if (time === undefined) return;
              event.currentTarget.setPointerCapture(event.pointerId);
              const [a, b] = scope.cursors.value ?? [sweep.fromMs, sweep.toMs];
              held.current = event.shiftKey || Math.abs(time - b) < Math.abs(time - a) ? 1 : 0;
              put(held.current, time);
            }}
            onPointerMove={(event) => {
              if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
              const time = plot.current?.timeAt(event.clientX);
              if (time !== undefined) put(held.current, time);
            }}
          />
          {cursors && (
            <Plate
              sweep={sweep}
              cursors={cursors}
              width={size.width - screenPadding.left - screenPadding.right}
              height={divisionsHeight(size.height, lanes)}
            />
          )}
          <Handles sweep={sweep} height={divisionsHeight(size.height, lanes)} />
        </div>
      </div>
      {scope.channels.value.length === 0 && <p class="muted small note">{t.none}</p>}
      <Cursors sweep={sweep} onPut={put} />
    </div>
  );
}
