// The knobs of the scope: sweep, time, trigger.

import type { ComponentChildren } from "preact";

import { record } from "../session/record.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import {
  arm,
  drawnSource,
  type Mode,
  modes,
  scope,
  spans,
  triggers,
  turnKnobs,
} from "./settings.js";
import type { Edge } from "./trigger.js";

function Knob(props: { label: string; children: ComponentChildren }) {
  return (
    <label class="knob">
      <span>{props.label}</span>
      {props.children}
    </label>
  );
}

export function Controls(props: {
  trigger: number | undefined;
  onCsv: () => void;
  onCycles: () => void;
  onPng: () => void;
}) {
  const { scope: t } = texts.value;
  return (
    <div class="bar wrap">
      <Knob label={t.mode}>
        <select
          value={scope.mode.value}
          onChange={({ currentTarget }) => {
            turnKnobs({ mode: currentTarget.value as Mode });
          }}
        >
          {modes.map((each) => (
            <option key={each} value={each}>
              {t.modes[each]}
            </option>
          ))}
        </select>
      </Knob>
      {scope.mode.value !== "whole" && (
        <Knob label={t.span}>
          <select
            value={scope.spanMs.value}
            onChange={({ currentTarget }) => {
              turnKnobs({ spanMs: Number(currentTarget.value) });
            }}
          >
            {spans.map((each) => (
              <option key={each} value={each}>
                {each} ms
              </option>
            ))}
          </select>
        </Knob>
      )}
      {triggers.value && <TriggerKnobs />}
      {scope.mode.value === "single" && (
        <button type="button" onClick={arm}>
          {t.arm}
        </button>
      )}
      {triggers.value && (
        <output class="small muted">
          {props.trigger === undefined ? t.armed : t.triggered(number(props.trigger))}
        </output>
      )}
      <div class="row scope-files">
        <button type="button" class="quiet" aria-label={t.csvLabel} onClick={props.onCsv}>
          {t.csv}
        </button>
        {/* The host of a GT400 card changes how long its cycles are. */}
        {!record.value && (
          <button type="button" class="quiet" aria-label={t.cyclesLabel} onClick={props.onCycles}>
            {t.cycles}
          </button>
        )}
        <button type="button" class="quiet" aria-label={t.pngLabel} onClick={props.onPng}>
          {t.png}
        </button>
      </div>
    </div>
  );
}

function TriggerKnobs() {
  const { scope: t } = texts.value;
  return (
    <>
      <Knob label={t.source}>
        <select
          value={scope.source.value}
          onChange={({ currentTarget }) => {
            turnKnobs({ source: currentTarget.value });
          }}
        >
          {scope.channels.value.map(({ name }) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </Knob>
      {!drawnSource.value?.isDigital && (
        <Knob label={t.level}>
          <input
            type="number"
            step="any"
            class="narrow"
            value={scope.level.value}
            onInput={({ currentTarget }) => {
              const to = currentTarget.valueAsNumber;
              if (Number.isFinite(to)) turnKnobs({ level: to });
            }}
          />
        </Knob>
      )}
      <Knob label={t.edge}>
        <select
          value={scope.edge.value}
          onChange={({ currentTarget }) => {
            turnKnobs({ edge: currentTarget.value as Edge });
          }}
        >
          {(["rising", "falling", "either"] as const).map((each) => (
            <option key={each} value={each}>
              {t.edges[each]}
            </option>
          ))}
        </select>
      </Knob>
      <Knob label={t.pre}>
        <select
          value={scope.before.value}
          onChange={({ currentTarget }) => {
            turnKnobs({ before: Number(currentTarget.value) });
          }}
        >
          {[0, 0.1, 0.25, 0.5, 0.75, 0.9].map((each) => (
            <option key={each} value={each}>
              {each * 100} %
            </option>
          ))}
        </select>
      </Knob>
    </>
  );
}
