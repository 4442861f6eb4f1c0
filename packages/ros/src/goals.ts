/** The actions `/move`, `/turn` and `/do`: goals with feedback, cancel and a result. */
import {
  hasEnded,
  plainActions,
  RefusedError,
  type CommandRecord,
  type EndingState,
  type Order,
  type PlainAction,
  type RobotPort,
} from "@corridor/protocol";
import { centimetres, degreesOf, metres } from "./conversions.ts";
import type { ActionType } from "./interface-texts.ts";
import type { CommandEnds } from "./command-ends.ts";
import { absoluteName, shortName } from "./interfaces.ts";
import type { Fields, ReplyId } from "./operations.ts";
import { readArguments, type Message } from "./read-message.ts";
import type { RobotView } from "./robot-view.ts";
import { RosError } from "./ros-error.ts";

const MAX_OPEN_GOALS = 64;

interface Action {
  type: ActionType;
  /** @throws RosError */
  orderOf(goal: Message): Order;
}

export const actions: Readonly<Record<string, Action>> = {
  "/move": {
    type: "corridor_msgs/Move",
    orderOf: ({ distance }) => ({ action: "move", distance: centimetres(Number(distance)) }),
  },
  "/turn": {
    type: "corridor_msgs/Turn",
    orderOf: ({ angle }) => ({ action: "turn", degrees: -degreesOf(Number(angle)) }),
  },
  "/do": {
    type: "corridor_msgs/Do",
    orderOf: ({ action }) => {
      if (!isPlainAction(action)) {
        throw new RosError(`action: expected one of ${plainActions.join(", ")}.`);
      }
      return { action };
    },
  },
};

/** action_msgs/GoalStatus */
const SUCCEEDED = 4;
const CANCELED = 5;
const ABORTED = 6;
/** of a goal that could not be served */
const UNKNOWN = 0;

const statuses: Record<EndingState, number> = {
  completed: SUCCEEDED,
  cancelled: CANCELED,
  collided: ABORTED,
  superseded: ABORTED,
  expired: ABORTED,
};

interface Goal {
  /** absolute */
  name: string;
  /** as the client sent it */
  action: string;
  id: ReplyId;
  wantsFeedback: boolean;
  /** number of its command; null until it is stored */
  seq: number | null;
  isCancelled: boolean;
  /** pose at its first snapshot; null before it */
  from: { x: number; y: number } | null;
}

export interface GoalsOptions {
  port: RobotPort;
  view: RobotView;
  ends: CommandEnds;
  send(message: object): void;
  /** Discards an earlier velocity. @returns whether it has not been sent yet */
  takeOver(): boolean;
  /** Called for each refusal. */
  onProblem(error: RosError | RefusedError): void;
}

export class Goals {
  readonly #options: GoalsOptions;
  readonly #open = new Set<Goal>();
  #isClosed = false;

  constructor(options: GoalsOptions) {
    this.#options = options;
  }

  get isEmpty(): boolean {
    return this.#open.size === 0;
  }

  /** Sends a goal to the robot, and its result at the end. Never rejects. */
  async start(request: Fields<"send_action_goal">): Promise<void> {
    const { id } = request;
    const goal: Goal = {
      name: absoluteName(request.action),
      action: request.action,
      id,
      wantsFeedback: request.feedback === true,
      seq: null,
      isCancelled: false,
      from: null,
    };
    try {
      const order = this.#orderOf(request, goal.name);
      // The velocity would have ended what was sent before it.
      if (this.#options.takeOver()) order.replace = true;
      this.#open.add(goal);
      const record = await this.#run(goal, order);
      if (!hasEnded(record.state)) return;
      const status = statuses[record.state];
      this.#result(request, { values: this.#valuesOf(record), status, result: true });
    } catch (error) {
      if (!(error instanceof RosError || error instanceof RefusedError)) throw error;
      if (this.#isClosed) return;
      this.#options.onProblem(error);
      this.#result(request, { values: error.message, status: UNKNOWN, result: false });
    } finally {
      this.#open.delete(goal);
    }
  }

  /** The result of the goal follows. @throws RosError if no such goal runs */
  async cancel(request: Fields<"cancel_action_goal">): Promise<void> {
    const goal = this.#find(absoluteName(request.action), request.id);
    if (goal === null) throw new RosError("cancel_action_goal: no goal with this id runs.");
    goal.isCancelled = true;
    if (goal.seq !== null) await this.#options.port.cancel(goal.seq);
  }

  /** Sends the feedback of the goal that runs. */
  feedback(): void {
    const { view } = this.#options;
    const { snapshot } = view;
    if (snapshot === null || !view.isReady) return;
    for (const goal of this.#open) {
      if (goal.seq === null || goal.seq !== snapshot.command) continue;
      goal.from ??= snapshot.pose;
      if (!goal.wantsFeedback) continue;
      const { x, y, theta } = view.poseOf(snapshot.pose);
      const dx = snapshot.pose.x - goal.from.x;
      const dy = snapshot.pose.y - goal.from.y;
      const distance = metres(Math.sqrt(dx * dx + dy * dy));
      const { action, id } = goal;
      const values = { distance, x, y, theta };
      this.#options.send({ op: "action_feedback", id, action, values });
    }
  }

  close(): void {
    this.#isClosed = true;
    this.#options.ends.close();
  }

  #orderOf(request: Fields<"send_action_goal">, name: string): Order {
    const action = Object.hasOwn(actions, name) ? actions[name] : undefined;
    const names = Object.keys(actions).join(", ");
    if (action === undefined) throw new RosError(`The robot has no action ${name}, only ${names}.`);
    const type = request.action_type ?? "";
    if (type !== "" && shortName(type) !== action.type) {
      throw new RosError(`The action ${name} has the type ${action.type}, not ${type}.`);
    }
    if (this.#open.size >= MAX_OPEN_GOALS) {
      throw new RosError(`${MAX_OPEN_GOALS} goals run or wait, the maximum.`);
    }
    if (this.#find(name, request.id) !== null) {
      throw new RosError("A goal with this id runs. Use another id.");
    }
    return action.orderOf(readArguments(`${action.type}_Goal`, request.args));
  }

  /** @param name absolute */
  #find(name: string, id: ReplyId): Goal | null {
    if (id === undefined || id === null) return null;
    for (const goal of this.#open) if (goal.name === name && goal.id === id) return goal;
    return null;
  }

  async #run(goal: Goal, order: Order): Promise<CommandRecord> {
    const { port, ends } = this.#options;
    const { record, end } = await ends.send(async () => port.send(order));
    goal.seq = record.seq;
    if (goal.isCancelled) await port.cancel(record.seq);
    return end;
  }

  #valuesOf({ state, reason, distance, pose }: CommandRecord): object {
    const { x, y, theta } =
      pose === null ? { x: 0, y: 0, theta: 0 } : this.#options.view.poseOf(pose);
    return { state, reason: reason ?? "", distance: metres(distance ?? 0), x, y, theta };
  }

  #result(
    { id, action }: Fields<"send_action_goal">,
    outcome: { values: unknown; status: number; result: boolean },
  ): void {
    if (!this.#isClosed) this.#options.send({ op: "action_result", id, action, ...outcome });
  }
}

function isPlainAction(action: unknown): action is PlainAction {
  return plainActions.some((each) => each === action);
}
