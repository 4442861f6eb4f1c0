/**
 * One micromouse program and one robot, by the text protocol of the simulator mms. The program asks
 * line by line. Walls are what the robot's own sensors read.
 */
import { readMaze, type MazeDocument } from "@corridor/maze";
import {
  hasEnded,
  RefusedError,
  type CommandRecord,
  type Marks,
  type Order,
  type RobotPort,
  type Snapshot,
  type Timers,
} from "@corridor/protocol";
import { LineBuffer } from "./line-buffer.ts";
import { MarkRegister } from "./mark-register.ts";
import { MazeFrame, type Place } from "./maze-frame.ts";
import { readMouseCommand, type RobotCommand } from "./mouse-command.ts";
import { ResetWatch } from "./reset-watch.ts";
import { Score } from "./score.ts";
import { WallSensors } from "./wall-sensors.ts";

/** Commands that wait for their turn. A program that sends more is no longer read. */
const MAX_WAITING = 64;
/** The longest wait of a port. */
const WAIT_MS = 25_000;
/** After a command that the page's Reset has ended, the robot reports its new run within this time. */
const RESET_MS = 1_000;
/** Characters of an invalid command in a report. */
const MAX_REPORTED = 60;

export interface MouseSessionOptions {
  /** The session closes it. */
  port: RobotPort;
  timers: Timers;
  /** Sends a line to the program. @returns resolves when the program accepts more */
  respond(line: string): void | Promise<void>;
  /** Shows a sentence to the person who started the program. */
  report(sentence: string): void;
  mark(marks: Marks): void;
  /** Called once, if the robot cannot be driven any more. */
  onEnd(error: Error): void;
}

/** The robot no longer does what the program expects. */
export class MouseError extends Error {
  override readonly name = "MouseError";
}

export class MouseSession {
  readonly #options: MouseSessionOptions;
  readonly #frame: MazeFrame;
  readonly #sensors: WallSensors;
  readonly #marks: MarkRegister;
  readonly #score = new Score();
  readonly #lines = new LineBuffer();
  readonly #waiting: RobotCommand[] = [];
  readonly #resets: ResetWatch;
  #isWorking = false;
  #isClosed = false;
  #onRoom: (() => void) | null = null;
  /** the newest reason why a command did not start */
  #obstacle: string | null = null;

  /**
   * Puts the robot at its start. If the robot ends meanwhile, `onEnd` may be called, too.
   * @throws RefusedError of the port, or MouseError
   */
  static async start(options: MouseSessionOptions): Promise<MouseSession> {
    const frame = new MazeFrame(await mazeOf(options.port));
    const session = new MouseSession(options, frame);
    if (!frame.startsInCorner) {
      options.report(
        "The robot does not start in a corner of the maze, as programs for mms expect.",
      );
    }
    try {
      await session.#carryToStart();
    } catch (error) {
      session.close();
      throw error;
    }
    return session;
  }

  private constructor(options: MouseSessionOptions, frame: MazeFrame) {
    this.#options = options;
    this.#frame = frame;
    this.#sensors = new WallSensors(frame);
    this.#marks = new MarkRegister(frame, options.timers, (marks) => options.mark(marks));
    this.#resets = new ResetWatch(options.port.newest);
    const ignored = (): void => undefined;
    options.port.subscribe({
      snapshot: (snapshot) => this.#resets.update(snapshot),
      end: (error) => this.#end(error),
      state: ignored,
      gap: ignored,
      maze: ignored,
    });
  }

