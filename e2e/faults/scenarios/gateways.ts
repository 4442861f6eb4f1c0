/**
 * Clients of ROS, agents and clients of SOAP that send broken messages, do not read, or lose their
 * connections: the relay survives, memory stays bounded, other robots drive on, and no command runs
 * twice.
 */
import { randomUUID } from "node:crypto";
import { WebSocket } from "ws";
import { badCommands } from "../../../apps/relay/src/testing/bad-commands.ts";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import {
  callSoap,
  envelopeXml,
  operationXml,
} from "../../../apps/relay/src/testing/soap-client.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { urlWithKey } from "../../../tests/support/ros/url-with-key.ts";
import { callRepeatedly, sleep, waitUntil } from "../clock.ts";
import { FaultProxy } from "../net/fault-proxy.ts";
import { memoryMib } from "../memory.ts";
import { RawSocket } from "../net/raw-socket.ts";
import type { Robot } from "../robots/robot.ts";
import { RosScript } from "../scripts/ros-script.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { BareSocketScript } from "../scripts/bare-socket-script.ts";

const MESSAGES = { short: 2_000, long: 20_000 };
const CUTS = { short: 60, long: 600 };
/** connection limit of a key */
const READERS = 4;
const SLEEP_MS = 20_000;
/** long enough to receive the backlog, and short enough to receive almost no new messages */
const WAKING_MS = 150;
const TIMEOUT_MS = 30_000;
const INTERNALS = /node:|node_modules|file:\/\/|\/src\/|\bat \w+ \(|SQLITE_/;

const size = (sizes: { short: number; long: number }, isLong: boolean): number =>
  isLong ? sizes.long : sizes.short;

export const gateways: Scenario = {
  title: "Gateways",
  describe: (isLong) =>
    `${size(MESSAGES, isLong)} broken messages arrive at the gateways for ROS, agents and SOAP, ${READERS} ROS clients read nothing for ${SLEEP_MS / 1000} s, and the connections of an agent, a SOAP client and a ROS client are cut ${size(CUTS, isLong)} times. Meanwhile a script drives another robot`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const { pid } = relay;
    const testBed = new TestBed(context);
    await testBed.register(relay.url, 5);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "websocket");
    await testBed.waitUntilConnected();
    const registrations = testBed.robots.map((each) => each.registration);
    const [victim, ofAgent, ofSoap, ofRos, bystander] = registrations;
    if (!victim || !ofAgent || !ofSoap || !ofRos || !bystander) throw new Error("no robots");
    const script = await BareSocketScript.connect(relay.url, bystander.id, bystander.driverKey);
    context.onCleanup(() => script.close());
    const endTurning = script.keepTurning();

    const path = new URL(await urlWithKey(relay.url, victim)).pathname;
    const shown = await sendBroken(relay.url, path, {
      random,
      count: size(MESSAGES, context.isLong),
      agentUrl: `${relay.url}/r/${victim.id}/mcp`,
      key: victim.driverKey,
    });

    const slow = await readNothing(await urlWithKey(relay.url, ofRos), pid);

    const proxy = await FaultProxy.start({ target: () => relay.port, random });
    context.onCleanup(() => proxy.close());
    const rosPath = new URL(await urlWithKey(relay.url, ofRos)).pathname;
    const ros = new RosScript(proxy.origin.replace("http", "ws") + rosPath);
    context.onCleanup(() => ros.close());
    let isCut = false;
    /** Makes calls until the cuts are over, and repeats each until it is answered. @returns their keys */
    const callOften = async (call: (args: Args) => Promise<boolean>): Promise<string[]> => {
      const keys: string[] = [];
      while (!isCut) {
        const key = randomUUID();
        keys.push(key);
        const action = keys.length % 2 === 0 ? "left 90" : "right 90";
        while (!(await isAnswered(() => call({ action, key })))) await sleep(50);
      }
      return keys;
    };
    const agent = callOften((args) =>
      callTool(`${proxy.origin}/r/${ofAgent.id}/mcp`, ofAgent.driverKey, args),
    );
    const soapRobot = `${relay.url}/r/${ofSoap.id}#${ofSoap.driverKey}`;
    const soap = callOften(async (args) => {
      const fields = { robot: soapRobot, ...args, wait: 25 };
      const { name } = await callSoap(proxy.origin, "Command", fields);
      return name === "CommandResponse";
    });
    for (let cut = size(CUTS, context.isLong); cut > 0; cut -= 1) {
      await sleep(random.between(50, 500));
      proxy.cut();
    }
    const { poses } = ros;
    const backMs = await waitUntil(() => ros.poses > poses, TIMEOUT_MS);
    isCut = true;
    const agentKeys = await agent;
    const soapKeys = await soap;
    const ends = await endTurning();
    const health = await fetch(`${relay.url}/healthz`);
    const compared = await testBed.compare(relay.url);
    const [, agentRobot, robotOfSoap] = testBed.robots;
    /** Number of calls whose key is in the log of the robot not exactly once. */
    const countWrong = (robot: Robot | undefined, keys: readonly string[]): number => {
      const log = (robot && compared.logs.get(robot)) ?? [];
      return keys.filter((key) => log.filter((each) => each.key === key).length !== 1).length;
    };
    return [
      {
        label: "the relay is the same process, and healthy",
        measured: health.ok && relay.pid === pid ? 1 : 0,
        bound: { atLeast: 1 },
        unit: "",
      },
      {
        label: "responses with a path or a stack trace",
        measured: shown,
        bound: { atMost: 0 },
        unit: "",
      },
      {
        label: "increase of the relay's memory by ROS clients that do not read",
        measured: slow.memoryMib,
        bound: { atMost: 48 },
        unit: "MiB",
      },
      {
        label: "largest backlog of a ROS client that resumes",
        measured: slow.backlogKib,
        bound: { atMost: 64 },
        unit: "KiB",
      },
      {
        label: "from the last cut until a ROS client receives poses",
        measured: backMs,
        bound: { atMost: 5_000 },
        unit: "ms",
      },
      {
        label: "calls of an agent that did not move the robot exactly once",
        measured: countWrong(agentRobot, agentKeys),
        bound: { atMost: 0 },
        unit: `of ${agentKeys.length}`,
      },
      {
        label: "calls of a SOAP client that did not move the robot exactly once",
        measured: countWrong(robotOfSoap, soapKeys),
        bound: { atMost: 0 },
        unit: `of ${soapKeys.length}`,
      },
      {
        label: "commands of the bystander that did not complete",
        measured: ends.length === 0 ? NaN : ends.filter((state) => state !== "completed").length,
        bound: { atMost: 0 },
        unit: `of ${ends.length}`,
      },
      ...compared.goals(),
    ];
  },
};

