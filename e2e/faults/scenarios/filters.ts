/** School-like filters between the clients and the relay: every client connects. */
import { openFilterProxy, type FilterMode } from "../../../tests/support/client/filter-proxy.ts";
import type { Goal } from "../../../benches/core/goals.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow, sleep, waitUntil } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import type { Scenario, ScenarioContext } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { ExampleScript, hasProgram } from "../scripts/example-script.ts";
import { ClientScript } from "../scripts/client-script.ts";

const IDLE_MS = 30_000;
const TIMEOUT_MS = 30_000;

const filterKinds: readonly { label: string; mode: FilterMode; idleMs: number }[] = [
  { label: "Upgrade stripped", mode: "stripped", idleMs: 0 },
  { label: "idle close 30 s", mode: "impatient", idleMs: IDLE_MS + 5_000 },
  { label: "buffering", mode: "buffering", idleMs: 0 },
];

/** a client, and a function that makes it send its second command */
interface Client {
  label: string;
  robot: Robot;
  /** by `machineNow` */
  startedAt: number;
  /** null: the client continues by itself */
  sendNext: (() => void) | null;
}

export const filters: Scenario = {
  title: "Filters",
  describe: () =>
    `The page, the TypeScript and Python libraries and the Java example connect through three filters. One strips Upgrade, one closes connections that are idle for ${IDLE_MS / 1000} s (the scripts pause for ${IDLE_MS / 1000 + 5} s), and one buffers responses until they end`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const goals: Goal[] = [];
    for (const filter of filterKinds) goals.push(...(await behind(filter, relay, context)));
    return goals;
  },
};

async function behind(
  { label, mode, idleMs }: (typeof filterKinds)[number],
  relay: RelayProcess,
  context: ScenarioContext,
): Promise<Goal[]> {
  const proxy = await openFilterProxy(relay.url, mode, IDLE_MS);
  context.onCleanup(() => proxy.close());
  const testBed = new TestBed(context);
  await testBed.register(relay.url, 3);
  const pages = await testBed.startPages();
  for (const robot of testBed.robots) testBed.open(robot, pages, proxy.origin, "both");
  const pagesMs = await testBed.waitUntilConnected(TIMEOUT_MS);
  const goals = [within(`${label}: until the page connects`, pagesMs)];
  const clients = await startClients(testBed, proxy.origin, context);
  for (const client of clients) {
    const first = await nthStart(client.robot, 1);
    goals.push(
      within(`${label}: ${client.label}, until the first command starts`, first - client.startedAt),
    );
  }
  await sleep(idleMs);
  for (const { label: client, robot, sendNext: goOn } of clients) {
    const at = machineNow();
    goOn?.();
    const next = (await nthStart(robot, 2)) - at;
    goals.push(within(`${label}: ${client}, until the next command starts`, Math.max(0, next)));
  }
  return goals;
}

async function startClients(
  testBed: TestBed,
  origin: string,
  context: ScenarioContext,
): Promise<Client[]> {
  const [first, second, third] = testBed.robots;
  if (first === undefined || second === undefined || third === undefined)
    throw new Error("no robots");
  const addressOf = ({ registration: { id, driverKey } }: Robot): string =>
    `${origin}/r/${id}#${driverKey}`;
  const clients: Client[] = [];
  const add = (label: string, robot: Robot, start: () => ExampleScript): void => {
    const startedAt = machineNow();
    const script = start();
    context.onCleanup(() => script.kill());
    clients.push({
      label,
      robot,
      startedAt,
      sendNext: label === "Java" ? null : () => script.sendNext(),
    });
  };
  if (hasProgram("python3")) add("Python", second, () => ExampleScript.python(addressOf(second)));
  else context.log("Python is skipped: python3 is not installed");
  if (hasProgram("java")) add("Java", third, () => ExampleScript.java(addressOf(third)));
  else context.log("Java is skipped: java is not installed");
  const startedAt = machineNow();
  const script = await ClientScript.connect(first, origin, "both");
  context.onCleanup(() => script.close());
  const turn = (): void => script.post({ action: "turn", degrees: 5 });
  turn();
  clients.push({ label: "TypeScript", robot: first, startedAt, sendNext: turn });
  return clients;
}

/** The time at which the robot started its nth command; Infinity if it did not. */
async function nthStart({ starts }: Robot, n: number): Promise<number> {
  await waitUntil(() => starts.length >= n, TIMEOUT_MS);
  return starts[n - 1]?.at ?? Infinity;
}

function within(label: string, measured: number): Goal {
  return { label, measured, bound: { atMost: 10_000 }, unit: "ms" };
}
