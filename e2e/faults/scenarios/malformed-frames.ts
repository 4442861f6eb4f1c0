/**
 * Two thousand frames that no client should send: the relay survives, and clients of other robots
 * are not affected.
 */
import { badCommands } from "../../../apps/relay/src/testing/bad-commands.ts";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { sleep } from "../clock.ts";
import { RawSocket, type Frame } from "../net/raw-socket.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { BareSocketScript } from "../scripts/bare-socket-script.ts";

const FRAMES = { short: 2_000, long: 40_000 };
/** parallel attackers, far below the connection limit of a robot */
const PARALLEL = 3;
const INTERNALS = /node:|node_modules|file:\/\/|\/src\/|\bat \w+ \(|SQLITE_/;

export const malformedFrames: Scenario = {
  title: "Malformed frames",
  describe: (isLong) =>
    `${isLong ? FRAMES.long : FRAMES.short} broken frames and messages arrive before, as and after the hello of pages and scripts while another robot receives commands`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const pid = relay.pid;
    const testBed = new TestBed(context);
    await testBed.register(relay.url, 2);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "websocket");
    await testBed.waitUntilConnected();
    const [victim, bystander] = testBed.robots;
    if (victim === undefined || bystander === undefined) throw new Error("no robots");
    const { id, driverKey, ownerKey } = victim.registration;
    const path = `/api/v1/robots/${id}/socket`;
    const other = bystander.registration;
    const script = await BareSocketScript.connect(relay.url, other.id, other.driverKey);
    context.onCleanup(() => script.close());
    const connectedAt = bystander.connectedAt;

    const count = context.isLong ? FRAMES.long : FRAMES.short;
    let sent = 0;
    let shown = 0;
    const endTurning = script.keepTurning();
    const attack = async (): Promise<void> => {
      while (sent < count) {
        const socket = await RawSocket.open(relay.url, path);
        const role = random.pick(["own", "drive", "watch", "none"] as const);
        const key = role === "own" ? ownerKey : driverKey;
        if (role !== "none") socket.text(JSON.stringify({ type: "hello", version: 1, role, key }));
        if (role === "own" && random.chance(0.5)) {
          socket.text('{"type":"resume","lastApplied":0,"fresh":false,"endings":[]}');
        }
        for (let n = random.between(1, 12); n > 0 && socket.isOpen; n--) {
          socket.frame(brokenFrame(random));
          sent += 1;
          await sleep(random.between(0, 16));
        }
        if (random.chance(0.2)) socket.halfClose();
        await sleep(random.between(0, 20));
        if (INTERNALS.test(socket.response)) shown += 1;
        socket.destroy();
      }
    };
    await Promise.all(Array.from({ length: PARALLEL }, attack));
    const ends = await endTurning();
    const health = await fetch(`${relay.url}/healthz`);
    return [
      { label: "broken frames sent", measured: sent, bound: { atLeast: count }, unit: "frames" },
      {
        label: "the relay is the same process, and healthy",
        measured: health.ok && relay.pid === pid ? 1 : 0,
        bound: { atLeast: 1 },
        unit: "",
      },
      {
        label: "lost connections of the bystander's page or script",
        measured: Number(script.isClosed) + Number(bystander.connectedAt !== connectedAt),
        bound: { atMost: 0 },
        unit: "",
      },
      {
        label: "commands of the bystander that did not complete",
        // A command that never ends is missing here, but then the scenario itself does not end.
        measured: ends.length === 0 ? NaN : ends.filter((state) => state !== "completed").length,
        bound: { atMost: 0 },
        unit: `of ${ends.length}`,
      },
      {
        label: "responses with a path or a stack trace",
        measured: shown,
        bound: { atMost: 0 },
        unit: "",
      },
    ];
  },
};

function brokenFrame(random: SeededRandom): Frame {
  const command = (): string => random.pick(badCommands).body;
  const bytes = (most: number): Buffer =>
    Buffer.from(Array.from({ length: random.between(0, most) }, () => random.between(0, 255)));
  const kinds: (() => Frame)[] = [
    () => ({ payload: bytes(200) }),
    () => ({ payload: bytes(200), opcode: 2 }),
    () => ({ payload: Buffer.from(command()) }),
    () => ({ payload: Buffer.from(`{"type":"command","command":${command() || "null"}}`) }),
    () => ({ payload: Buffer.from('{"type":"snapshot","epoch":1,"snapshot":null}') }),
    () => ({ payload: Buffer.from('{"type":"ended","epoch":9007199254740993,"seq":1e999}') }),
    () => ({ payload: Buffer.from('{"type":"started","epoch":1,"seq":-1}') }),
    () => ({ payload: Buffer.from('{"type":"seen","seq":NaN}') }),
    () => ({ payload: Buffer.from('{"__proto__":{"type":"hello"},"constructor":1}') }),
    () => ({ payload: Buffer.from('{"type":"hello","version":1,"role":"own","key":"x"}') }),
    () => ({ payload: Buffer.from(`${"[".repeat(8_000)}${"]".repeat(8_000)}`) }),
    () => ({ payload: Buffer.alloc(20_000, "x") }),
    () => ({ payload: Buffer.from([0x22, 0xc3, 0x28, 0x22]) }),
    () => ({ payload: Buffer.from("{"), isLast: false }),
    () => ({ payload: Buffer.from("{}"), opcode: random.between(3, 7) }),
    () => ({ payload: Buffer.from("{}"), opcode: random.between(11, 15) }),
    () => ({ payload: Buffer.from("{}"), reserved: random.between(1, 7) }),
    () => ({ payload: Buffer.from("{}"), isMasked: false }),
    () => ({ payload: Buffer.from("{}"), length: random.between(126, 4_000_000_000) }),
    () => ({ payload: bytes(3), opcode: 8 }),
    () => ({ payload: bytes(300), opcode: 9 }),
    () => ({ payload: Buffer.from("a continuation of nothing"), opcode: 0 }),
  ];
  return random.pick(kinds)();
}
