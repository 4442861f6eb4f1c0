/** The robot in the settings of AI agents. */
import { mcpUrlOf, type RobotParts } from "./robot-parts.ts";

export function claudeCode(robot: RobotParts): string {
  return `claude mcp add --transport http corridor ${mcpUrlOf(robot)} --header "Authorization: Bearer ${robot.key}"`;
}

export function vsCode(robot: RobotParts): string {
  return settings({ servers: { corridor: { type: "http", ...server(robot) } } });
}

export function cursor(robot: RobotParts): string {
  return settings({ mcpServers: { corridor: server(robot) } });
}

function server(robot: RobotParts) {
  return { url: mcpUrlOf(robot), headers: { Authorization: `Bearer ${robot.key}` } };
}

function settings(value: object): string {
  return `${JSON.stringify(value, null, 2)}\n`;
}
