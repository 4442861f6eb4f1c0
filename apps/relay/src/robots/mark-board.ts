/**
 * Marks that scripts draw over the maze. The relay stores none: it sends them to the page and to
 * viewers, here and at other relays.
 */
import type { Marks } from "@corridor/protocol";
import type { RobotChannel } from "./channel/robot-channel.ts";
import type { PageOwnership } from "./page/page-ownership.ts";
import type { Subscribers } from "./readers/subscribers.ts";

export interface MarkBoardParts {
  ownership: Pick<PageOwnership, "page">;
  subscribers: Pick<Subscribers, "publishMarks">;
  channel: Pick<RobotChannel, "marked">;
}

export class MarkBoard {
  readonly #parts: MarkBoardParts;

  constructor(parts: MarkBoardParts) {
    this.#parts = parts;
  }

  /** Publishes marks of a script at this relay. */
  publish(marks: Marks): void {
    this.received(marks);
    this.#parts.channel.marked(marks);
  }

  /** Handles marks of a script, here or at another relay. */
  received(marks: Marks): void {
    const { ownership, subscribers } = this.#parts;
    ownership.page?.connection.send({ type: "marks", ...marks });
    subscribers.publishMarks(marks);
  }
}
