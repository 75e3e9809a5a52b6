// The record of a host that is on the card: how far its calls are, and its motion programs.

import { present } from "../session/bench.js";
import { chooseOpening, closeRecord, type OpenRecord } from "../session/record.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";

export function RecordPanel({ opened }: { opened: OpenRecord }) {
  const { record: t } = texts.value;
  const host = present.state.value?.host;
  const { made = 0, calls = 0, last, next, next_ms: nextMs } = host ?? {};
  return (
    <div class="record scroll" tabIndex={0} role="group" aria-label={t.title}>
      <div class="row">
        <strong class="grow">{opened.name}</strong>
        <button type="button" class="quiet" onClick={() => void closeRecord()}>
          {t.close}
        </button>
      </div>
      {opened.cards.length > 1 && (
        <select
          aria-label={t.openings}
          value={opened.chosen}
          onChange={({ currentTarget }) => void chooseOpening(Number(currentTarget.value))}
        >
          {opened.cards.map(({ card, opening, calls: count }, index) => (
            <option key={index} value={index}>
              {t.opening(card, opening, count)}
            </option>
          ))}
        </select>
      )}
      <p class="muted small">{t.help}</p>
      <progress aria-label={t.made(made, calls)} max={calls} value={made} />
      <p class="small">{t.made(made, calls)}</p>
      <table class="values">
        <tbody>
          <Call title={t.last} call={last} />
          <Call title={t.next} call={next} at={nextMs} />
        </tbody>
      </table>
      {opened.sources.length > 0 && <h3>{t.sources}</h3>}
      {opened.sources.map(({ path, text }) => (
        <details key={path}>
          <summary class="small">{path}</summary>
          <pre>{text}</pre>
        </details>
      ))}
    </div>
  );
}

function Call(props: { title: string; call: string | undefined; at?: number | undefined }) {
  const { record: t } = texts.value;
  const { title, call, at } = props;
  return (
    <tr>
      <th scope="row">{title}</th>
      <td>{call === undefined ? <span class="muted">{t.none}</span> : <code>{call}</code>}</td>
      <td class="number muted">{at !== undefined && t.at(number(at))}</td>
    </tr>
  );
}
