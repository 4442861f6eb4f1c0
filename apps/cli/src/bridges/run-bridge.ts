/** Runs a bridge: connects to the robot, serves until the user stops it, and leaves the robot standing. */
import { ClientError } from "@corridor/client";
import { connectPort } from "@corridor/client/bridge";
import { bridgeAgent, type ClientProtocol } from "@corridor/protocol";
import { VERSION } from "../version.ts";
import { BridgeError } from "./bridge-error.ts";
import { BridgedRobot } from "./bridged-robot.ts";

/** After this time, the process ends although a connection is still closing. */
const EXIT_MS = 1_000;

export interface RunningBridge {
  /** resolves with the exit code if the bridge ends by itself */
  ended: Promise<number>;
  /** true: it explains the end of the robot to its program, so it does not end itself */
  outlivesRobot?: boolean;
  close(): void | Promise<void>;
}

export interface BridgeOptions {
  protocol: ClientProtocol;
  /** a valid one */
  address: string;
  /** @throws BridgeError */
  start: (robot: BridgedRobot) => Promise<RunningBridge>;
}

/** Prints a line to standard error: standard output belongs to the protocol. */
export function log(text: string): void {
  process.stderr.write(`${text}\n`);
}

/** @returns the exit code: 0 after Ctrl+C, 1 if the robot cannot be used */
export async function runBridge({ protocol, address, start }: BridgeOptions): Promise<number> {
  const interruption = awaitInterruption();
  try {
    const connecting = connect(protocol, address);
    const robot = await Promise.race([connecting, interruption.promise]);
    if (robot === null) {
      void connecting.then((late) => late.close());
      return 0;
    }
    return await serve(robot, start, interruption.promise);
  } catch (error) {
    if (!(error instanceof BridgeError || error instanceof ClientError)) throw error;
    log(error.message);
    return 1;
  } finally {
    interruption.cancel();
    setTimeout(() => process.exit(), EXIT_MS).unref();
  }
}

async function connect(protocol: ClientProtocol, address: string): Promise<BridgedRobot> {
  const userAgent = bridgeAgent(protocol, VERSION);
  return new BridgedRobot(await connectPort(address, { userAgent, warn: log }));
}

async function serve(
  robot: BridgedRobot,
  start: BridgeOptions["start"],
  interrupted: Promise<null>,
): Promise<number> {
  try {
    const bridge = await start(robot);
    const lost = robot.ended.then((error) => {
      log(error.message);
      return bridge.outlivesRobot === true ? new Promise<number>(() => undefined) : 1;
    });
    const code = await Promise.race([bridge.ended, lost, interrupted]);
    await bridge.close();
    await robot.stop();
    return code ?? 0;
  } finally {
    robot.close();
  }
}

/** Resolves with null when the user or the system stops the process; a second signal kills it. */
function awaitInterruption(): { promise: Promise<null>; cancel: () => void } {
  const signals = ["SIGINT", "SIGTERM", "SIGHUP"] as const;
  let interrupt = (): void => undefined;
  const promise = new Promise<null>((resolve) => (interrupt = () => resolve(null)));
  for (const signal of signals) process.once(signal, interrupt);
  const cancel = (): void => {
    for (const signal of signals) process.off(signal, interrupt);
  };
  return { promise, cancel };
}
