// The adapter's own words, in the language of the editor. What an engine says comes in that language
// by itself.

import type { State, Stop } from "@oncard/engine";

export interface Text {
  en: string;
  zh: string;
}

/** A mistake of the user, to be shown as it is. */
export class UserError extends Error {
  readonly text: Text;

  constructor(text: Text) {
    super(text.en);
    this.text = text;
  }
}

const overTexts: Record<NonNullable<State["over"]>, Text> = {
  quiet: { en: "the run is over: every thread has ended", zh: "运行结束：所有线程均已结束" },
  until: {
    en: "the run is over: the scenario's time has come",
    zh: "运行结束：已到场景规定的时刻",
  },
  "time-limit": { en: "the run is over: the time limit", zh: "运行结束：已到时间上限" },
  deadlock: { en: "the run is over: a deadlock", zh: "运行结束：死锁" },
  "host-end": { en: "the run is over: the host has ended", zh: "运行结束：主机程序已结束" },
};

const stopTexts: Partial<Record<Stop["reason"], Text>> = {
  change: { en: "a value has changed", zh: "值已改变" },
  fault: { en: "the thread has faulted", zh: "线程出错" },
  refusal: { en: "a command was refused", zh: "命令被拒绝" },
  requirement: { en: "a requirement does not hold", zh: "要求不成立" },
  warning: { en: "a warning of the card", zh: "控制卡的警告" },
  deviation: { en: "the card answers otherwise", zh: "控制卡的回答不同" },
  "schedule-end": {
    en: "the recording is over; the scenario's policy goes on",
    zh: "记录已结束；此后按场景的调度策略运行",
  },
  start: { en: "this is the beginning", zh: "已到起点" },
  budget: { en: "paused", zh: "已暂停" },
};

/** Why the card stands, or nothing if the user asked for just that. */
export function describeStop(stop: Stop, state: State): Text | undefined {
  if (stop.reason === "end" || (stop.reason === "goal" && state.over)) {
    return state.over && overTexts[state.over];
  }
  const own = stopTexts[stop.reason];
  if (!stop.text) return own;
  if (!own) return { en: stop.text, zh: stop.text };
  return { en: `${own.en}: ${stop.text}`, zh: `${own.zh}：${stop.text}` };
}
