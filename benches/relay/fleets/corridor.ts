/**
 * A fleet at the product. Registers robots; pages and readers send `hello` with their keys, and
 * readers send `seen` at the same rate as the client library. Pages start and end each command
 * immediately. Busy pages start only their first command and hold the maximum number of further
 * commands until a stop.
 */
import type { Registration } from "@corridor/protocol";
import { DelayedAcknowledgements } from "../../../packages/client/src/delayed-acknowledgements.ts";
import { limits } from "../../../apps/relay/src/platform/limits/limits.ts";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import {
  commandText,
  driveText,
  parseSeq,
  parseStamp,
  snapshotText,
  twistText,
} from "./messages.ts";
import { TextSocket } from "./text-socket.ts";

/** Number of robots that share a client address: the maximum, including all viewers. */
const ROBOTS_PER_ADDRESS = 6;

/**
 * Number of commands that a busy page holds: the running one, and the maximum number of next ones.
 */
const BUSY_COMMANDS = 1 + limits.deliveredWindow;

const STOP = '{"type":"command","command":{"action":"stop"}}';
const IS_STOP = '"action":"stop"';

interface Robot {
  page: TextSocket;
  reader: TextSocket;
  viewers: TextSocket[];
  epoch: number;
  /**
   * resolvers of pending `time` requests; the answer proves that all earlier messages are processed
   */
  timeRequests: (() => void)[];
  /** Stops the robot and makes it busy again. */
  reset(): Promise<void>;
}

export async function openCorridor(options: FleetOptions): Promise<Fleet> {
  let commands = 0;
  const textOf = options.drives ? (options.ros === null ? driveText : twistText) : commandText;
  const nextCommand = (): string => textOf(commands++);
  const all = await openAll(options.robots, (robot) => openRobot(robot, options, nextCommand));
  return {
    sendSnapshot: (robot, n) => {
      const at = all[robot];
      at?.page.send(snapshotText(n, at.epoch));
    },
    sendCommand: (robot) => all[robot]?.reader.send(nextCommand()),
    whenProcessed: (robot) =>
      new Promise((resolve) => {
        const at = all[robot];
        at?.timeRequests.push(resolve);
        at?.page.send(`{"type":"time","epoch":${at.epoch}}`);
      }),
    reset: options.isBusy ? async (robot) => all[robot]?.reset() : null,
    close: async () => {
      for (const { page, reader, viewers } of all) {
        for (const socket of [page, reader, ...viewers]) socket.close();
      }
    },
  };
}

