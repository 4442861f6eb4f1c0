/** Test cases for every port of a robot: inside the relay, and of a client on the network. */
import { describe, expect, it, vi } from "vitest";
import type { EndingState } from "../command-state.ts";
import type { UntilCondition } from "../condition.ts";
import type { ProblemDocument } from "../problem.ts";
import { RefusedError, type RobotPort } from "../robot-port.ts";
import type { Snapshot } from "../snapshot.ts";

/** A robot with its page, and its owner. */
export interface PortWorld {
  page: PortPage;
  /** Opens a port with a new key of the robot. */
  open: (kind: RobotPort["capability"]) => Promise<RobotPort>;
  /** Another page becomes the robot's page. */
  takeOver(): Promise<PortPage>;
  publishMaze: (name: string) => Promise<void>;
  pause(isPaused: boolean): Promise<void>;
  /** Blocks all scripts. */
  block(): Promise<void>;
  /** Revokes the keys of all ports. */
  revoke(): Promise<void>;
  /** Deletes the robot. */
  remove(): Promise<void>;
  /** Lets time pass. */
  pass(ms: number): Promise<void>;
}

/** The page, which does what the test says. */
export interface PortPage {
  report(change: Partial<Snapshot>): void;
  /** seqs of the commands and stops that have arrived, in order */
  arrived(): number[];
  /** seqs of the commands that it was asked to cancel */
  cancelled(): number[];
  started(seq: number): void;
  ended(seq: number, state: EndingState): void;
}

const MOVE = { action: "move", distance: 100 } as const;

/** Records what a subscription receives. */
function follow(port: RobotPort) {
  const ticks: number[] = [];
  const states: string[] = [];
  const mazes: string[] = [];
  const ends: string[] = [];
  const leave = port.subscribe({
    snapshot: ({ tick }) => void ticks.push(tick),
    state: ({ seq, state }) => void states.push(`${seq} ${state}`),
    gap: () => void states.push("gap"),
    maze: (version) => void mazes.push(version),
    end: ({ problem }) => void ends.push(problem.type),
  });
  return { ticks, states, mazes, ends, leave };
}

async function refusalOf(request: Promise<unknown>): Promise<ProblemDocument> {
  const error: unknown = await request.then(
    () => null,
    (reason: unknown) => reason,
  );
  if (error instanceof RefusedError) return error.problem;
  throw new Error("the request was not refused", { cause: error });
}

const kindOf = async (request: Promise<unknown>): Promise<string> =>
  (await refusalOf(request)).type.replace("/problems/", "");

