import fc from "fast-check";
import { expect, it } from "vitest";
import * as diagnostics from "./diagnose-run.ts";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { RunLoop } from "./run-loop.ts";
import { speeds } from "../protocol/worker-messages.ts";

const anyAction = fc.oneof(
  fc.constantFrom(
    "run" as const,
    "step" as const,
    "play" as const,
    "now" as const,
    "forward" as const,
  ),
  fc.constantFrom("back" as const, "on" as const, "remote" as const, "reset" as const),
  fc.record({ speed: fc.constantFrom(...speeds.filter((each) => each !== "max")) }),
  fc.record({ wait: fc.integer({ min: 0, max: 400 }) }),
  fc.record({ seek: fc.integer({ min: 0, max: 600 }) }),
);

type Action = typeof anyAction extends fc.Arbitrary<infer T> ? T : never;

/** Presses a button, or lets time pass. @returns milliseconds that pass */
function press(loop: RunLoop, action: Action): number {
  if (action === "run") loop.run();
  else if (action === "step") loop.step();
  else if (action === "play") loop.play();
  else if (action === "now") loop.now();
  else if (action === "forward") loop.hold("forward");
  else if (action === "back") loop.seekStep(-1);
  else if (action === "on") loop.seekStep(1);
  else if (action === "remote") loop.setDriver("remote");
  else if (action === "reset") loop.reset();
  else if ("speed" in action) loop.setSpeed(action.speed);
  else if ("seek" in action) loop.seek(action.seek);
  else return action.wait;
  return 0;
}

it("Pause pauses at any speed, whatever was pressed just before it", () => {
  let ran = 0;
  fc.assert(
    fc.property(fc.array(anyAction, { minLength: 1, maxLength: 12 }), (actions) => {
      let time = 0;
      const loop = new RunLoop(firstMaze, firstProgram, () => time);
      loop.updates.useDiagnostics(diagnostics);
      loop.setSpeed(8);
      loop.run();
      for (const action of actions) {
        const waited = press(loop, action);
        time += waited;
        if (waited > 0) loop.advance();
      }
      if (loop.isRunning) ran++;
      loop.pause();
      expect(loop.isRunning).toBe(false);
      loop.updates.take();
      const { tick } = loop.snapshot();
      time += 1000;
      loop.advance();
      expect(loop.snapshot()).toMatchObject({ tick, state: "paused" });
    }),
    { numRuns: 60 },
  );
  expect(ran).toBeGreaterThan(5);
});

it("a script reads `paused` while nobody drives, and `running` while Remote waits for it", () => {
  let time = 0;
  const loop = new RunLoop(firstMaze, firstProgram, () => time);
  const pass = () => {
    time += 1000;
    loop.advance();
    return loop.snapshot();
  };
  expect(pass()).toMatchObject({ driver: "program", state: "paused", tick: 0 });
  loop.setDriver("me");
  expect(pass()).toMatchObject({ driver: "me", state: "paused", tick: 0 });
  loop.hold("forward");
  expect(pass()).toMatchObject({ driver: "me", state: "running" });
  loop.hold("stop");
  expect(pass()).toMatchObject({ driver: "me", state: "paused" });
  loop.setDriver("remote");
  const { tick } = loop.snapshot();
  expect(pass()).toMatchObject({ driver: "remote", state: "running", motion: "stop" });
  expect(loop.snapshot().tick).toBeGreaterThan(tick);
});

it("nothing moves the robot while the class is paused", () => {
  fc.assert(
    fc.property(fc.array(anyAction, { minLength: 1, maxLength: 12 }), (actions) => {
      let time = 0;
      const loop = new RunLoop(firstMaze, firstProgram, () => time);
      loop.updates.useDiagnostics(diagnostics);
      loop.run();
      time += 500;
      loop.advance();
      loop.suspend(true);
      for (const action of actions) {
        time += press(loop, action) + 100;
        loop.advance();
        expect(loop.isRunning).toBe(false);
      }
      loop.suspend(false);
      loop.run();
      expect(loop.isRunning).toBe(true);
    }),
    { numRuns: 60 },
  );
});

it("a run that the class interrupted continues as the same run", () => {
  let time = 0;
  const pass = (loop: RunLoop, ms: number): void => {
    for (let i = 0; i < ms; i += 50) {
      time += 50;
      loop.advance();
    }
  };
  const begin = (): RunLoop => {
    const loop = new RunLoop(firstMaze, firstProgram, () => time);
    loop.run();
    pass(loop, 1_000);
    return loop;
  };
  const whole = begin();
  pass(whole, 2_000);
  const interrupted = begin();
  interrupted.suspend(true);
  // The relay states the same pause again whenever the page connects.
  interrupted.suspend(true);
  const { tick } = interrupted.snapshot();
  pass(interrupted, 60_000);
  expect(interrupted.snapshot()).toMatchObject({ tick, state: "paused" });
  interrupted.suspend(false);
  expect(interrupted.isRunning).toBe(true);
  pass(interrupted, 2_000);
  expect(interrupted.saveRun()).toEqual(whole.saveRun());
});

it.each([
  { name: "stood still", prepare: (loop: RunLoop) => loop.pause() },
  { name: "was driven by hand", prepare: (loop: RunLoop) => loop.hold("forward") },
])("a robot that $name before a pause of the class waits after it", ({ prepare }) => {
  const loop = new RunLoop(firstMaze, firstProgram, () => 0);
  loop.run();
  prepare(loop);
  loop.suspend(true);
  loop.suspend(false);
  expect(loop.isRunning).toBe(false);
});

it("a run that was reset during a pause of the class does not continue", () => {
  const loop = new RunLoop(firstMaze, firstProgram, () => 0);
  loop.run();
  loop.suspend(true);
  loop.reset();
  loop.suspend(false);
  expect(loop.isRunning).toBe(false);
});

it("a step that the class interrupted ends at its decision", () => {
  let time = 0;
  const loop = new RunLoop(firstMaze, firstProgram, () => time);
  loop.step("tick");
  loop.suspend(true);
  loop.suspend(false);
  time += 1_000;
  loop.advance();
  expect(loop.snapshot()).toMatchObject({ tick: 1, state: "paused" });
});
