import type { CommandRecord, CommandState } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { History, type FaultKind } from "./history.ts";

const TTL = 400;
const TOLERANCE = 100;

/** A history in which a script sends three commands and the robot executes them. */
class Story {
  readonly history = new History(TOLERANCE);
  readonly stored: CommandRecord[] = [];
  #now = 0;

  constructor(commands = 3) {
    for (let seq = 1; seq <= commands; seq++) this.command(seq);
  }

  command(seq: number): void {
    const record = this.record(seq, "accepted");
    this.history.tried(`key-${seq}`, { sender: "script", at: this.#now, ttl: TTL });
    this.history.acknowledged(record);
    this.did(seq, "started");
    this.did(seq, "completed");
    const ended = { ...this.record(seq, "completed"), acceptedAt: record.acceptedAt };
    this.history.reported(ended);
    this.stored.push(ended);
  }

  did(seq: number, what: CommandState, page = 1): void {
    this.history.did({ seq, what, page, at: (this.#now += 10) });
  }

  record(seq: number, state: CommandState, key = `key-${seq}`): CommandRecord {
    const command = { action: "left 90" } as const;
    const nothing = { reason: null, pose: null, distance: null, duplicate: false };
    const acceptedAt = new Date(this.#now).toISOString();
    return { seq, key, action: command.action, command, state, acceptedAt, ...nothing };
  }

  /** Changes the stored record of a command. */
  stores(seq: number, change: Partial<CommandRecord>): void {
    const record = this.stored[seq - 1];
    if (record !== undefined) this.stored[seq - 1] = { ...record, ...change };
  }

  pass(ms: number): void {
    this.#now += ms;
  }

  faults(): FaultKind[] {
    return this.history.check(this.stored).map(({ kind }) => kind);
  }
}

describe("a consistent history", () => {
  it("has no faults", () => {
    expect(new Story().faults()).toEqual([]);
  });

  it("may contain a start that is late by less than the tolerance", () => {
    const story = new Story(0);
    story.history.tried("key-1", { sender: "script", at: -TTL - TOLERANCE + 10, ttl: TTL });
    story.command(1);
    expect(story.faults()).toEqual([]);
  });

  it("may contain a start that is late by the transit time of the accepted attempt", () => {
    const story = new Story(0);
    story.history.tried("key-1", { sender: "script", at: -800, ttl: TTL });
    story.stored.push(story.record(1, "completed"));
    for (const what of ["started", "completed"] as const) story.did(1, what);
    expect(story.faults()).toEqual([]);
    expect(story.history.longestTransit).toBe(800);
  });

  it("may contain a first attempt that was accepted late, despite a retry in between", () => {
    const story = new Story(0);
    for (const at of [-800, -500]) {
      story.history.tried("key-1", { sender: "script", at, ttl: TTL });
    }
    const record = story.record(1, "completed");
    story.stored.push(record);
    story.history.given(1, Date.parse(record.acceptedAt) + TTL);
    story.pass(TTL);
    for (const what of ["started", "completed"] as const) story.did(1, what);
    expect(story.faults()).toEqual([]);
    expect(story.history.longestTransit).toBe(800);
  });

  it("may lack the ending of a command that a page had started before a reload", () => {
    const story = new Story();
    story.history.tried("key-4", { sender: "script", at: 60, ttl: TTL });
    story.did(4, "started");
    story.history.left(1);
    story.stored.push({
      ...story.record(4, "cancelled"),
      reason: "The robot's page was reloaded and ended this command. Send a new command.",
    });
    expect(story.faults()).toEqual([]);
  });
});

describe("a fault is detected:", () => {
  it.each<{ name: string; is: FaultKind[]; happens: (story: Story) => void }>([
    {
      name: "the store has lost an acknowledged command",
      is: ["lost"],
      happens: ({ stored }) => void stored.pop(),
    },
    {
      name: "a number was never assigned",
      is: ["lost"],
      happens: ({ stored }) => void stored.shift(),
    },
    {
      name: "a command never ends",
      is: ["lost"],
      happens: (story) => {
        story.stored.push(story.record(4, "delivered"));
      },
    },
    {
      name: "a retry is stored and executed again",
      is: ["doubled"],
      happens: (story) => {
        story.did(4, "started");
        story.did(4, "completed");
        story.stored.push(story.record(4, "completed", "key-3"));
      },
    },
    {
      name: "two commands have one number",
      is: ["doubled", "lost"],
      happens: (story) => story.history.acknowledged(story.record(3, "completed", "key-9")),
    },
    {
      name: "a command moves the robot again after a reload",
      is: ["doubled", "reordered"],
      happens: (story) => {
        story.history.left(1);
        story.did(3, "started", 2);
      },
    },
    {
      name: "a later command starts first",
      is: ["reordered"],
      happens: (story) => {
        for (const seq of [5, 4]) {
          story.did(seq, "started");
          story.did(seq, "completed");
        }
        story.stored.push(story.record(4, "completed"), story.record(5, "completed"));
      },
    },
    {
      name: "a script's commands are stored in another order than it sent them",
      is: ["reordered"],
      happens: (story) => {
        const attempt = { sender: "script", at: 60, ttl: TTL };
        story.history.tried("key-5", attempt);
        story.command(4);
        story.command(5);
      },
    },
    {
      name: "the robot ends a command twice",
      is: ["ended twice"],
      happens: (story) => story.did(2, "cancelled"),
    },
    {
      name: "a script receives two endings",
      is: ["ended twice"],
      happens: (story) => {
        story.history.reported(story.record(2, "expired"));
        story.history.reported(story.record(2, "completed"));
      },
    },
    {
      name: "the relay ends a command that the robot has started",
      is: ["ended twice"],
      happens: (story) => story.stores(2, { state: "expired" }),
    },
    {
      name: "the robot did not execute a completed command",
      is: ["ended twice"],
      happens: (story) => story.stored.push(story.record(4, "completed")),
    },
    {
      name: "a command starts after its ttl",
      is: ["late"],
      happens: (story) => {
        story.history.tried("key-4", { sender: "script", at: 60, ttl: TTL });
        story.stored.push(story.record(4, "completed"));
        story.pass(TTL + TOLERANCE);
        story.did(4, "started");
        story.did(4, "completed");
      },
    },
    {
      name: "a command with a timestamp is late by its transit time",
      is: ["late"],
      happens: (story) => {
        story.history.tried("key-4", { sender: "script", at: -800, ttl: TTL, isTimed: true });
        story.stored.push(story.record(4, "completed"));
        story.did(4, "started");
        story.did(4, "completed");
      },
    },
    {
      name: "a retry has an age that matches no attempt",
      is: ["late"],
      happens: (story) => {
        const at = 60;
        story.history.tried("key-4", { sender: "script", at, ttl: TTL });
        story.pass(300);
        story.history.tried("key-4", { sender: "script", at: at + 300, ttl: TTL });
        story.stored.push(story.record(4, "completed"));
        story.history.given(4, at + 300 + TTL - 100);
        story.pass(TTL - 110);
        story.did(4, "started");
        story.did(4, "completed");
      },
    },
    {
      name: "a retry starts after the ttl of the first attempt",
      is: ["late"],
      happens: (story) => {
        story.history.tried("key-4", { sender: "script", at: 60, ttl: TTL });
        story.pass(TTL - 50);
        story.history.tried("key-4", { sender: "script", at: 60 + TTL - 50, ttl: TTL });
        story.stored.push(story.record(4, "completed"));
        story.pass(TTL - 50);
        story.did(4, "started");
        story.did(4, "completed");
      },
    },
  ])("$name", ({ is, happens }) => {
    const story = new Story();
    happens(story);
    expect(new Set(story.faults())).toEqual(new Set(is));
  });
});
