/**
 * Two thousand frames that no client should send: the relay lives, and who drives beside them
 * notices nothing.
 */
import { badCommands } from "../../../apps/relay/src/testing/bad-commands.ts";
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { sleep } from "../clock.ts";
import { RawSocket, type Frame } from "../net/raw-socket.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { LineScript } from "../scripts/line-script.ts";

const FRAMES = { short: 2_000, long: 40_000 };
/** as many as one robot lets be connected at once, by far */
const AT_ONCE = 3;
const INTERNALS = /node:|node_modules|file:\/\/|\/src\/|\bat \w+ \(|SQLITE_/;

export const malformedFrames: Row = {
  title: "Malformed frames",
  does: (isLong) =>
    `${isLong ? FRAMES.long : FRAMES.short} broken frames and messages before, as and after the greeting of pages and scripts, while another robot is driven`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const pid = relay.pid;
    const scene = new Scene(terms);
    await scene.register(relay.url, 2);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "websocket");
    await scene.allConnected();
    const [victim, bystander] = scene.robots;
    if (victim === undefined || bystander === undefined) throw new Error("no robots");
    const { id, driverKey, ownerKey } = victim.registration;
    const path = `/api/v1/robots/${id}/socket`;
    const other = bystander.registration;
    const script = await LineScript.connect(relay.url, other.id, other.driverKey);
    terms.after(() => script.close());
    const connectedAt = bystander.connectedAt;

    const wanted = terms.isLong ? FRAMES.long : FRAMES.short;
    let sent = 0;
    let shown = 0;
    const ends: string[] = [];
    let isOver = false;
    const driving = (async () => {
      for (let n = 0; !isOver; n++) {
        const { state } = await script.run({ action: n % 2 === 0 ? "left 90" : "right 90" });
        ends.push(state);
      }
    })();
    const attack = async (): Promise<void> => {
      while (sent < wanted) {
        const socket = await RawSocket.open(relay.url, path);
        const role = dice.pick(["own", "drive", "watch", "none"] as const);
        const key = role === "own" ? ownerKey : driverKey;
        if (role !== "none") socket.text(JSON.stringify({ type: "hello", version: 1, role, key }));
        if (role === "own" && dice.isLucky(0.5)) {
          socket.text('{"type":"resume","lastApplied":0,"fresh":false,"endings":[]}');
        }
        for (let n = dice.between(1, 12); n > 0 && socket.isOpen; n--) {
          socket.frame(brokenFrame(dice));
          sent += 1;
          await sleep(dice.between(0, 16));
        }
        if (dice.isLucky(0.2)) socket.halfClose();
        await sleep(dice.between(0, 20));
        if (INTERNALS.test(socket.answer)) shown += 1;
        socket.destroy();
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE }, attack));
    isOver = true;
    await driving;
    const health = await fetch(`${relay.url}/healthz`);
    return [
      { label: "broken frames sent", measured: sent, bound: { atLeast: wanted }, unit: "frames" },
      {
        label: "the relay is the same process, and well",
        measured: health.ok && relay.pid === pid ? 1 : 0,
        bound: { atLeast: 1 },
        unit: "",
      },
      {
        label: "lines of the bystander that were lost, its page's or its script's",
        measured: Number(script.isClosed) + Number(bystander.connectedAt !== connectedAt),
        bound: { atMost: 0 },
        unit: "",
      },
      {
        label: "commands of the bystander that did not complete",
        // One that never ended is not in the list, but the row waits for it to its own end.
        measured: ends.length === 0 ? NaN : ends.filter((state) => state !== "completed").length,
        bound: { atMost: 0 },
        unit: `of ${ends.length}`,
      },
      {
        label: "answers with a path or a stack in them",
        measured: shown,
        bound: { atMost: 0 },
        unit: "",
      },
    ];
  },
};

function brokenFrame(dice: Dice): Frame {
  const command = (): string => dice.pick(badCommands).body;
  const bytes = (most: number): Buffer =>
    Buffer.from(Array.from({ length: dice.between(0, most) }, () => dice.between(0, 255)));
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
    () => ({ payload: Buffer.from("{}"), opcode: dice.between(3, 7) }),
    () => ({ payload: Buffer.from("{}"), opcode: dice.between(11, 15) }),
    () => ({ payload: Buffer.from("{}"), reserved: dice.between(1, 7) }),
    () => ({ payload: Buffer.from("{}"), isMasked: false }),
    () => ({ payload: Buffer.from("{}"), length: dice.between(126, 4_000_000_000) }),
    () => ({ payload: bytes(3), opcode: 8 }),
    () => ({ payload: bytes(300), opcode: 9 }),
    () => ({ payload: Buffer.from("a continuation of nothing"), opcode: 0 }),
  ];
  return dice.pick(kinds)();
}
