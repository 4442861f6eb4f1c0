/** A page and a script with their own robot, which requests of other clients must not affect. */
import type { Registration } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { completed } from "../platform/testing/messages.ts";
import type { Requests } from "./test-relay.ts";
import { TestSocket } from "./test-socket.ts";

export class Bystander {
  readonly robot: Registration;
  readonly #page: TestSocket;
  readonly #script: TestSocket;
  readonly #epoch: number;
  #seq = 0;

  private constructor(robot: Registration, page: TestSocket, script: TestSocket, epoch: number) {
    this.robot = robot;
    this.#page = page;
    this.#script = script;
    this.#epoch = epoch;
  }

  static async at(relay: Requests): Promise<Bystander> {
    const robot = await relay.register();
    const { socket, epoch } = await TestSocket.page(relay, robot);
    return new Bystander(robot, socket, await TestSocket.driver(relay, robot), epoch);
  }

  /** The script drives the page over their existing connections. */
  async drives(): Promise<void> {
    this.#seq += 1;
    const seq = this.#seq;
    this.#script.send({ type: "command", command: { action: "left 90" } });
    expectSeq(await this.#page.next("command"), seq);
    this.#page.send({ type: "started", epoch: this.#epoch, seq });
    this.#page.send({ type: "snapshot", epoch: this.#epoch, snapshot: snapshotOf({ seq }) });
    this.#page.send({ type: "ended", epoch: this.#epoch, ...completed(seq) });
    for (;;) {
      const { record } = await this.#script.next("state");
      if ((record as { state?: unknown }).state === "completed") return;
    }
  }
}

function expectSeq(message: { [field: string]: unknown }, seq: number): void {
  if (message["seq"] !== seq) throw new Error(`command ${String(message["seq"])}, not ${seq}`);
}
