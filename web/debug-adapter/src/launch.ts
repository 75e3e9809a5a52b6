// What a launch configuration says.

import { resolve } from "node:path";

import { UserError } from "./texts.js";

/** A host program that is run and recorded first. */
export interface HostRun {
  /** The program and its arguments. */
  command: string[];
  /** Absolute paths. */
  scenario: string | undefined;
  folder: string;
}

export interface LaunchConfig {
  /** Absolute path of a program, a scenario, a recording or a record of host calls, or of a host. */
  program: string;
  host: HostRun | undefined;
  /** Of a record of host calls. */
  card: number | undefined;
  stopOnEntry: boolean;
  /** A function whose first statement the run stops at, once. */
  stopAtFunction: string | undefined;
  /** Stand after this statement of the run, counted from 1. */
  stopAtStatement: number | undefined;
  /** The program is structured C. */
  structured: boolean;
  /** Names of warnings of the card that are left out. */
  silent: string[];
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
      en: "the launch configuration lacks 'program': the path of a .c, .toml, .schedule or .calls file",
      zh: "启动配置缺少“program”：应为 .c、.toml、.schedule 或 .calls 文件的路径",
    });
  }
  const oncard = textIn(config, "oncard") ?? environment["ONCARD"];
  return {
    program: resolve(program),
    host: undefined,
    card: cardIn(config),
    stopOnEntry: flagIn(config, "stopOnEntry"),
    stopAtFunction: textIn(config, "stopAtFunction"),
    stopAtStatement: statementIn(config),
    structured: flagIn(config, "structured"),
    silent: textsIn(config, "silent"),
    noDebug: flagIn(config, "noDebug"),
    oncard: oncard ?? "oncard",
    module: oncard === undefined ? environment["ONCARD_MODULE"] : undefined,
  };
}

/**
 * A configuration with `host` attaches to a host program.
 * @throws UserError for a member that is missing or has another type
 */
export function readConfig(
  config: Readonly<Record<string, unknown>>,
  environment: Readonly<Record<string, string | undefined>>,
): LaunchConfig {
  const host = textIn(config, "host");
  if (host === undefined) return readLaunchConfig(config, environment);
  const folder = resolve(textIn(config, "cwd") ?? ".");
  const scenario = textIn(config, "scenario");
  // A name without a folder is looked for in PATH.
  const program = /[/\\]/.test(host) ? resolve(folder, host) : host;
  return {
    ...readLaunchConfig({ ...config, program }, environment),
    host: {
      command: [program, ...textsIn(config, "args")],
      scenario: scenario === undefined ? undefined : resolve(folder, scenario),
      folder,
    },
  };
}

function cardIn(config: Readonly<Record<string, unknown>>): number | undefined {
  const value = config["card"];
  if (value === undefined || (typeof value === "number" && Number.isInteger(value))) return value;
  throw new UserError({
    en: "'card' of the launch configuration must be the number of a card",
    zh: "启动配置的“card”应为卡号",
  });
}

function statementIn(config: Readonly<Record<string, unknown>>): number | undefined {
  const value = config["stopAtStatement"];
  if (value === undefined) return undefined;
  if (typeof value === "number" && Number.isInteger(value) && value >= 0) return value;
  throw new UserError({
    en: "'stopAtStatement' of the launch configuration must be the number of a statement of the run",
    zh: "启动配置的“stopAtStatement”应为本次运行中语句的序号",
  });
}

function textsIn(config: Readonly<Record<string, unknown>>, name: string): string[] {
  const value = config[name] ?? [];
  if (Array.isArray(value) && value.every((each) => typeof each === "string")) return value;
  throw new UserError({
    en: `'${name}' of the launch configuration must be a list of texts`,
    zh: `启动配置的“${name}”应为文本列表`,
  });
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
