import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { Timeline } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { describeTick, tickText } from "./tick-description.ts";

const { t } = createI18n(en);

/**
 * Me for 4 s with a bump at 3 s, then line 2, which turns at 6 s; the goal at 10 s by "otherwise".
 */
const timeline = new Timeline();
timeline.recordDriver(0, "me");
timeline.recordEvent({ kind: "bump", tick: 180, driver: "me" });
timeline.recordDriver(240, 1);
timeline.recordEvent({ kind: "edit", what: "program", tick: 300, driver: 1 });
timeline.recordEvent({ kind: "turn", turn: "delayed right 90", tick: 360, driver: 1 });
timeline.recordDriver(480, "default");
timeline.recordEvent({ kind: "goal", tick: 600, driver: "default" });
timeline.advanceTo(600);

describe("the description of a tick", () => {
  it.each([
    [0, "0.0 s, you drive"],
    [178, "2.9 s, you drive"],
    [180, "3.0 s, you drive, bump"],
    [185, "3.0 s, you drive, bump"],
    [186, "3.1 s, you drive"],
    [240, "4.0 s, line 2 drives"],
    [302, "5.0 s, line 2 drives, program changed"],
    [360, "6.0 s, line 2 drives, delayed right 90"],
    [599, "9.9 s, “otherwise” drives, goal reached"],
    [600, "10.0 s, “otherwise” drives, goal reached"],
  ])("at the end of tick %i are %j", (tick, words) => {
    expect(tickText(t, describeTick(timeline, tick))).toBe(words);
  });

  it("name minutes from the first one on, with the decimal sign of the language", () => {
    const words = (tick: number, language?: string) =>
      tickText(t, { tick, waited: 0, who: null, command: null, event: null }, language);
    expect(words(3599)).toBe("59.9 s");
    expect(words(3600)).toBe("1 min 0.0 s");
    expect(words(749_763)).toBe("208 min 16.0 s");
    expect(words(749_763, "de")).toBe("208 min 16,0 s");
  });

  it("name the line that every part of the page names at the displayed tick", () => {
    const displayed = snapshotOf({ tick: 600, driver: "program", line: 0 });
    const words = (tick: number, change: Partial<Snapshot> = {}) =>
      tickText(t, describeTick(timeline, tick, { ...displayed, ...change }));
    expect(words(600)).toBe("10.0 s, line 1 drives, goal reached");
    expect(words(240)).toBe("4.0 s, line 2 drives");
    expect(words(600, { driver: "me", line: null })).toBe("10.0 s, you drive, goal reached");
    expect(words(600, { line: null })).toBe("10.0 s, goal reached");
  });

  it("before a run are its time alone", () => {
    expect(tickText(t, describeTick(new Timeline(), 0))).toBe("0.0 s");
  });

  it("of a script count driving and waiting apart, as its clock and its cards do", () => {
    const run = new Timeline();
    run.recordDriver(0, "remote");
    run.commands.setWaiting(0, true);
    run.commands.setWaiting(60, false);
    run.commands.recordStart(1, { action: "move", distance: 5000 }, 60);
    run.commands.recordEnd(210, "collided");
    run.recordEvent({ kind: "bump", tick: 210, driver: "remote" });
    run.advanceTo(210);
    expect(tickText(t, describeTick(run, 210))).toBe(
      "2.5 s driving, 1.0 s waiting, command 1: move 5000, collided, bump",
    );
  });

  it("of a script name the command with its number and result, and the wait between two", () => {
    const run = new Timeline();
    run.recordDriver(0, "remote");
    run.commands.recordStart(7, { action: "move", distance: 50 }, 60);
    run.commands.recordEnd(120, "collided");
    run.commands.recordStart(8, { action: "left 90" }, 180);
    run.advanceTo(200);
    const words = [30, 60, 120, 150, 190].map((tick) => tickText(t, describeTick(run, tick)));
    expect(words).toEqual([
      "0.5 s, the script waits",
      "1.0 s, command 7: move 50, collided",
      "2.0 s, command 7: move 50, collided",
      "2.5 s, the script waits",
      "3.1 s, command 8: left 90, running",
    ]);
  });
});
