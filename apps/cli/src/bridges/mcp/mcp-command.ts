/** `mcp`: the tools for AI agents over standard input and output. */
import { createAgent, type Agent } from "@corridor/agent";
import { serveStdio } from "@modelcontextprotocol/server/stdio";
import { exitCodes, type Command } from "../../command.ts";
import { bridgeArguments } from "../bridge-arguments.ts";
import type { BridgedRobot } from "../bridged-robot.ts";
import { clock } from "../clock.ts";
import { log, runBridge, type RunningBridge } from "../run-bridge.ts";

const help = `Usage: corridor mcp "http://HOST/r/ID#KEY"

Lets an AI agent sense, look and drive: an MCP server that the agent's host starts. It speaks the
protocol on standard input and output, and prints problems to standard error.

Without an argument, the address is read from the variable CORRIDOR_ROBOT.

Options:
  --help  print this text

${exitCodes("the host has closed the connection", "the robot cannot be used")}`;

export const command: Command = {
  help,
  run: (args) => {
    const { address } = bridgeArguments(args, {});
    return runBridge({ protocol: "mcp", address, start: async (robot) => serveAgent(robot) });
  },
};

function serveAgent(robot: BridgedRobot): RunningBridge {
  const agents: Agent[] = [];
  const ended = new Promise<number>((resolve) => {
    for (const event of ["end", "close"]) process.stdin.once(event, () => resolve(0));
  });
  const server = serveStdio(
    () => {
      const agent = createAgent(robot.openPort(), clock);
      agents.push(agent);
      return agent.server;
    },
    { maxSubscriptions: 0, onerror: (error) => log(error.message) },
  );
  const close = async (): Promise<void> => {
    for (const agent of agents) agent.close();
    await server.close();
  };
  return { ended, outlivesRobot: true, close };
}
