export * from "./engine.js";
export * from "./protocol.js";
export * from "./transport.js";
