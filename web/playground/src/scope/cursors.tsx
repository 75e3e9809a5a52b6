// The cursors: their times, and what is read at them.

import { present } from "../session/bench.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { titleOf, unitsOf } from "./channels.js";
import { readingOf } from "./readings.js";
import { drawn, putCursors, scope } from "./settings.js";
import type { Sweep } from "./trigger.js";

export function Cursors(props: { sweep: Sweep; onPut: (which: 0 | 1, time: number) => void }) {
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
              {drawn.value.map((channel) => {
                const { name } = channel;
                const { texts: read, gain, slope } = readingOf(sweep, channel, [a, b]);
                return (
                  <tr key={name} data-channel={name}>
                    <th scope="row">{titleOf(name, units)}</th>
                    <td class="number">{read[0]}</td>
                    <td class="number">{read[1]}</td>
                    <td class="number">{gain === undefined ? "" : number(gain)}</td>
                    <td class="number">{slope === undefined ? "" : number(slope)}</td>
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
