// How fast a run is: a slider, or a list where the bar has no room for one.

import {
  chooseSpeed,
  fastest,
  placeOfSpeed,
  settings,
  slowest,
  speedAt,
  speeds,
} from "../store/settings.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";

export function Speed() {
  const { controls: t } = texts.value;
  const { value: now } = settings.speed;
  const textOf = (speed: number) => (speed === Infinity ? t.max : `${number(speed)}×`);
  const listed = speeds.includes(now) ? speeds : [...speeds, now].sort((a, b) => a - b);
  return (
    <>
      <label class="knob slider">
        <input
          type="range"
          min={slowest}
          max={fastest}
          list="speeds"
          aria-label={t.speed}
          aria-valuetext={textOf(now)}
          title={t.speed}
          value={placeOfSpeed(now)}
          onInput={({ currentTarget }) => {
            chooseSpeed(speedAt(currentTarget.valueAsNumber));
          }}
        />
        <datalist id="speeds">
          {speeds.map((each) => (
            <option key={each} value={placeOfSpeed(each)} />
          ))}
        </datalist>
        <strong>{textOf(now)}</strong>
      </label>
      <label class="knob list">
        <select
          aria-label={t.speed}
          title={t.speed}
          value={String(now)}
          onChange={({ currentTarget }) => {
            chooseSpeed(Number(currentTarget.value));
          }}
        >
          {listed.map((each) => (
            <option key={each} value={String(each)}>
              {textOf(each)}
            </option>
          ))}
        </select>
      </label>
    </>
  );
}
