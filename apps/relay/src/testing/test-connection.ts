/** A minimal client of long-poll connections. */
import {
  fetchedMessagesSchema,
  openedConnectionSchema,
  type Registration,
} from "@corridor/protocol";
import type { AskOptions, Requests } from "./test-relay.ts";

type PathRequest = (path: string, request: AskOptions) => Promise<Response>;

/** A minimal client of a long-poll connection. It makes one request at a time. */
export class TestConnection {
  readonly #request: PathRequest;
  readonly key: string;
  #sent = 0;
  #after = 0;

  private constructor(request: PathRequest, key: string) {
    this.#request = request;
    this.key = key;
  }

  /** Connects to a robot. */
  static async open(relay: Requests, robot: Registration, hello: object): Promise<TestConnection> {
    return TestConnection.to((path, request) => relay.ask(robot, path, request), hello);
  }

  /** @param request to a path below the robot or the class */
  static async to(request: PathRequest, hello: object): Promise<TestConnection> {
    const body = { type: "hello", version: 1, ...hello };
    const answer = await request("/long-poll", { method: "POST", body });
    return new TestConnection(request, openedConnectionSchema.parse(await answer.json()).key);
  }

  async send(...messages: object[]): Promise<unknown> {
    const first = this.#sent + 1;
    this.#sent += messages.length;
    return this.post({ first, messages });
  }

  async post(body: unknown): Promise<unknown> {
    const answer = await this.#ask("POST", "", body);
    return answer.json();
  }

  async fetch(wait = 25) {
    const answer = await this.#ask("GET", `?after=${this.#after}&wait=${wait}`);
    return fetchedMessagesSchema.parse(await answer.json());
  }

  /** Returns the next message of this type and discards earlier ones. */
  async next(type: string): Promise<Record<string, unknown>> {
    for (;;) {
      const { first, messages, closed } = await this.fetch();
      const index = messages.findIndex((message) => message.type === type);
      this.#after = first + (index < 0 ? messages.length : index + 1) - 1;
      const found = messages[index];
      if (found !== undefined) return found;
      if (closed !== null) throw new Error(`closed with ${closed.code}`);
    }
  }

  status(): Promise<number> {
    return this.#ask("GET", "?wait=0").then(({ status }) => status);
  }

  #ask(method: string, query: string, body?: unknown): Promise<Response> {
    const path = `/long-poll/messages${query}`;
    return this.#request(path, { method, key: this.key, body });
  }
}
