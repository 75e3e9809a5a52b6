// Values that come from outside, checked with a validator of their schema, and the mistakes in them
// in words. Tested by test/checked.test.ts.

import type { ErrorObject, ValidateFunction } from "ajv";

/** A text in both languages. */
export interface Localized {
  en: string;
  zh: string;
}

/** Why a value is not what was expected. */
export interface Mistake {
  /** The place, for example `hints[1].en`; empty for the whole. */
  where: string;
  message: Localized;
}

export type Checked<Type> = { value: Type } | { mistakes: Mistake[] };

/** No more mistakes are reported. */
const mostMistakes = 20;
/** The largest lesson has fewer lists, tables and values. A validator notes every mistake of a value. */
const mostValues = 1000;
/** Of names that are shown. */
const longestName = 64;

/** Checks a value. All mistakes are reported at once, up to a limit. */
export function checked<Type>(isType: ValidateFunction<Type>, value: unknown): Checked<Type> {
  if (hasMoreValues(value, mostValues)) {
    const message = {
      en: `it has more than ${mostValues} values`,
      zh: `其中的值超过 ${mostValues} 个`,
    };
    return { mistakes: [{ where: "", message }] };
  }
  if (isType(value)) return { value };
  return { mistakes: (isType.errors ?? []).flatMap(mistakeOf).slice(0, mostMistakes) };
}

function hasMoreValues(value: unknown, most: number): boolean {
  const left = [value];
  for (let values = 0; left.length > 0; ++values) {
    if (values === most) return true;
    const next = left.pop();
    if (typeof next !== "object" || next === null) continue;
    const parts: unknown[] = Object.values(next);
    if (parts.length > most) return true;
    left.push(...parts);
  }
  return false;
}

function mistakeOf(error: ErrorObject): Mistake[] {
  // What is wrong with a name is said once, of the table.
  if (error.propertyName !== undefined) return [];
  const { missingProperty } = error.params as { missingProperty?: string };
  const steps = error.instancePath.split("/").slice(1).map(stepOf);
  if (missingProperty !== undefined) steps.push(missingProperty);
  return [{ where: placeOf(steps), message: messageOf(error) }];
}

/** A step of a JSON Pointer. */
function stepOf(escaped: string): string {
  return escaped.replaceAll("~1", "/").replaceAll("~0", "~");
}

function placeOf(steps: string[]): string {
  return steps
    .map((step, index) => (/^\d+$/.test(step) ? `[${step}]` : index === 0 ? step : `.${step}`))
    .join("");
}

/** What messages need of the schema in which a rule stands. */
interface Rule {
  /** In words, for rules that cannot speak for themselves, such as patterns. */
  expected?: Localized;
  properties?: object;
}

const types: Record<string, Localized> = {
  object: { en: "expected an object", zh: "应为对象" },
  array: { en: "expected a list", zh: "应为列表" },
  string: { en: "expected a text", zh: "应为文本" },
  boolean: { en: "expected true or false", zh: "应为 true 或 false" },
  number: { en: "expected a number", zh: "应为数" },
  integer: { en: "expected an integer", zh: "应为整数" },
};

const unexpected: Localized = { en: "this was not expected", zh: "不符合要求" };

/** What a rule of a schema says of a value that breaks it. */
function messageOf({ keyword, params, parentSchema, data }: ErrorObject): Localized {
  const { expected = unexpected, properties = {} } = (parentSchema ?? {}) as Rule;
  const most = (params as { limit: number }).limit;
  switch (keyword) {
    case "type":
      return types[(params as { type: string }).type] ?? expected;
    case "required":
      return { en: "it is missing", zh: "缺少此项" };
    case "const":
      return oneOf([(params as { allowedValue: unknown }).allowedValue]);
    case "enum":
      return oneOf((params as { allowedValues: unknown[] }).allowedValues);
    case "maxLength": {
      const { length } = data as string;
      return {
        en: `the text has ${length} characters; at most ${most} are allowed`,
        zh: `文本有 ${length} 个字符，最多允许 ${most} 个`,
      };
    }
    case "maxItems": {
      const { length } = data as unknown[];
      return {
        en: `the list has ${length} elements; at most ${most} are allowed`,
        zh: `列表有 ${length} 个元素，最多允许 ${most} 个`,
      };
    }
    case "maxProperties": {
      const { length } = Object.keys(data as object);
      return {
        en: `there are ${length} entries; at most ${most} are allowed`,
        zh: `共有 ${length} 项，最多允许 ${most} 项`,
      };
    }
    case "additionalProperties": {
      const { additionalProperty: key } = params as { additionalProperty: string };
      const known = Object.keys(properties);
      return {
        en: `unknown key '${shown(key)}'; expected ${known.join(", ")}`,
        zh: `未知的键“${shown(key)}”；可用的键为 ${known.join("、")}`,
      };
    }
    case "propertyNames": {
      const { propertyName: name } = params as { propertyName: string };
      return { en: `'${shown(name)}': ${expected.en}`, zh: `“${shown(name)}”：${expected.zh}` };
    }
    default:
      return expected;
  }
}

function shown(name: string): string {
  return name.slice(0, longestName);
}

function oneOf(values: unknown[]): Localized {
  const quoted = values.map((value) => (typeof value === "string" ? `'${value}'` : String(value)));
  return { en: `expected ${quoted.join(" or ")}`, zh: `应为 ${values.map(String).join(" 或 ")}` };
}
