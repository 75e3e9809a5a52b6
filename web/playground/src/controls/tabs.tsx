// A few values in a row, of which one is chosen.

interface Choice<Value> {
  label: string;
  values: readonly Value[];
  chosen: Value;
  nameOf: (value: Value) => string;
  onChoose: (value: Value) => void;
}

export function Tabs<Value extends string | boolean>(choice: Choice<Value>) {
  const { label, values, chosen, nameOf, onChoose } = choice;
  return (
    <div class="tabs" role="group" aria-label={label}>
      {values.map((value) => (
        <button
          key={String(value)}
          type="button"
          class="tab"
          aria-pressed={value === chosen}
          onClick={() => {
            onChoose(value);
          }}
        >
          {nameOf(value)}
        </button>
      ))}
    </div>
  );
}
