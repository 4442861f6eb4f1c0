/** One connection of a ROS client, by rosbridge v2, to one robot. */
import {
  type CloseReason,
  type CommandRecord,
  closeReasons,
  MotionRegister,
  RefusedError,
  type RobotPort,
  TICKS_PER_SECOND,
  type Timers,
} from "@corridor/protocol";
import { CommandEnds } from "./command-ends.ts";
import { wheelPowers } from "./conversions.ts";
import { Goals } from "./goals.ts";
import { absoluteName, shortName } from "./interfaces.ts";
import { readOperation, type Fields, type Operation } from "./operations.ts";
import { isObject, readArguments, readMessage, type Message } from "./read-message.ts";
import { RobotView } from "./robot-view.ts";
import { RosError } from "./ros-error.ts";
import { serviceOf } from "./rosapi.ts";
import { Subscriptions } from "./subscriptions.ts";
import { isVelocityType, topicOf, topics, VELOCITY_TOPIC } from "./topics.ts";

const ERROR_LEVEL = 40;
const MAX_OPEN_CALLS = 64;
const MAX_UNREADABLE = 10;
/** A maze that cannot be read now is read again after this time. */
const RETRY_MS = 1_000;

export interface RosSessionOptions {
  /** The session closes it. */
  port: RobotPort;
  timers: Timers;
  /** Sends a text frame. */
  send(text: string): void;
  /** Closes the connection, because too many messages cannot be read. */
  close(reason: CloseReason, detail: string): void;
  /** Called for each refusal, which the client may not see. */
  onProblem(error: RosError | RefusedError): void;
  /** Called for an error that is no refusal. */
  onFailure(error: unknown): void;
  /** Called once, if the port ends. */
  onEnd(error: RefusedError): void;
}

/** Codes with which a client closes its connection: normal, going away, none. */
const CLOSED_BY_CLIENT: readonly number[] = [1000, 1001, 1005];

export class RosSession {
  readonly #options: RosSessionOptions;
  readonly #view: RobotView;
  readonly #subscriptions: Subscriptions;
  readonly #velocity: MotionRegister;
  readonly #goals: Goals;
  /** the newest velocity that ran; null: none has */
  #driven: number | null = null;
  /** whether it was reported that velocities do not run, and none has run since */
  #isIgnored = false;
  #isClosed = false;
  /** ends the wait until the maze is read again */
  #cancelRetry: () => void = () => undefined;
  /** the newest message of /rosout */
  #problem: object | null = null;
  #unreadable = 0;
  /** calls of services without an answer */
  #openCalls = 0;
  /** whether the client wants `status` messages */
  #sendsStatus = false;

