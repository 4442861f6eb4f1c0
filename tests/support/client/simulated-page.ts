/** A page that is the robot, with its real simulation and remote driver, on real time. */
import type { MazeDocument } from "@corridor/maze";
import type { Registration } from "@corridor/protocol";
import { onTestFinished } from "vitest";
import { RobotPage } from "../../../e2e/faults/robots/robot-page.ts";
import { Robot } from "../../../e2e/faults/robots/robot.ts";

/** interval of the page's worker */
const INTERVAL_MS = 8;

export interface SimulatedPage {
  robot: Robot;
  page: RobotPage;
}

/**
 * Starts the page of a robot. It closes with the test.
 * @param origin of its relay
 * @param maze default: that of a first visit
 */
export function startSimulatedPage(
  origin: string,
  registration: Registration,
  maze?: MazeDocument,
): SimulatedPage {
  const robot = new Robot(registration);
  const page = new RobotPage(
    { type: "open", page: robot.page, origin, session: robot.session, transports: "websocket" },
    (message) => {
      if (message.type !== "ready") robot.receive(message);
    },
    maze,
  );
  const timer = setInterval(() => page.advance(), INTERVAL_MS);
  onTestFinished(() => {
    clearInterval(timer);
    page.close();
  });
  return { robot, page };
}

/** Like `startSimulatedPage`, for tests that need only the robot. */
export function openSimulatedPage(...args: Parameters<typeof startSimulatedPage>): Robot {
  return startSimulatedPage(...args).robot;
}