async function openRobot(
  robot: number,
  options: FleetOptions,
  nextCommand: () => string,
): Promise<Robot> {
  const { scripts, viewers, listener } = options;
  const [pages, readers] = [options.pages, options.readers].map((ports) => portFor(ports, robot));
  const headers = { "X-Forwarded-For": `10.1.0.${Math.floor(robot / ROBOTS_PER_ADDRESS) + 1}` };
  const api = `http://127.0.0.1:${pages}/api/v1/robots`;
  const { id, ownerKey, driverKey } = (await post(api, { headers })) as Registration;
  const path = `/api/v1/robots/${id}/socket`;
  const timeRequests: (() => void)[] = [];

  const welcomed = Promise.withResolvers<number>();
  const page = await TextSocket.open({
    port: Number(pages),
    path,
    headers,
    onMessage: (text) => {
      if (text.startsWith('{"type":"command"')) onCommand(parseSeq(text));
      else if (text.startsWith('{"type":"stop"')) onStop(parseSeq(text));
      else if (text.startsWith('{"type":"time"')) timeRequests.shift()?.();
      else if (text.startsWith('{"type":"welcome"')) {
        welcomed.resolve((JSON.parse(text) as { epoch: number }).epoch);
      }
    },
  });
  page.send(JSON.stringify({ type: "hello", version: 1, role: "own", key: ownerKey }));
  page.send(JSON.stringify({ type: "resume", lastApplied: 0, fresh: true, endings: [] }));
  const epoch = await welcomed.promise;
  /** commands that a busy page has received and not ended; only the first is started */
  const open: number[] = [];
  const sendStarted = (seq: number): void =>
    page.send(`{"type":"started","epoch":${epoch},"seq":${seq}}`);
  const sendEnded = (seq: number, state: "completed" | "cancelled"): void =>
    page.send(
      `{"type":"ended","epoch":${epoch},"seq":${seq},"state":"${state}","reason":null,"pose":{"x":150,"y":150,"heading":90},"distance":120}`,
    );
  const onCommand = (seq: number): void => {
    if (options.drives) listener.onVelocity(robot);
    if (!options.isBusy) {
      sendStarted(seq);
      sendEnded(seq, "completed");
    } else if (open.push(seq) === 1) sendStarted(seq);
  };
  const onStop = (seq: number): void => {
    for (const before of open.splice(0)) sendEnded(before, "cancelled");
    sendStarted(seq);
    sendEnded(seq, "completed");
  };

  const join = async (
    role: "drive" | "watch",
    key: string,
    onMessage: (text: string) => void,
  ): Promise<TextSocket> => {
    const joined = Promise.withResolvers<void>();
    const socket = await TextSocket.open({
      port: Number(readers),
      path,
      headers,
      onMessage: (text) =>
        text.startsWith('{"type":"welcome"') ? joined.resolve() : onMessage(text),
    });
    socket.send(JSON.stringify({ type: "hello", version: 1, role, key }));
    await joined.promise;
    return socket;
  };
  const acknowledgements = new DelayedAcknowledgements();
  const pendingResets: (() => void)[] = [];
  /** number of unanswered commands that fill the queue of a busy robot, and their resolver */
  const pendingFill = { left: 0, done: (): void => undefined };
  const onMessage = (text: string): void => {
    if (text.startsWith('{"type":"snapshot"')) {
      const n = parseSeq(text);
      listener.onSnapshot(robot, n);
      if (acknowledgements.read(performance.now())) reader.send(`{"type":"seen","seq":${n}}`);
    } else if (text.startsWith('{"type":"ack"')) {
      if (text.includes(IS_STOP)) return;
      if (pendingFill.left === 0) listener.onAnswer(robot);
      else if (--pendingFill.left === 0) pendingFill.done();
    } else if (text.startsWith('{"type":"state"')) {
      if (text.includes(IS_STOP)) {
        if (text.includes('"state":"completed"')) pendingResets.shift()?.();
      } else if (text.includes('"state":"started"') && !options.drives) listener.onStarted(robot);
    } else if (text.startsWith('{"type":"problem"')) throw new Error(text);
  };
  const onRosMessage = (text: string): void => {
    if (text.includes('"topic":"/odom"')) listener.onSnapshot(robot, parseStamp(text));
    else if (text.includes('"topic":"/rosout"')) throw new Error(text);
  };
  const joinByRos = async (key: string, topics: readonly string[]): Promise<TextSocket> => {
    const socket = await TextSocket.open({
      port: Number(readers),
      path: `/r/${id}/ros`,
      headers: { ...headers, Authorization: `Bearer ${key}` },
      onMessage: onRosMessage,
    });
    for (const topic of [...topics, "/rosout"])
      socket.send(JSON.stringify({ op: "subscribe", topic }));
    return socket;
  };
  const isScript = robot < scripts;
  const watchKey =
    isScript && viewers === 0 ? "" : await createWatchKey(`${api}/${id}/keys`, ownerKey, headers);
  const reader: TextSocket =
    options.ros === null
      ? await join(isScript ? "drive" : "watch", isScript ? driverKey : watchKey, onMessage)
      : await joinByRos(isScript ? driverKey : watchKey, options.ros);
  const fillQueue = (): Promise<void> =>
    new Promise((resolve) => {
      Object.assign(pendingFill, { left: BUSY_COMMANDS, done: resolve });
      for (let n = 0; n < BUSY_COMMANDS; n++) reader.send(nextCommand());
    });
  const reset = async (): Promise<void> => {
    await new Promise<void>((resolve) => {
      pendingResets.push(resolve);
      reader.send(STOP);
    });
    await fillQueue();
  };
  if (options.isBusy === true) await fillQueue();
  const viewerSockets = await openAll(viewers, () => join("watch", watchKey, () => undefined));
  return { page, reader, viewers: viewerSockets, epoch, timeRequests, reset };
}

async function createWatchKey(
  url: string,
  ownerKey: string,
  headers: Record<string, string>,
): Promise<string> {
  const created = await post(url, {
    headers: {
      ...headers,
      Authorization: `Bearer ${ownerKey}`,
      "Content-Type": "application/json",
    },
    body: '{"kind":"watch"}',
  });
  return (created as { key: string }).key;
}

async function post(url: string, init: RequestInit): Promise<unknown> {
  const response = await fetch(url, { method: "POST", ...init });
  if (!response.ok) throw new Error(`${url}: ${await response.text()}`);
  return response.json();
}

function portFor(ports: string, robot: number): string {
  const all = ports.split(",");
  return all[robot % all.length] ?? ports;
}
