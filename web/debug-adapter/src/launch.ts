// What a launch configuration says.

import { resolve } from "node:path";

import { UserError } from "./texts.js";

export interface LaunchConfig {
  /** Absolute path of a program, a scenario or a recording. */
  program: string;
  stopOnEntry: boolean;
  /** A function whose first statement the run stops at, once. */
  stopAtFunction: string | undefined;
  /** The program is structured C. */
  structured: boolean;
  /** Nothing stops the run. */
  noDebug: boolean;
  /** The command that is the engine. */
  oncard: string;
  /** Path of the WebAssembly module that is the engine instead of it. */
  module: string | undefined;
}

/** @throws UserError for a member that is missing or has another type */
export function readLaunchConfig(
  config: Readonly<Record<string, unknown>>,
  environment: Readonly<Record<string, string | undefined>>,
): LaunchConfig {
  const program = textIn(config, "program");
  if (program === undefined) {
    throw new UserError({
      en: "the launch configuration lacks 'program': the path of a .c, .toml or .schedule file",
      zh: "启动配置缺少“program”：应为 .c、.toml 或 .schedule 文件的路径",
    });
  }
  const oncard = textIn(config, "oncard") ?? environment["ONCARD"];
  return {
    program: resolve(program),
    stopOnEntry: flagIn(config, "stopOnEntry"),
    stopAtFunction: textIn(config, "stopAtFunction"),
    structured: flagIn(config, "structured"),
    noDebug: flagIn(config, "noDebug"),
    oncard: oncard ?? "oncard",
    module: oncard === undefined ? environment["ONCARD_MODULE"] : undefined,
  };
}

function textIn(config: Readonly<Record<string, unknown>>, name: string): string | undefined {
  const value = config[name];
  if (value === undefined || (typeof value === "string" && value !== "")) return value;
  throw new UserError({
    en: `'${name}' of the launch configuration must be a text that is not empty`,
    zh: `启动配置的“${name}”应为非空文本`,
  });
}

function flagIn(config: Readonly<Record<string, unknown>>, name: string): boolean {
  const value = config[name];
  if (value === undefined || typeof value === "boolean") return value ?? false;
  throw new UserError({
    en: `'${name}' of the launch configuration must be true or false`,
    zh: `启动配置的“${name}”应为 true 或 false`,
  });
}
