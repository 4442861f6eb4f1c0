/** Sends a command by a port and waits for its end, for protocols that do both in one call. */
import type { CommandRecord } from "./command-record.ts";
import type { Order } from "./order.ts";
import { RefusedError, type RobotPort } from "./robot-port.ts";

/**
 * @param milliseconds how long to wait, 0 to 25000
 * @returns the record after the wait, ended or not; `duplicate` if the command was stored before
 * @throws RefusedError; if the command was stored, its sentence contains that
 */
export async function sendAndWait(
  port: RobotPort,
  order: Order,
  key: string | undefined,
  milliseconds: number,
): Promise<CommandRecord> {
  const sent = await port.send(order, key);
  if (milliseconds === 0) return sent;
  try {
    return { ...(await port.endOf(sent.seq, milliseconds)), duplicate: sent.duplicate };
  } catch (error) {
    if (!(error instanceof RefusedError)) throw error;
    const { problem, retryAfter } = error;
    const detail = `${problem.detail} Command ${sent.seq} was sent before.`;
    throw new RefusedError({ ...problem, detail }, { cause: error, retryAfter });
  }
}
