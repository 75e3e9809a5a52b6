// The oscilloscope: controls, the screen, cursors with their readings, and what can be saved.

import { useEffect, useRef, useState } from "preact/hooks";

import { useAsked } from "../session/asked.js";
import { present, session } from "../session/bench.js";
import { isDark, settings } from "../store/settings.js";
import { source } from "../store/source.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { ChannelList } from "./channel_list.js";
import { csvOf, legendOf, readingAt, titleOf, unitsOf } from "./channels.js";
import { Controls } from "./controls.js";
import { Handles } from "./handles.js";
import { Plot, screenPadding } from "./plot.js";
import { drawn, putCursors, scope, type Shown, sweepKey, sweepNow } from "./settings.js";
import type { Sweep } from "./trigger.js";

const emptySweep: Sweep = { fromMs: 0, toMs: 1000, endMs: 0, channels: [] };

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
          save(
            "oncard.csv",
            new Blob([csvOf(sweep, unitsOf(present.card.value))], { type: "text/csv" }),
          );
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
        <div class="screen-box">
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
          <Handles sweep={sweep} height={size.height - screenPadding.top - screenPadding.bottom} />
        </div>
      </div>
      {scope.channels.value.length === 0 && <p class="muted small note">{t.none}</p>}
      <Cursors sweep={sweep} onPut={put} />
    </div>
  );
}

function Cursors(props: { sweep: Sweep; onPut: (which: 0 | 1, time: number) => void }) {
  const { sweep, onPut } = props;
  const { scope: t } = texts.value;
  const isOn = scope.cursors.value !== undefined;
  const [a, b] = scope.cursors.value ?? [0, 0];
  const units = unitsOf(present.card.value);
  const step = (sweep.toMs - sweep.fromMs) / 200;
  return (
    <div class="cursors">
      <label class="row small">
        <input
          type="checkbox"
          checked={isOn}
          onChange={({ currentTarget }) => {
            const quarter = (sweep.toMs - sweep.fromMs) / 4;
            putCursors(
              currentTarget.checked ? [sweep.fromMs + quarter, sweep.toMs - quarter] : undefined,
            );
          }}
        />
        {t.cursors}
      </label>
      {isOn && (
        <div class="scroll" tabIndex={0} role="group" aria-label={t.cursors}>
          <table class="values">
            <thead>
              <tr>
                <th scope="col">{t.channel}</th>
                {[a, b].map((time, index) => {
                  const name = index === 0 ? "A" : "B";
                  return (
                    <th key={name} scope="col" class="number">
                      <label>
                        {name}{" "}
                        <input
                          type="number"
                          class="cursor-time"
                          aria-label={`${t.cursor(name)}, ms`}
                          step={step}
                          value={number(time)}
                          onInput={({ currentTarget }) => {
                            const to = currentTarget.valueAsNumber;
                            if (Number.isFinite(to)) onPut(index === 0 ? 0 : 1, to);
                          }}
                        />{" "}
                        ms
                      </label>
                    </th>
                  );
                })}
                <th scope="col" class="number">
                  {t.difference} {number(b - a)} ms
                  {b !== a && `, ${number(1000 / Math.abs(b - a))} Hz`}
                </th>
                <th scope="col" class="number">
                  {t.slope}
                </th>
              </tr>
            </thead>
            <tbody>
              {scope.channels.value.map(({ name }) => {
                const atA = readingAt(sweep, name, a)?.largest;
                const atB = readingAt(sweep, name, b)?.largest;
                const both = atA !== undefined && atB !== undefined;
                return (
                  <tr key={name} data-channel={name}>
                    <th scope="row">{titleOf(name, units)}</th>
                    <td class="number">{atA === undefined ? "" : number(atA)}</td>
                    <td class="number">{atB === undefined ? "" : number(atB)}</td>
                    <td class="number">{both ? number(atB - atA) : ""}</td>
                    <td class="number">{both && b !== a ? number((atB - atA) / (b - a)) : ""}</td>
                  </tr>
                );
              })}
            </tbody>
          </table>
        </div>
      )}
    </div>
  );
}

function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => {
    URL.revokeObjectURL(link.href);
  }, 1000);
}
