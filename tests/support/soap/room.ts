/** A room in which a robot drives a square. */
import { corridor } from "../mcp/corridor-host.ts";

export const room = { ...corridor, blocks: ["####", "#..#", "#..#", "####"], goals: [] };