  /**
   * Reads what the program has written.
   * @returns resolves when the program may write more. Do not call it before
   */
  async receive(text: string): Promise<void> {
    for (const line of this.#lines.add(text)) {
      if (this.#isClosed) return;
      const read = readMouseCommand(line);
      if (read === null) this.#reportInvalid(line);
      else if (read.kind === "display") this.#marks.apply(read.command);
      else await this.#enqueue(read.command);
    }
  }

  close(): void {
    if (this.#isClosed) return;
    this.#isClosed = true;
    this.#onRoom?.();
    this.#marks.close();
    this.#options.port.close();
  }

  #reportInvalid(line: string): void {
    this.#options.report(`Invalid command: ${line.slice(0, MAX_REPORTED)}`);
  }

  async #enqueue(command: RobotCommand): Promise<void> {
    this.#waiting.push(command);
    void this.#work();
    if (this.#waiting.length < MAX_WAITING) return;
    await new Promise<void>((resolve) => {
      this.#onRoom = resolve;
    });
  }

  /** Responds to the commands that wait, one after the other. Never rejects. */
  async #work(): Promise<void> {
    if (this.#isWorking) return;
    this.#isWorking = true;
    try {
      for (let [next] = this.#waiting; next !== undefined; [next] = this.#waiting) {
        const response = await this.#execute(next);
        if (this.#isClosed) return;
        await this.#options.respond(response);
        this.#waiting.shift();
        this.#onRoom?.();
      }
    } catch (error) {
      this.#end(error instanceof Error ? error : new MouseError(String(error)));
    } finally {
      this.#isWorking = false;
    }
  }

  #end(error: Error): void {
    if (this.#isClosed) return;
    this.close();
    this.#options.onEnd(error);
  }

  async #execute(command: RobotCommand): Promise<string> {
    switch (command.do) {
      case "width":
        return String(this.#frame.columns);
      case "height":
        return String(this.#frame.rows);
      case "wall":
        return String(
          this.#sensors.freeHalfSteps(this.#robot, command.eighths) < command.halfSteps,
        );
      case "move":
        return (await this.#move(command.halfSteps)) ? "ack" : "crash";
      case "turn":
        this.#score.addTurn();
        await this.#drive(turnBy(command.eighths));
        this.#arrive();
        return "ack";
      case "stat":
        return this.#score.get(command.name);
      case "was-reset":
        return String(this.#resets.isPending);
      case "acknowledge-reset":
        this.#score.penalize();
        await this.#carryToStart();
        return "ack";
    }
  }

  /** @returns whether the robot has driven as far as it should */
  async #move(halfSteps: number): Promise<boolean> {
    const free = this.#sensors.freeHalfSteps(this.#robot, 0);
    const length = Math.min(halfSteps, free);
    if (length < 1) return false;
    if (this.#isAtStart) this.#score.begin();
    this.#score.addMove(length / 2);
    const distance = length * this.#frame.halfStep;
    const { state } = await this.#drive({ action: "move", distance });
    this.#arrive();
    return length === halfSteps && state === "completed";
  }

  #arrive(): void {
    if (this.#frame.isGoal(this.#cell)) this.#score.finish();
    else if (this.#isAtStart) this.#score.abandon();
  }

  /** Puts the robot at its start, and turns it to the program's north. */
  async #carryToStart(): Promise<void> {
    try {
      await this.#resets.during(() => this.#drive({ action: "reset" }));
    } catch (error) {
      // A physical robot cannot reset itself, and owners may forbid it.
      if (!(error instanceof RefusedError) || !isResetRefusal(error)) throw error;
      this.#options.report(error.message);
    }
    const turned = this.#frame.eighthsOf(this.#robot.pose.heading);
    if (turned !== 0) await this.#drive(turnBy(turned > 4 ? 8 - turned : -turned));
  }

  /** Sends a command until the robot has executed it. */
  async #drive(order: Order): Promise<CommandRecord> {
    for (;;) {
      const resets = this.#resets.count;
      const record = await this.#endOf(await this.#send(order));
      if (record.state === "expired") {
        this.#reportObstacle(record.reason);
        continue;
      }
      this.#obstacle = null;
      this.#sensors.observe(this.#robot);
      const isDone = record.state === "completed" || record.state === "collided";
      if (isDone || (await this.#hasReset(resets))) return record;
      throw new MouseError(record.reason ?? `A command of the program ended as ${record.state}.`);
    }
  }

  /** Sends a command, again if the robot accepts it only later. */
  async #send(order: Order): Promise<number> {
    for (;;) {
      try {
        return (await this.#options.port.send(order)).seq;
      } catch (error) {
        if (!(error instanceof RefusedError) || error.retryAfter === null) throw error;
        await this.#pause(error.retryAfter * 1000);
      }
      this.#checkOpen();
    }
  }

  async #endOf(seq: number): Promise<CommandRecord> {
    for (;;) {
      const record = await this.#options.port.endOf(seq, WAIT_MS);
      this.#checkOpen();
      if (hasEnded(record.state)) return record;
      this.#reportObstacle(record.reason);
    }
  }

  /** Whether the page has put the robot back since `count` resets, which ends its commands. */
  async #hasReset(count: number): Promise<boolean> {
    if (this.#resets.count === count)
      await this.#pause(RESET_MS, (end) => this.#resets.onNext(end));
    return this.#resets.count > count;
  }

  /** Waits, at most until `observe` notifies. */
  async #pause(ms: number, observe?: (end: () => void) => () => void): Promise<void> {
    const cleanups: (() => void)[] = [];
    await new Promise<void>((resolve) => {
      cleanups.push(this.#options.timers.after(ms, resolve));
      if (observe !== undefined) cleanups.push(observe(resolve));
    });
    for (const cleanUp of cleanups) cleanUp();
  }

  /** Each reason once. */
  #reportObstacle(reason: string | null): void {
    if (reason !== null && reason !== this.#obstacle) this.#options.report(reason);
    this.#obstacle = reason;
  }

  #checkOpen(): void {
    if (this.#isClosed) throw new MouseError("The session is closed.");
  }

  get #robot(): Snapshot {
    const { newest } = this.#options.port;
    if (newest === null) throw new MouseError("The robot has not reported its position.");
    return newest;
  }

  get #cell(): Place {
    const { x, y } = this.#frame.placeOf(this.#robot.pose);
    return { x: Math.floor(x / 2), y: Math.floor(y / 2) };
  }

  get #isAtStart(): boolean {
    const { x, y } = this.#cell;
    return x === 0 && y === 0;
  }
}

/** @throws RefusedError, or MouseError if the maze cannot be read */
async function mazeOf(port: RobotPort): Promise<MazeDocument> {
  const maze = readMaze((await port.readMaze()).text);
  if (!maze.ok) throw new MouseError("The maze of the robot cannot be read.");
  return maze.value;
}

/** @param turned eighths of a full turn clockwise */
function turnBy(turned: number): Order {
  if (turned === 2) return { action: "right 90" };
  if (turned === -2) return { action: "left 90" };
  return Math.abs(turned) === 4 ? { action: "turn 180" } : { action: "turn", degrees: turned * 45 };
}

function isResetRefusal({ problem }: RefusedError): boolean {
  return problem.type === "/problems/reset-disabled" || problem.type === "/problems/not-supported";
}
