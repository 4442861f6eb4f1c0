/** `viple`: diagrams of ASU VIPLE drive the robot. */
import { exitCodes, type Command } from "../../command.ts";
import { InputError } from "../../input-error.ts";
import { bridgeArguments, readListenAddress } from "../bridge-arguments.ts";
import { runBridge } from "../run-bridge.ts";
import { readSensorSettings, sensorHelp, sensorOptions } from "./sensor-settings.ts";
import { connectToViple } from "./viple-client.ts";
import { serveViple, type VipleListener } from "./viple-server.ts";

/** Of VIPLE's Unity simulator. */
const SIMULATOR_PORT = 1350;
/** Of the physical robots for VIPLE. */
const ROBOT_PORT = 8124;

const options = {
  ...sensorOptions,
  connect: { type: "string" },
  host: { type: "string", default: "127.0.0.1" },
  "simulator-port": { type: "string" },
  "robot-port": { type: "string" },
} as const;

const help = `Usage: corridor viple "http://HOST/r/ID#KEY" [OPTIONS]

Lets diagrams of ASU VIPLE drive a robot. VIPLE connects to this computer, as to its Unity simulator
or to a physical robot. With --connect, the robot connects to VIPLE, as VIPLE's web simulator does.
Servo 3 is the left wheel, servo 5 the right one. Press Ctrl+C to stop. The robot then stops, too.

Without an argument, the address is read from the variable CORRIDOR_ROBOT.

Options:
${sensorHelp}
  --connect URL            connect to VIPLE's WebSocket server, such as ws://localhost:${ROBOT_PORT}
  --simulator-port PORT    port to listen on, as the Unity simulator; default: ${SIMULATOR_PORT}
  --robot-port PORT        port to listen on, as a physical robot; default: ${ROBOT_PORT}
  --host HOST              address to listen on; default: 127.0.0.1, for programs on this computer
                           only. With 0.0.0.0, everyone in the network can drive the robot
  --help                   print this text

${exitCodes("stopped with Ctrl+C", "the robot or a port cannot be used")}`;

export const command: Command = {
  help,
  run: (args) => {
    const { address, values } = bridgeArguments(args, options);
    const settings = readSensorSettings(values);
    const { connect } = values;
    const listeners = readListeners(values);
    if (connect !== undefined) checkUrl(connect);
    return runBridge({
      protocol: "viple",
      address,
      start: async (robot) =>
        connect === undefined
          ? serveViple(robot, settings, listeners)
          : connectToViple(robot, settings, connect),
    });
  },
};

interface Ports {
  host: string;
  "simulator-port"?: string | undefined;
  "robot-port"?: string | undefined;
}

/** @throws InputError */
function readListeners({ host, ...ports }: Ports): VipleListener[] {
  const listener = (
    name: keyof typeof ports,
    defaultPort: number,
    lineEnd: VipleListener["lineEnd"],
  ): VipleListener => {
    const option = `--${name}`;
    const at = readListenAddress({ host, port: ports[name] }, defaultPort, option);
    return { at, option, lineEnd };
  };
  return [
    listener("simulator-port", SIMULATOR_PORT, "\n"),
    listener("robot-port", ROBOT_PORT, "\r\n"),
  ];
}

/** @throws InputError */
function checkUrl(text: string): void {
  const url = URL.canParse(text) ? new URL(text) : null;
  if (url !== null && ["ws:", "wss:"].includes(url.protocol) && url.hash === "") return;
  throw new InputError([
    `--connect: found ${JSON.stringify(text)}, expected the URL of VIPLE's server, such as ws://localhost:${ROBOT_PORT}`,
  ]);
}
