import { openPort, type MarkingPort } from "./client-port.ts";
import { globalPlatform } from "./platform.ts";
import { RobotClient } from "./robot-client.ts";

export interface BridgeClientOptions {
  /** header `User-Agent`, by which the relay names the client in the list of scripts */
  userAgent: string;
  /** prints why the robot does not respond */
  warn: (text: string) => void;
}

/**
 * Connects to a robot.
 * @param address `http://HOST/r/ID#KEY`
 * @returns its port, once the relay has accepted the key
 * @throws ClientError as `RobotClient.connect`
 */
export async function connectPort(
  address: string,
  { userAgent, warn }: BridgeClientOptions,
): Promise<MarkingPort> {
  const platform = { ...globalPlatform(userAgent), warn };
  return openPort(await RobotClient.connect(address, { platform }));
}
