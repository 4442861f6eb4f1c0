export { createAgent, type Agent } from "./agent-server.ts";
export type { AgentClock } from "./tool.ts";
