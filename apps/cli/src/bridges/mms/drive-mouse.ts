/** Connects a micromouse program with the robot. */
import { MouseSession } from "@corridor/mouse";
import type { BridgedRobot } from "../bridged-robot.ts";
import { clock } from "../clock.ts";
import { log, type RunningBridge } from "../run-bridge.ts";
import { MouseProgram } from "./mouse-program.ts";
import type { ProgramCall } from "./split-program.ts";

/** @throws BridgeError if the program cannot be started */
export async function driveMouse(robot: BridgedRobot, call: ProgramCall): Promise<RunningBridge> {
  const program = await MouseProgram.start(call);
  const port = robot.openPort();
  let isRobotLost = false;
  let isClosed = false;
  void robot.ended.then(() => (isRobotLost = true));
  const failed = new Promise<number>((resolve) => {
    const fail = (error: Error): void => {
      // If the robot itself has ended, the reason is printed once.
      setImmediate(() => {
        if (!isRobotLost && !isClosed) log(error.message);
        resolve(1);
      });
    };
    MouseSession.start({
      port,
      timers: clock,
      respond: (line) => program.write(line),
      report: log,
      mark: (marks) => robot.mark(marks),
      onEnd: fail,
    })
      .then((session) => program.read((text) => session.receive(text)))
      .catch(fail);
  });
  const exited = program.ended.then((failure) => {
    if (failure === null) return 0;
    if (!isClosed) log(failure);
    return 1;
  });
  const close = async (): Promise<void> => {
    isClosed = true;
    port.close();
    await program.stop();
  };
  return { ended: Promise.race([exited, failed]), close };
}