interface Attack {
  random: SeededRandom;
  count: number;
  agentUrl: string;
  key: string;
}

/** Sends broken messages to the gateways. @returns the number of answers that show internals */
async function sendBroken(
  origin: string,
  path: string,
  { random, count, agentUrl, key }: Attack,
): Promise<number> {
  let shown = 0;
  for (let sent = 0; sent < count;) {
    const socket = await RawSocket.open(origin, path);
    for (let n = random.between(1, 20); n > 0 && socket.isOpen; n -= 1) {
      socket.frame({ payload: brokenMessage(random), opcode: random.chance(0.9) ? 1 : 2 });
      sent += 1;
    }
    await sleep(random.between(0, 10));
    if (INTERNALS.test(socket.response)) shown += 1;
    socket.destroy();
    const headers = { Authorization: `Bearer ${key}`, "Content-Type": "application/json" };
    const body = new Uint8Array(brokenMessage(random));
    const answer = await fetch(agentUrl, { method: "POST", headers, body });
    if (answer.status >= 500 || INTERNALS.test(await answer.text())) shown += 1;
    const fault = await fetch(`${origin}/soap`, {
      method: "POST",
      headers: { Authorization: `Bearer ${key}`, "Content-Type": "text/xml; charset=utf-8" },
      body: new Uint8Array(brokenXml(random)),
    });
    // Faults of SOAP 1.1 have the status 500, but none is the relay's own.
    const faultText = await fault.text();
    if (!faultText.includes("Fault") || /code>internal</.test(faultText)) shown += 1;
    else if (INTERNALS.test(faultText)) shown += 1;
    sent += 2;
  }
  return shown;
}

