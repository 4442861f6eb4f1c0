import { lessonMark, type LessonDocument } from "@corridor/challenge";
import type { JoinedClass } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ClassStudent } from "../../simulator/protocol/class-messages.ts";
import { SimulatorClient } from "../../simulator/simulator-client.ts";
import { en } from "../../text/en/index.ts";
import join from "../../text/en/join.json";
import { createI18n } from "../../text/i18n.ts";
import { createChallengeStore, noChallenge } from "../challenge/challenge-store.ts";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { createRunStore } from "../run/run-store.ts";
import { createScreenStore } from "../screen/screen-store.ts";
import { VolatileStorage } from "../storage/volatile-storage.ts";
import { createWorkspaceStore } from "../workspace/workspace-store.ts";
import { createClassStore } from "./class-store.ts";
import { ClassWork } from "./class-work.ts";

const [task] = sampleLesson.tasks;
if (task?.mazes[0] === undefined) throw new Error("the sample lesson has no maze");
const [maze] = task.mazes;
const questions = [{ id: "navigation", question: "Was it easy?" }];
const first: LessonDocument = { ...sampleLesson, name: "One", survey: questions };
const second: LessonDocument = { ...first, name: "Two" };

/** A student's page in a class. Lessons open at once. */
function newPage() {
  const challenge = createChallengeStore();
  const screen = createScreenStore();
  const words = createI18n(en);
  words.addResourceBundle("en", "join", join);
  const timers = new Set<() => void>();
  const show = (lesson: LessonDocument, isSolved: boolean) =>
    challenge.setState({
      ...noChallenge,
      lesson,
      index: 0,
      lessonId: lessonMark(lesson),
      solved: lesson.tasks.map(() => isSolved),
    });
  let sent = first;
  const work = new ClassWork({
    services: {
      challenge,
      classes: createClassStore(),
      lessons: {
        load: async () =>
          ({ navigation: { resume: (lesson: LessonDocument) => show(lesson, false) } }) as never,
      },
      run: createRunStore(),
      screen,
      simulator: new SimulatorClient({ postMessage: () => undefined, onmessage: null }),
      workspace: createWorkspaceStore(
        maze,
        { format: "corridor/program", version: 1, name: "", rules: [], default: "forward" },
        (_, after) => after,
      ),
    },
    words,
    tab: new VolatileStorage(),
    joined: {} as JoinedClass,
    request: () => undefined,
    read: async () => ({ ok: true, text: async () => JSON.stringify(sent) }),
    now: () => 0,
    later: (call) => {
      timers.add(call);
      return () => void timers.delete(call);
    },
  });
  const settle = async () => new Promise((resolve) => setTimeout(resolve));
  return {
    work,
    challenge,
    show,
    offers: () => screen.getState().messages.filter(({ action }) => action?.label === "Answer"),
    send: async (lesson: LessonDocument, version: string) => {
      sent = lesson;
      const stored = { progress: 0, program: 0 };
      const student = { lesson: version, paceTo: null, stored } as ClassStudent;
      work.follow({ status: { kind: "connected" }, student });
      await settle();
      const due = [...timers];
      timers.clear();
      for (const call of due) call();
      await settle();
    },
  };
}

describe("the survey of a class", () => {
  it("has the questions of a second lesson after those of the first were answered", async () => {
    const { work, challenge, send } = newPage();
    await send(first, "v1");
    work.answer([{ id: "navigation", answer: 4 }]);
    await send(second, "v2");
    expect(challenge.getState().lesson?.name).toBe("Two");
    expect(work.survey.getState().hasAnswered).toBe(false);
  });

  it("is not offered any more once the teacher has sent another lesson", async () => {
    const { show, send, offers } = newPage();
    await send(first, "v1");
    show(first, true);
    expect(offers()).toHaveLength(1);
    await send({ ...second, survey: [] }, "v2");
    expect(offers()).toEqual([]);
  });
});
