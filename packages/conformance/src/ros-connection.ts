/** A connection as a ROS client opens it: JSON messages of rosbridge v2 in a WebSocket. */
import { connectSocket } from "./connection.ts";
import { pause, type Host } from "./host.ts";
import { must, valueAt } from "./mismatch.ts";

const TIMEOUT_MS = 5_000;
const POLL_MS = 20;

export class RosConnection {
  /** all received messages, in order */
  readonly received: unknown[] = [];
  readonly #socket: WebSocket;
  #code: number | null = null;
  #ids = 0;

  private constructor(socket: WebSocket, closed: Promise<number>) {
    this.#socket = socket;
    socket.addEventListener("message", ({ data }) => {
      this.received.push(JSON.parse(String(data)));
    });
    void closed.then((code) => (this.#code = code));
  }

  /** Opens a connection with the robot's key in the header, and closes it after `use`. */
  static async use<T>(host: Host, use: (ros: RosConnection) => Promise<T>): Promise<T> {
    const { socket, opened, closed } = connectSocket(host.gatewayUrl("ros"), host.authorization());
    const ros = new RosConnection(socket, closed);
    const code = await Promise.race([opened, closed]);
    must(code === null, "a connection with the key in the header Authorization", "none");
    try {
      return await use(ros);
    } finally {
      socket.close(1000);
      await Promise.race([closed, pause(TIMEOUT_MS)]);
    }
  }

  send(message: { op: string } & Record<string, unknown>): void {
    this.#socket.send(JSON.stringify(message));
  }

  /** @returns the values of the answer @throws Mismatch if the service fails */
  async call(service: string): Promise<unknown> {
    this.#ids += 1;
    const id = `call_service:${service}:${this.#ids}`;
    this.send({ op: "call_service", id, service, args: {} });
    const answer = await this.#message(
      (each) => valueAt(each, "op") === "service_response" && valueAt(each, "id") === id,
      `an answer of ${service}`,
    );
    must(valueAt(answer, "result") === true, `an answer of ${service} with result true`, answer);
    return valueAt(answer, "values");
  }

  /** The first message of a topic, which is the newest one of the robot. */
  async firstOf(topic: string): Promise<unknown> {
    this.send({ op: "subscribe", topic });
    const isOf = (each: unknown): boolean => valueAt(each, "topic") === topic;
    return valueAt(await this.#message(isOf, `a message of ${topic}`), "msg");
  }

  async #message(fits: (message: unknown) => boolean, what: string): Promise<unknown> {
    const deadline = performance.now() + TIMEOUT_MS;
    for (;;) {
      const found = this.received.find(fits);
      if (found !== undefined) return found;
      must(this.#code === null, what, `close code ${this.#code}`);
      must(performance.now() < deadline, what, `nothing of it within ${TIMEOUT_MS / 1_000} s`);
      await pause(POLL_MS);
    }
  }
}
