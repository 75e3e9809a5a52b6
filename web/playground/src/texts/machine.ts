// What is said about the machine, by the page and by the extension for Visual Studio Code.

const en = {
  stage: (axis: number, position: string, velocity: string) =>
    `Axis ${axis}: position ${position}, velocity ${velocity}`,
  axis: (axis: number) => `Axis ${axis}`,
  off: "off",
  servo: "servo on",
  moving: "moving",
  alarm: "alarm",
  followingError: "following error",
  positiveOn: "positive limit",
  negativeOn: "negative limit",
  switches: {
    limit_positive: "positive limit switch",
    limit_negative: "negative limit switch",
    home: "home switch",
  } as Record<string, string>,
  look: "How the machine is drawn",
  table: "XY table",
  axes: "Axes",
  tableLabel: (positions: string) => `XY table at ${positions}`,
  /** By the numbers of CiA 402. */
  driveStates: {
    0: "not ready",
    1: "switch-on disabled",
    2: "ready",
    3: "switched on",
    4: "operation enabled",
    5: "quick stop",
    6: "fault reaction",
    7: "fault",
  } as Record<number, string>,
  lamp: (name: string, isOn: boolean) => `${name}: ${isOn ? "on" : "off"}`,
  allPins: "all inputs and outputs",
  outputs: "Outputs",
  inputs: "Inputs",
  input: (kind: string, pin: number) => `Input ${kind} ${pin}`,
  output: (pin: number, level: number) => `Output ${pin}: ${level}`,
  moreInputs: "all inputs",
  idle: "Load a program: its axes are shown here.",
};

export type MachineWords = typeof en;

const zh: MachineWords = {
  stage: (axis, position, velocity) => `轴 ${axis}：位置 ${position}，速度 ${velocity}`,
  axis: (axis) => `轴 ${axis}`,
  off: "未使能",
  servo: "伺服使能",
  moving: "运动中",
  alarm: "报警",
  followingError: "跟随误差越限",
  positiveOn: "正限位",
  negativeOn: "负限位",
  switches: {
    limit_positive: "正限位开关",
    limit_negative: "负限位开关",
    home: "原点开关",
  },
  look: "机器的画法",
  table: "XY 平台",
  axes: "各轴",
  tableLabel: (positions) => `XY 平台位于 ${positions}`,
  driveStates: {
    0: "未就绪",
    1: "禁止使能",
    2: "就绪",
    3: "已接通",
    4: "运行使能",
    5: "快速停止",
    6: "故障响应",
    7: "故障",
  },
  lamp: (name, isOn) => `${name}：${isOn ? "亮" : "灭"}`,
  allPins: "全部输入与输出",
  outputs: "输出",
  inputs: "输入",
  input: (kind, pin) => `输入 ${kind} ${pin}`,
  output: (pin, level) => `输出 ${pin}：${level}`,
  moreInputs: "全部输入",
  idle: "装载程序后，此处显示它的轴。",
};

export const machine = { en, zh };
