/** Filters as schools have them stand between everybody and the relay: every client finds a way. */
import { openFilterProxy, type Harm } from "../../../packages/client/src/testing/filter-proxy.ts";
import type { Goal } from "../../../benches/core/goals.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { machineNow, sleep, until } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import type { Row, Terms } from "../row.ts";
import { Scene } from "../scene.ts";
import { ExampleScript, hasProgram } from "../scripts/example-script.ts";
import { SocketScript } from "../scripts/socket-script.ts";

const IDLE_MS = 30_000;
const PATIENCE_MS = 30_000;

const filters: readonly { label: string; harm: Harm; idleMs: number }[] = [
  { label: "Upgrade stripped", harm: "stripped", idleMs: 0 },
  { label: "idle close 30 s", harm: "impatient", idleMs: IDLE_MS + 5_000 },
  { label: "buffering", harm: "buffering", idleMs: 0 },
];

/** A client, and what has it send its second command. */
interface Client {
  label: string;
  robot: Robot;
  /** by `machineNow` */
  startedAt: number;
  /** null: it goes on by itself */
  goOn: (() => void) | null;
}

export const filtered: Row = {
  title: "Filters",
  does: () =>
    `page, TypeScript and Python library and the example in Java behind a filter that strips Upgrade, one that closes what is silent for ${IDLE_MS / 1000} s (and a pause of 35 s), and one that keeps answers back until they have ended`,
  run: async (terms) => {
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const goals: Goal[] = [];
    for (const filter of filters) goals.push(...(await behind(filter, relay, terms)));
    return goals;
  },
};

async function behind(
  { label, harm, idleMs }: (typeof filters)[number],
  relay: RelayProcess,
  terms: Terms,
): Promise<Goal[]> {
  const proxy = await openFilterProxy(relay.url, harm, IDLE_MS);
  terms.after(() => proxy.close());
  const scene = new Scene(terms);
  await scene.register(relay.url, 3);
  const pages = await scene.startPages();
  for (const robot of scene.robots) scene.open(robot, pages, proxy.origin, "both");
  const pagesMs = await scene.allConnected(PATIENCE_MS);
  const goals = [within(`${label}: the page has the robot`, pagesMs)];
  const clients = await startClients(scene, proxy.origin, terms);
  for (const client of clients) {
    const first = await nthStart(client.robot, 1);
    goals.push(within(`${label}: ${client.label}, first command begins`, first - client.startedAt));
  }
  await sleep(idleMs);
  for (const { label: who, robot, goOn } of clients) {
    const at = machineNow();
    goOn?.();
    const next = (await nthStart(robot, 2)) - at;
    goals.push(within(`${label}: ${who}, next command begins`, Math.max(0, next)));
  }
  return goals;
}

async function startClients(scene: Scene, origin: string, terms: Terms): Promise<Client[]> {
  const [first, second, third] = scene.robots;
  if (first === undefined || second === undefined || third === undefined)
    throw new Error("no robots");
  const addressOf = ({ registration: { id, driverKey } }: Robot): string =>
    `${origin}/r/${id}#${driverKey}`;
  const clients: Client[] = [];
  const add = (label: string, robot: Robot, start: () => ExampleScript): void => {
    const startedAt = machineNow();
    const script = start();
    terms.after(() => script.kill());
    clients.push({ label, robot, startedAt, goOn: label === "Java" ? null : () => script.goOn() });
  };
  if (hasProgram("python3")) add("Python", second, () => ExampleScript.python(addressOf(second)));
  else terms.say("Python is left out: there is no python3 here");
  if (hasProgram("java")) add("Java", third, () => ExampleScript.java(addressOf(third)));
  else terms.say("Java is left out: there is no java here");
  const startedAt = machineNow();
  const script = await SocketScript.connect(first, origin, "both");
  terms.after(() => script.close());
  const turn = (): void => script.post({ action: "turn", degrees: 5 });
  turn();
  clients.push({ label: "TypeScript", robot: first, startedAt, goOn: turn });
  return clients;
}

/** When the robot began with its nth command; Infinity when it did not. */
async function nthStart({ starts }: Robot, n: number): Promise<number> {
  await until(() => starts.length >= n, PATIENCE_MS);
  return starts[n - 1]?.at ?? Infinity;
}

function within(label: string, measured: number): Goal {
  return { label, measured, bound: { atMost: 10_000 }, unit: "ms" };
}
