export * from "./columns.js";
export * from "./engine.js";
export * from "./language.js";
export * from "./module.js";
export * from "./protocol.js";
export * from "./record.js";
export * from "./transport.js";
export * from "./worker_transport.js";