  /** @throws RefusedError if the port permits no subscription */
  constructor(options: RosSessionOptions) {
    this.#options = options;
    const { port, timers } = options;
    this.#view = new RobotView(port);
    this.#subscriptions = new Subscriptions(timers, (name, msg) =>
      this.#send({ op: "publish", topic: name, msg }),
    );
    this.#velocity = new MotionRegister({
      timers,
      running: () => this.#view.snapshot?.command ?? null,
      hasOther: () => !this.#goals.isEmpty,
      send: async (order) => {
        let seq: number | null = null;
        await this.#attempt(async () => {
          ({ seq } = await port.send(order));
        });
        return seq;
      },
    });
    const ends = new CommandEnds(port);
    this.#goals = new Goals({
      port,
      ends,
      view: this.#view,
      send: (message) => this.#send(message),
      takeOver: () => this.#velocity.overtaken(),
      onProblem: (error) => this.#report(error),
    });
    port.subscribe({
      snapshot: (snapshot) => {
        this.#view.update(snapshot);
        this.#velocity.simulated((snapshot.tick * 1000) / TICKS_PER_SECOND);
        if (!this.#view.isReady) return;
        this.#publish("snapshot");
        this.#goals.feedback();
      },
      state: (record) => {
        ends.state(record);
        this.#velocityChanged(record);
      },
      gap: (open) => ends.gap(open),
      maze: () => void this.#readMaze(),
      end: (error) => options.onEnd(error),
    });
    void this.#readMaze();
  }

  /**
   * Handles one message. Never rejects.
   * @returns false if the message cannot be read
   */
  receive(text: string): boolean {
    const read = readOperation(text);
    if (read.ok) {
      void this.#attempt(() => this.#handle(read.operation));
      return true;
    }
    this.#report(new RosError(read.detail));
    if (read.isReadable) return true;
    this.#unreadable += 1;
    if (this.#unreadable === MAX_UNREADABLE) {
      this.#options.close(
        closeReasons.badFrame,
        `${MAX_UNREADABLE} messages could not be read. Send operations of rosbridge v2 as JSON text.`,
      );
    }
    return false;
  }

  /**
   * Closes the session after its connection. If the client closed it, nothing newer follows, so a
   * velocity that waits is sent.
   * @param code of the close frame (RFC 6455)
   */
  disconnected(code: number): void {
    if (CLOSED_BY_CLIENT.includes(code)) this.#velocity.finish();
    this.close();
  }

  /** Closes the session. A velocity that waits is dropped, because it may be old. */
  close(): void {
    this.#isClosed = true;
    this.#cancelRetry();
    this.#velocity.close();
    this.#goals.close();
    this.#subscriptions.close();
    this.#options.port.close();
  }

  #handle(operation: Operation): Promise<void> | undefined {
    switch (operation.op) {
      case "publish":
        this.#receivePublished(operation);
        return undefined;
      case "advertise":
        checkAdvertised(operation);
        return undefined;
      case "subscribe":
        this.#subscribe(operation);
        return undefined;
      case "unsubscribe": {
        const id = operation.id ?? null;
        this.#subscriptions.remove(absoluteName(operation.topic), id === null ? null : String(id));
        return undefined;
      }
      case "call_service":
        return this.#callService(operation);
      case "send_action_goal":
        return this.#goals.start(operation);
      case "cancel_action_goal":
        return this.#goals.cancel(operation);
      case "set_level":
        this.#sendsStatus = operation.level !== "none";
        return undefined;
      // The connection has a key already.
      case "auth":
      case "unadvertise":
        return undefined;
    }
  }

  #receivePublished({ topic, msg }: Fields<"publish">): void {
    const name = absoluteName(topic);
    if (name !== VELOCITY_TOPIC) {
      throw new RosError(`The robot does not subscribe to ${name}, only to ${VELOCITY_TOPIC}.`);
    }
    const isStamped = isObject(msg) && ("twist" in msg || "header" in msg);
    const type = isStamped ? "geometry_msgs/TwistStamped" : "geometry_msgs/Twist";
    const message = readMessage(type, msg);
    const twist = (isStamped ? message["twist"] : message) as Twist;
    const stampMs = isStamped ? stampMsOf(message) : null;
    const powers = wheelPowers({ linear: twist.linear.x, angular: twist.angular.z });
    this.#velocity.set({ action: "drive", ...powers }, stampMs);
  }

  /**
   * A velocity has no answer: if one ends without having run, the reason goes to /rosout, once until
   * another one runs.
   */
  #velocityChanged({ seq, state, reason }: CommandRecord): void {
    if (!this.#velocity.owns(seq)) return;
    if (state === "started") {
      this.#driven = seq;
      this.#isIgnored = false;
    }
    const isRefused = (state === "cancelled" || state === "expired") && seq !== this.#driven;
    if (!isRefused || this.#isIgnored || reason === null) return;
    this.#isIgnored = true;
    this.#report(new RosError(reason));
  }

  #subscribe(request: Fields<"subscribe">): void {
    const name = absoluteName(request.topic);
    const topic = topicOf(name);
    if (topic === null) throw new RosError(`The robot does not publish ${name}.`);
    const type = request.type ?? "";
    if (type !== "" && shortName(type) !== topic.type) {
      throw new RosError(`The topic ${name} has the type ${topic.type}, not ${type}.`);
    }
    if (request.compression === "cbor-raw") {
      throw new RosError("The compression cbor-raw is not supported. Use none.");
    }
    this.#subscriptions.add(name, {
      id: String(request.id ?? ""),
      name: request.topic,
      throttleRate: request.throttle_rate ?? 0,
    });
    if (topic.source === "problem") this.#subscriptions.publish(name, () => this.#problem);
    else if (this.#view.isReady) this.#publishTopic(name);
  }

  async #callService(request: Fields<"call_service">): Promise<void> {
    const { id } = request;
    const name = absoluteName(request.service);
    const reply = (values: unknown, result: boolean): void =>
      this.#send({ op: "service_response", id, service: request.service, values, result });
    this.#openCalls += 1;
    try {
      if (this.#openCalls > MAX_OPEN_CALLS) {
        throw new RosError(`${MAX_OPEN_CALLS} calls have no answer yet, the maximum.`);
      }
      const service = serviceOf(name);
      if (service === null) throw new RosError(`The robot has no service ${name}.`);
      const values = readArguments(`${service.type}_Request`, request.args);
      if (service.isCommand === true) this.#velocity.overtaken();
      reply(await service.call(values, { port: this.#options.port, view: this.#view }), true);
    } catch (error) {
      if (!isRefusal(error)) throw error;
      this.#report(error);
      reply(error.message, false);
    } finally {
      this.#openCalls -= 1;
    }
  }

  async #readMaze(): Promise<void> {
    this.#cancelRetry();
    await this.#attempt(() => this.#view.readMaze());
    if (this.#isClosed) return;
    if (!this.#view.isReady) {
      this.#cancelRetry = this.#options.timers.after(RETRY_MS, () => void this.#readMaze());
      return;
    }
    this.#publish("maze");
    this.#publish("once");
    if (this.#view.snapshot !== null) this.#publish("snapshot");
  }

  #publish(source: "snapshot" | "maze" | "once"): void {
    for (const [name, topic] of Object.entries(topics)) {
      if (topic.source === source) this.#publishTopic(name);
    }
  }

  #publishTopic(name: string): void {
    this.#subscriptions.publish(name, () => topicOf(name)?.message(this.#view) ?? null);
  }

  /** Reports errors. Never rejects. */
  async #attempt(request: () => unknown): Promise<void> {
    try {
      await request();
    } catch (error) {
      if (!isRefusal(error)) this.#options.onFailure(error);
      else if (!this.#isClosed) this.#report(error);
    }
  }

  /** Clients break on unexpected errors, so a refusal without a reply goes to /rosout. */
  #report(error: RosError | RefusedError): void {
    this.#options.onProblem(error);
    this.#problem = {
      stamp: this.#view.stamp,
      level: ERROR_LEVEL,
      name: "corridor",
      msg: error.message,
      file: "",
      function: "",
      line: 0,
    };
    this.#subscriptions.publish("/rosout", () => this.#problem);
    if (this.#sendsStatus) this.#send({ op: "status", level: "error", msg: error.message });
  }

  #send(message: object): void {
    if (!this.#isClosed) this.#options.send(JSON.stringify(message));
  }
}

interface Twist {
  linear: { x: number };
  angular: { z: number };
}

function isRefusal(error: unknown): error is RosError | RefusedError {
  return error instanceof RosError || error instanceof RefusedError;
}

/** @throws RosError if Corridor does not subscribe to the topic, or not with this type */
function checkAdvertised({ topic, type }: Fields<"advertise">): void {
  const name = absoluteName(topic);
  if (name !== VELOCITY_TOPIC) {
    throw new RosError(`The robot does not subscribe to ${name}, only to ${VELOCITY_TOPIC}.`);
  }
  if (isVelocityType(type)) return;
  throw new RosError(
    `${VELOCITY_TOPIC} has the type geometry_msgs/Twist or geometry_msgs/TwistStamped, not ${type}.`,
  );
}

/** ms; null if the stamp is zero */
function stampMsOf(message: Message): number | null {
  const { stamp } = message["header"] as { stamp: { sec: number; nanosec: number } };
  const ms = stamp.sec * 1000 + stamp.nanosec / 1e6;
  return ms === 0 ? null : ms;
}
