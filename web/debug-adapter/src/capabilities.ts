// What the adapter can do, as it tells the editor first.

import type { DebugProtocol } from "@vscode/debugprotocol";

import type { Editor } from "./editor.js";
import { type Filter, usualFilters } from "./stops.js";
import type { Text } from "./texts.js";

const filterLabels: Record<Filter, Text> = {
  fault: { en: "faults of threads", zh: "线程出错" },
  refusal: { en: "refused commands", zh: "命令被拒绝" },
  requirement: { en: "requirements that do not hold", zh: "要求不成立" },
  race: { en: "data races", zh: "数据竞争" },
  warning: { en: "warnings of the card", zh: "控制卡的警告" },
};

export function capabilities(editor: Editor): DebugProtocol.Capabilities {
  const filter = (name: Filter) => ({
    filter: name,
    label: editor.say(filterLabels[name]),
    default: usualFilters.includes(name),
  });
  return {
    supportsConfigurationDoneRequest: true,
    supportsTerminateRequest: true,
    supportsRestartRequest: true,
    supportsConditionalBreakpoints: true,
    supportsHitConditionalBreakpoints: true,
    supportsLogPoints: true,
    supportsFunctionBreakpoints: true,
    supportsDataBreakpoints: true,
    supportsInstructionBreakpoints: true,
    supportsExceptionInfoRequest: true,
    exceptionBreakpointFilters: [
      filter("fault"),
      filter("refusal"),
      filter("requirement"),
      filter("race"),
      filter("warning"),
    ],
    supportsStepBack: true,
    supportsSteppingGranularity: true,
    supportsGotoTargetsRequest: true,
    supportsEvaluateForHovers: true,
    supportsCompletionsRequest: true,
    completionTriggerCharacters: [".", "["],
    supportsSetVariable: true,
    supportsSetExpression: true,
    supportsLoadedSourcesRequest: true,
    supportsDisassembleRequest: true,
    supportsReadMemoryRequest: true,
  };
}