export function robotPortCases(name: string, create: () => Promise<PortWorld>): void {
  /** A world whose page has reported, and a port whose command runs. */
  async function running() {
    const world = await create();
    const port = await world.open("drive");
    world.page.report({ tick: 60 });
    const { seq } = await port.send(MOVE);
    await vi.waitFor(() => expect(world.page.arrived()).toEqual([seq]));
    world.page.started(seq);
    return { world, port, seq };
  }

  describe(`${name}: a port that reads`, () => {
    it.each(["drive", "watch"] as const)("with a %s key follows the robot", async (kind) => {
      const { page, open } = await create();
      const port = await open(kind);
      expect(port.capability).toBe(kind);
      const { ticks } = follow(port);
      page.report({ tick: 61 });
      await vi.waitFor(() => expect(ticks).toEqual([61]));
      expect(port.newest?.tick).toBe(61);
    });

    it("has no snapshot before the robot's first report", async () => {
      const { open } = await create();
      expect((await open("watch")).newest).toBeNull();
    });

    it("has the newest snapshot without a subscription", async () => {
      const { page, open } = await create();
      const port = await open("watch");
      page.report({ tick: 61 });
      await vi.waitFor(() => expect(port.newest?.tick).toBe(61));
    });

    it("receives nothing after it has unsubscribed", async () => {
      const { page, open } = await create();
      const port = await open("watch");
      const { ticks, leave } = follow(port);
      leave();
      page.report({ tick: 61 });
      await vi.waitFor(() => expect(port.newest?.tick).toBe(61));
      expect(ticks).toEqual([]);
    });

    it("reads the maze, and is notified of another one", async () => {
      const { publishMaze, open } = await create();
      const port = await open("watch");
      const { mazes } = follow(port);
      expect(await kindOf(port.readMaze())).toBe("no-maze");
      await publishMaze("First");
      const first = await port.readMaze();
      expect(JSON.parse(first.text)).toMatchObject({ format: "corridor/maze", name: "First" });
      await publishMaze("Second");
      await vi.waitFor(() => expect(mazes).toHaveLength(2));
      const second = await port.readMaze();
      expect(mazes).toEqual([first.version, second.version]);
      expect(second.version).toMatch(/^[\w-]{22}$/);
    });

    it("with a watch key neither sends nor cancels", async () => {
      const { open } = await create();
      const port = await open("watch");
      const problem = await refusalOf(port.send(MOVE));
      expect(problem).toMatchObject({ type: "/problems/forbidden", status: 403 });
      expect(problem.detail).toContain("A watch key permits only reading.");
      expect(await refusalOf(port.cancel(1))).toEqual(problem);
    });
  });

  describe(`${name}: a port that drives`, () => {
    it("sends a command, and waits for its end", async () => {
      const { page, open } = await create();
      const port = await open("drive");
      const { states, ticks } = follow(port);
      const until: UntilCondition[] = [{ sensor: "front", is: "<=", than: 60 }];
      const record = await port.send({ action: "forward", until, ttl: 5_000 }, "my-key-01");
      expect(record).toMatchObject({ seq: 1, key: "my-key-01", state: "accepted" });
      expect(record.command).toEqual({ action: "forward", until });
      await vi.waitFor(() => expect(page.arrived()).toEqual([1]));
      page.started(1);
      const end = port.endOf(1, 25_000);
      page.report({ tick: 90 });
      page.ended(1, "completed");
      expect(await end).toMatchObject({ seq: 1, state: "completed", distance: 50 });
      expect(port.newest?.tick).toBe(90);
      await vi.waitFor(() => expect(states.at(-1)).toBe("1 completed"));
      expect(states).toContain("1 started");
      expect(new Set(ticks)).toEqual(new Set([90]));
    });

    it("waits for the end of a command that has ended", async () => {
      const { world, port, seq } = await running();
      world.page.ended(seq, "collided");
      expect(await port.endOf(seq, 25_000)).toMatchObject({ state: "collided" });
      expect(await port.endOf(seq, 0)).toMatchObject({ state: "collided", duplicate: false });
    });

    it("waits no longer than it was asked to", async () => {
      const { world, port, seq } = await running();
      await vi.waitFor(async () => expect((await port.endOf(seq, 0)).state).toBe("started"));
      const end = port.endOf(seq, 50);
      await world.pass(50);
      expect((await end).state).toBe("started");
    });

    it("reports that a paused run is why its command does not end", async () => {
      const { world, port, seq } = await running();
      await vi.waitFor(async () => expect((await port.endOf(seq, 0)).state).toBe("started"));
      world.page.report({ tick: 61, state: "paused" });
      await vi.waitFor(() => expect(port.newest?.state).toBe("paused"));
      const end = port.endOf(seq, 50);
      await world.pass(50);
      expect((await end).reason).toBe("The run is paused: press Run on the robot's page.");
    });

    it("is informed of the end of another port's command", async () => {
      const { world, seq } = await running();
      const other = await world.open("watch");
      const end = other.endOf(seq, 25_000);
      world.page.ended(seq, "completed");
      expect((await end).state).toBe("completed");
    });

    it("replaces what runs", async () => {
      const { world, port, seq } = await running();
      await port.send({ action: "drive", left: 0.2, right: 0.2, lease: 400, replace: true });
      await vi.waitFor(() => expect(world.page.arrived()).toEqual([seq, seq + 1]));
      world.page.ended(seq, "superseded");
      expect((await port.endOf(seq, 25_000)).state).toBe("superseded");
    });

    it("sends a command once, however often it sends the same key", async () => {
      const { page, open } = await create();
      const port = await open("drive");
      const first = await port.send(MOVE, "my-key-01");
      const again = await port.send(MOVE, "my-key-01");
      expect(again).toMatchObject({ seq: first.seq, duplicate: true });
      expect(await kindOf(port.send({ action: "stop" }, "my-key-01"))).toBe("key-conflict");
      await port.send({ action: "turn", degrees: 45 });
      await vi.waitFor(() => expect(page.arrived()).toEqual([1, 2]));
    });

    it("refuses what is not a command, with the field", async () => {
      const { open } = await create();
      const port = await open("drive");
      const problem = await refusalOf(port.send({ action: "move", distance: 30_000 }));
      expect(problem).toMatchObject({
        type: "/problems/bad-request",
        status: 400,
        errors: [{ path: "distance", found: "30000" }],
      });
      expect(problem.detail).toMatch(/^Invalid command\. distance: found 30000, expected a dist/);
      const { errors } = await refusalOf(port.send(MOVE, "short"));
      expect(errors).toMatchObject([{ path: "key", found: '"short"' }]);
    });

    it("cancels a command", async () => {
      const { world, port, seq } = await running();
      const waiting = await port.send(MOVE);
      await vi.waitFor(() => expect(world.page.arrived()).toHaveLength(2));
      expect(await port.cancel(seq)).toMatchObject({ seq, state: "started" });
      await vi.waitFor(() => expect(world.page.cancelled()).toEqual([seq]));
      world.page.ended(seq, "cancelled");
      expect((await port.endOf(seq, 25_000)).state).toBe("cancelled");
      await port.cancel(waiting.seq);
      await vi.waitFor(() => expect(world.page.cancelled()).toEqual([seq, waiting.seq]));
    });

    it("cancels and waits for its own commands only", async () => {
      const { world, port, seq } = await running();
      const other = await world.open("drive");
      expect(await kindOf(other.cancel(seq))).toBe("forbidden");
      expect(await kindOf(other.cancel(99))).toBe("no-command");
      expect(await kindOf(port.endOf(99, 0))).toBe("no-command");
    });

    it("ends its waits when it is closed", async () => {
      const { port, seq } = await running();
      const over = (): string => "over";
      const end = port.endOf(seq, 25_000).then(over, over);
      port.close();
      expect(await end).toBe("over");
    });
  });

  describe(`${name}: the owner of the robot`, () => {
    it("pauses the port, whose command ends", async () => {
      const { world, port, seq } = await running();
      await world.pause(true);
      await vi.waitFor(() => expect(world.page.cancelled()).toEqual([seq]));
      world.page.ended(seq, "cancelled");
      expect((await port.endOf(seq, 25_000)).state).toBe("cancelled");
      expect(await kindOf(port.send(MOVE))).toBe("driving-paused");
      expect(port.newest).not.toBeNull();
      await world.pause(false);
      expect((await port.send(MOVE)).state).toBe("accepted");
    });

    it.each([
      { does: "blocks the script", act: "block", kind: "blocked" },
      { does: "revokes the key", act: "revoke", kind: "not-authorised" },
      { does: "deletes the robot", act: "remove", kind: "no-robot" },
    ] as const)("$does: the port ends", async ({ act, kind }) => {
      const { world, port, seq } = await running();
      const { ends } = follow(port);
      const end = kindOf(port.endOf(seq, 25_000));
      await world[act]();
      await vi.waitFor(() => expect(ends).toEqual([`/problems/${kind}`]));
      expect(await end).toBe(kind);
      expect(port.newest).toBeNull();
      expect(await kindOf(port.send(MOVE))).toBe(kind);
      expect(await kindOf(port.cancel(seq))).toBe(kind);
      expect(await kindOf(port.endOf(seq, 0))).toBe(kind);
      expect(await kindOf(port.readMaze())).toBe(kind);
      expect(() => follow(port)).toThrow(RefusedError);
      expect(ends).toHaveLength(1);
    });

    it("hands the robot over to another page, which runs the next command", async () => {
      const { world, port, seq } = await running();
      const { ends } = follow(port);
      const end = port.endOf(seq, 25_000);
      const page = await world.takeOver();
      expect((await end).state).toBe("cancelled");
      const next = await port.send(MOVE);
      await vi.waitFor(() => expect(page.arrived()).toEqual([next.seq]));
      expect(world.page.arrived()).toEqual([seq]);
      expect(ends).toEqual([]);
    });
  });
}
