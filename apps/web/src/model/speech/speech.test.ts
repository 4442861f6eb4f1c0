import { describe, expect, it } from "vitest";
import { Speech } from "./speech.ts";

/** The announcements, with a clock that the test moves. */
function listen() {
  let time = 0;
  const due: (() => void)[] = [];
  const speech = new Speech({ now: () => time, later: (run) => due.push(run) });
  const said: string[] = [];
  speech.announcement.subscribe(({ text }) => said.push(text));
  return {
    speech,
    said,
    /** A second passes. */
    wait: () => {
      time += 1000;
      for (const run of due.splice(0)) run();
    },
  };
}

describe("Speech", () => {
  it("never says a verdict that was withdrawn before its turn", () => {
    const { speech, said, wait } = listen();
    speech.announce("Bump: look at line 1.");
    speech.announceState("mission", "Time is up after 20 s.");
    speech.announceState("mission", null);
    speech.announce("The robot is back at its start.");
    wait();
    wait();
    expect(said).toEqual(["Bump: look at line 1.", "The robot is back at its start."]);
  });

  it("drops the pending bump of a run that is over", () => {
    const { speech, said, wait } = listen();
    speech.announce("Stored.");
    speech.announce("Bump.", "run event");
    speech.drop("run event");
    speech.speak({ kind: "state", text: "The robot is back at its start.", about: null });
    wait();
    wait();
    expect(said).toEqual(["Stored.", "The robot is back at its start."]);
  });

  it("clears a withdrawn verdict that is still displayed", () => {
    const { speech, said } = listen();
    speech.announceState("mission", "Time is up after 20 s.");
    speech.announceState("mission", null);
    expect(said).toEqual(["Time is up after 20 s.", ""]);
  });
});
