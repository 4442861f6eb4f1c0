/** `ros`: rosbridge on this computer. */
import { exitCodes, type Command } from "../../command.ts";
import {
  bridgeArguments,
  listenHelp,
  listenOptions,
  readListenAddress,
} from "../bridge-arguments.ts";
import { runBridge } from "../run-bridge.ts";
import { serveRos } from "./ros-server.ts";

const DEFAULT_PORT = 9090;

const help = `Usage: corridor ros "http://HOST/r/ID#KEY" [--port PORT] [--host HOST]

Lets ROS programs that accept only a host and a port drive a robot: rosbridge v2 at
ws://localhost:${DEFAULT_PORT}. Press Ctrl+C to stop it. The robot then stops, too.

Without an argument, the address is read from the variable CORRIDOR_ROBOT.

Options:
${listenHelp(DEFAULT_PORT)}
  --help       print this text

${exitCodes("stopped with Ctrl+C", "the robot or the port cannot be used")}`;

export const command: Command = {
  help,
  run: (args) => {
    const { address, values } = bridgeArguments(args, listenOptions);
    const listenAddress = readListenAddress(values, DEFAULT_PORT);
    return runBridge({
      protocol: "ros",
      address,
      start: (robot) => serveRos(robot, listenAddress),
    });
  },
};