function brokenMessage(random: SeededRandom): Buffer {
  const body = (): string => random.pick(badCommands).body || "null";
  const texts: (() => string)[] = [
    body,
    () => `{"op":"publish","topic":"/cmd_vel","msg":${body()}}`,
    () => `{"op":"send_action_goal","action":"/do","id":{},"args":${body()}}`,
    () => `{"op":"call_service","service":"/rosapi/get_param","args":${body()}}`,
    () => '{"op":"subscribe","topic":"/odom","throttle_rate":1e999}',
    () => '{"op":"auth","mac":7}',
    () => '{"__proto__":{"op":"publish"},"op":"constructor"}',
    () => "[".repeat(8_000) + "]".repeat(8_000),
    () => "x".repeat(20_000),
    () =>
      `{"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"act","arguments":${body()}}}`,
    () => '{"jsonrpc":"1.0","id":{},"method":"tools/call"}',
  ];
  if (random.chance(0.1)) return Buffer.from([0x22, 0xc3, 0x28, 0x22]);
  return Buffer.from(random.pick(texts)());
}

function brokenXml(random: SeededRandom): Buffer {
  const { body } = random.pick(badCommands);
  const text = (body || "null").replaceAll("&", "&amp;").replaceAll("<", "&lt;");
  const texts: (() => string)[] = [
    () => body || "null",
    () => envelopeXml(operationXml("Command", `<robot>${text}</robot><action>${text}</action>`)),
    () => envelopeXml(operationXml("Fly", { robot: "nobody" })),
    () => envelopeXml("<Sense/>"),
    () => `<!DOCTYPE a [<!ENTITY b "c">]>${envelopeXml(operationXml("Sense", "&b;"))}`,
    () => envelopeXml("<a>".repeat(2_000) + "</a>".repeat(2_000)),
    () => envelopeXml("").slice(0, random.between(1, 100)),
    () => "x".repeat(20_000),
  ];
  if (random.chance(0.1)) return Buffer.from([0x3c, 0xc3, 0x28, 0x3e]);
  return Buffer.from(random.pick(texts)());
}

/** ROS clients drive a robot, and then do not read what it reports. */
async function readNothing(url: string, pid: number) {
  const topics = ["/odom", "/scan", "/tf", "/pose2d", "/corridor/snapshot", "/clock"];
  const readers = Array.from({ length: READERS }, () => new WebSocket(url));
  let received = readers.map(() => 0);
  for (const [n, reader] of readers.entries()) {
    reader.on("message", (data: Buffer) => (received[n] = (received[n] ?? 0) + data.length));
    await new Promise((resolve) => reader.once("open", resolve));
    for (const topic of topics) reader.send(JSON.stringify({ op: "subscribe", topic }));
  }
  const turn = (): void => {
    const msg = { angular: { z: 1 } };
    readers[0]?.send(JSON.stringify({ op: "publish", topic: "/cmd_vel", msg }));
  };
  await callRepeatedly(10, 3_000, turn);
  const before = memoryMib(pid);
  for (const reader of readers) reader.pause();
  let most = before;
  await callRepeatedly(10, SLEEP_MS, (n) => {
    turn();
    if (n % 10 === 0) most = Math.max(most, memoryMib(pid));
  });
  received = readers.map(() => 0);
  for (const reader of readers) reader.resume();
  await sleep(WAKING_MS);
  const backlogKib = Math.max(...received) / 1024;
  for (const reader of readers) reader.terminate();
  return { memoryMib: most - before, backlogKib };
}

interface Args {
  action: string;
  /** idempotency key, the same for each attempt */
  key: string;
}

/** Whether a call is answered. It fails if its connection is cut. */
async function isAnswered(call: () => Promise<boolean>): Promise<boolean> {
  try {
    return await call();
  } catch {
    return false;
  }
}

async function callTool(url: string, key: string, args: Args): Promise<boolean> {
  const params = { name: "act", arguments: args };
  const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "tools/call", params });
  const headers = { Authorization: `Bearer ${key}`, "Content-Type": "application/json" };
  const answer = await fetch(url, { method: "POST", headers, body });
  await answer.text();
  return answer.ok;
}
