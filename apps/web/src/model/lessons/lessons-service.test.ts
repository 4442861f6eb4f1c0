import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { createChallengeStore } from "../challenge/challenge-store.ts";
import { createScreenStore } from "../screen/screen-store.ts";
import { createWorkspaceStore, openProject, setProgram } from "../workspace/workspace-store.ts";
import { checkProgram } from "../../simulator/check-worker/check-program.ts";
import type { CheckAnswer, CheckRequest } from "../../simulator/protocol/check-request.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { RunJudge } from "../../simulator/worker/run-judge.ts";
import { RunLoop } from "../../simulator/worker/run-loop.ts";
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";
import { ChallengeChecker } from "./challenge-checker.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { LessonsService } from "./lessons-service.ts";
import { LessonsStorage } from "./lessons-storage.ts";
import { lines, type MissionId } from "./missions/mission.ts";

/** A page with an open mission, its robot, and the check in this thread. */
function openMission(id: MissionId) {
  const challenge = createChallengeStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const storage = new LessonsStorage(new MemoryStorage());
  let judgeId = 0;
  let emit: (message: FromWorker) => void = () => undefined;
  const ports = {
    challenge,
    workspace,
    storage,
    screen: createScreenStore(),
    words: { t: (key: string) => key, loadNamespaces: () => Promise.resolve() },
    projects: {
      beginNew: (...[maze, program]: Parameters<LessonsPorts["projects"]["beginNew"]>) => {
        openProject(workspace, maze, program ?? firstProgram);
      },
      backAction: () => () => undefined,
      currentId: () => "project",
      list: () => [],
    },
    simulator: {
      send: (message: Parameters<LessonsPorts["simulator"]["send"]>[0]) => {
        if (message.type === "judge") judgeId = message.id;
      },
      listen: (listener: typeof emit) => {
        emit = listener;
        return () => undefined;
      },
    },
  } as unknown as LessonsPorts;
  const port: ReturnType<ConstructorParameters<typeof ChallengeChecker>[0]> = {
    postMessage: (request: CheckRequest) => {
      queueMicrotask(() =>
        port.onmessage?.({ data: checkProgram(request) } as MessageEvent<CheckAnswer>),
      );
    },
    onmessage: null,
    onerror: null,
    terminate: () => undefined,
  };
  const service = new LessonsService(ports, new ChallengeChecker(() => port), {
    location: { pathname: "/", search: "", hash: "" },
    history: { pushState: () => undefined, replaceState: () => undefined },
    onMove: () => undefined,
  });
  service.openMission(id);
  const open = challenge.getState().challenge;
  if (open === null) throw new Error("no challenge");
  let time = 0;
  const loop = new RunLoop(workspace.getState().maze, workspace.getState().program, () => time);
  loop.judgeBy(new RunJudge(open, 0));
  return {
    challenge,
    storage,
    clock: () => loop.snapshot().tick,
    program: (program: ReturnType<typeof lines>) => {
      setProgram(workspace, program);
      loop.editProgram(program);
    },
    /** Runs the program, and reports a new judgement. */
    drive: (seconds: number) => {
      loop.run();
      for (const end = time + 1000 * seconds; time < end;) {
        time += 8;
        loop.advance();
      }
      const judgement = loop.takeJudgement();
      if (judgement !== null) emit({ type: "judgement", id: judgeId, judgement });
    },
  };
}

const nearWall = { sensor: "front", is: "<", than: 50 } as const;
const wavering = lines("forward", { when: nearWall, do: "reverse" });
const solving = lines("forward", { when: nearWall, do: "turn 180" });

describe("the figures of a solved mission", () => {
  it("are those of the run on the screen if the program was edited during it", async () => {
    const page = openMission("one-line");
    page.program(wavering);
    page.drive(6);
    page.program(solving);
    page.drive(10);
    await expect.poll(() => page.challenge.getState().result.state).toBe("met");
    const ticks = page.clock();
    expect(page.challenge.getState().result).toMatchObject({ ticks, bumps: 0, lines: 1 });
    // The best result is that of the program from the start.
    const best = page.storage.record.done["one-line"]?.ticks ?? 0;
    expect(best).toBeGreaterThan(0);
    expect(best).toBeLessThan(ticks - 200);
  });

  it("are equally those of the check if the program drove from the start", async () => {
    const page = openMission("one-line");
    page.program(solving);
    page.drive(10);
    await expect.poll(() => page.challenge.getState().result.state).toBe("met");
    const ticks = page.clock();
    expect(page.challenge.getState().result).toMatchObject({ ticks });
    expect(page.storage.record.done["one-line"]).toEqual({ lines: 1, ticks });
  });
});
