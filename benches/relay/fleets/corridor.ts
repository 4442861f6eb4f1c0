/**
 * A fleet at the product: robots are registered, pages and readers say hello with their keys, readers say
 * what they have seen as those of the client do, pages begin and end each command at once, or
 * are busy with the first and have as many more as they may, until they are stopped.
 */
import type { Registration } from "@corridor/protocol";
import { SeenPace } from "../../../packages/client/src/seen-pace.ts";
import { limits } from "../../../apps/relay/src/sessions/limits.ts";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { commandText, numberIn, snapshotText } from "./messages.ts";
import { TextWire } from "./text-wire.ts";

/** So many robots share an address: as many as may, with all who look on. */
const A_CLASS = 6;

/** What a busy page has: the one that it runs, and as many as it may have next. */
const AT_HAND = 1 + limits.deliveredWindow;

const STOP = '{"type":"command","command":{"action":"stop"}}';
const IS_STOP = '"action":"stop"';

interface Robot {
  page: TextWire;
  reader: TextWire;
  onlookers: TextWire[];
  epoch: number;
  /** who waits for the relay's time: then it has taken all that was said before */
  asking: (() => void)[];
  /** stops the robot, which is busy again after that */
  rest(): Promise<void>;
}

export async function openCorridor(options: FleetOptions): Promise<Fleet> {
  let commands = 0;
  const nextCommand = (): string => commandText(commands++);
  const all = await openAll(options.robots, (robot) => openRobot(robot, options, nextCommand));
  return {
    report: (robot, n) => {
      const at = all[robot];
      at?.page.send(snapshotText(n, at.epoch));
    },
    command: (robot) => all[robot]?.reader.send(nextCommand()),
    taken: (robot) =>
      new Promise((resolve) => {
        const at = all[robot];
        at?.asking.push(resolve);
        at?.page.send(`{"type":"time","epoch":${at.epoch}}`);
      }),
    rest: options.isBusy ? async (robot) => all[robot]?.rest() : null,
    close: async () => {
      for (const { page, reader, onlookers } of all) {
        for (const wire of [page, reader, ...onlookers]) wire.close();
      }
    },
  };
}

async function openRobot(
  robot: number,
  options: FleetOptions,
  nextCommand: () => string,
): Promise<Robot> {
  const { scripts, onlookers, ears } = options;
  const [pages, readers] = [options.pages, options.readers].map((ports) => turnOf(ports, robot));
  const headers = { "X-Forwarded-For": `10.1.0.${Math.floor(robot / A_CLASS) + 1}` };
  const api = `http://127.0.0.1:${pages}/api/v1/robots`;
  const { id, ownerKey, driverKey } = (await post(api, { headers })) as Registration;
  const path = `/api/v1/robots/${id}/socket`;
  const asking: (() => void)[] = [];

  const welcomed = Promise.withResolvers<number>();
  const page = await TextWire.open({
    port: Number(pages),
    path,
    headers,
    hear: (text) => {
      if (text.startsWith('{"type":"command"')) doCommand(numberIn(text));
      else if (text.startsWith('{"type":"stop"')) standStill(numberIn(text));
      else if (text.startsWith('{"type":"time"')) asking.shift()?.();
      else if (text.startsWith('{"type":"welcome"')) {
        welcomed.resolve((JSON.parse(text) as { epoch: number }).epoch);
      }
    },
  });
  page.send(JSON.stringify({ type: "hello", version: 1, role: "own", key: ownerKey }));
  page.send(JSON.stringify({ type: "resume", lastApplied: 0, fresh: true, endings: [] }));
  const epoch = await welcomed.promise;
  /** what a busy page has and has not ended, the first of them begun */
  const open: number[] = [];
  const begin = (seq: number): void =>
    page.send(`{"type":"started","epoch":${epoch},"seq":${seq}}`);
  const end = (seq: number, state: "completed" | "cancelled"): void =>
    page.send(
      `{"type":"ended","epoch":${epoch},"seq":${seq},"state":"${state}","reason":null,"pose":{"x":150,"y":150,"heading":90},"distance":120}`,
    );
  const doCommand = (seq: number): void => {
    if (!options.isBusy) {
      begin(seq);
      end(seq, "completed");
    } else if (open.push(seq) === 1) begin(seq);
  };
  const standStill = (seq: number): void => {
    for (const before of open.splice(0)) end(before, "cancelled");
    begin(seq);
    end(seq, "completed");
  };

  const enter = async (
    role: "drive" | "watch",
    key: string,
    hear: (text: string) => void,
  ): Promise<TextWire> => {
    const joined = Promise.withResolvers<void>();
    const wire = await TextWire.open({
      port: Number(readers),
      path,
      headers,
      hear: (text) => (text.startsWith('{"type":"welcome"') ? joined.resolve() : hear(text)),
    });
    wire.send(JSON.stringify({ type: "hello", version: 1, role, key }));
    await joined.promise;
    return wire;
  };
  const seen = new SeenPace();
  const resting: (() => void)[] = [];
  /** how many of those that are to keep the robot busy are not answered yet, and who waits for that */
  const filling = { left: 0, done: (): void => undefined };
  const hear = (text: string): void => {
    if (text.startsWith('{"type":"snapshot"')) {
      const n = numberIn(text);
      ears.snapshot(robot, n);
      if (seen.read(performance.now())) reader.send(`{"type":"seen","seq":${n}}`);
    } else if (text.startsWith('{"type":"ack"')) {
      if (text.includes(IS_STOP)) return;
      if (filling.left === 0) ears.answered(robot);
      else if (--filling.left === 0) filling.done();
    } else if (text.startsWith('{"type":"state"')) {
      if (text.includes(IS_STOP)) {
        if (text.includes('"state":"completed"')) resting.shift()?.();
      } else if (text.includes('"state":"started"')) ears.began(robot);
    } else if (text.startsWith('{"type":"problem"')) throw new Error(text);
  };
  const isScript = robot < scripts;
  const watch =
    isScript && onlookers === 0 ? "" : await watchKey(`${api}/${id}/keys`, ownerKey, headers);
  const reader: TextWire = isScript
    ? await enter("drive", driverKey, hear)
    : await enter("watch", watch, hear);
  const occupy = (): Promise<void> =>
    new Promise((resolve) => {
      Object.assign(filling, { left: AT_HAND, done: resolve });
      for (let n = 0; n < AT_HAND; n++) reader.send(nextCommand());
    });
  const rest = async (): Promise<void> => {
    await new Promise<void>((resolve) => {
      resting.push(resolve);
      reader.send(STOP);
    });
    await occupy();
  };
  if (options.isBusy === true) await occupy();
  const more = await openAll(onlookers, () => enter("watch", watch, () => undefined));
  return { page, reader, onlookers: more, epoch, asking, rest };
}

async function watchKey(
  url: string,
  ownerKey: string,
  headers: Record<string, string>,
): Promise<string> {
  const made = await post(url, {
    headers: {
      ...headers,
      Authorization: `Bearer ${ownerKey}`,
      "Content-Type": "application/json",
    },
    body: '{"kind":"watch"}',
  });
  return (made as { key: string }).key;
}

async function post(url: string, init: RequestInit): Promise<unknown> {
  const response = await fetch(url, { method: "POST", ...init });
  if (!response.ok) throw new Error(`${url}: ${await response.text()}`);
  return response.json();
}

function turnOf(ports: string, robot: number): string {
  const all = ports.split(",");
  return all[robot % all.length] ?? ports;
}
