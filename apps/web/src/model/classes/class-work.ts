/** The work of a student in the class: the lesson, the reports about it, and the survey. */
import type { LessonDocument } from "@corridor/challenge";
import type { JoinedClass, Progress } from "@corridor/protocol";
import type { i18n } from "i18next";
import { createStore } from "zustand/vanilla";
import type {
  ClassReport,
  ClassRequest,
  ClassSession,
} from "../../simulator/protocol/class-messages.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { ChallengeStore } from "../challenge/challenge-store.ts";
import type { LessonsEntry } from "../lessons/lessons-entry.ts";
import type { RunStore } from "../run/run-store.ts";
import { dismiss, showMessage, type ScreenStore } from "../screen/screen-store.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import { ClassLesson, storedLesson } from "./class-lesson.ts";
import { ClassLessonMark } from "./class-lesson-mark.ts";
import { isPaused, type ClassStore } from "./class-store.ts";
import { LessonReporter } from "./lesson-reporter.ts";
import { ProgramOutbox } from "./program-outbox.ts";
import { ProgressOutbox } from "./progress-outbox.ts";
import { readClassLesson, type ReadUrl } from "./read-class-lesson.ts";
import { ReportedWork } from "./reported-work.ts";

type Answers = Extract<Progress, { kind: "survey" }>["answers"];

export interface ClassWorkPorts {
  services: {
    challenge: ChallengeStore;
    classes: ClassStore;
    lessons: Pick<LessonsEntry, "load">;
    run: Pick<RunStore, "getState">;
    screen: ScreenStore;
    simulator: Pick<SimulatorClient, "send" | "listen" | "isGone" | "isResetting">;
    workspace: WorkspaceStore;
  };
  words: Pick<i18n, "t">;
  /** sessionStorage */
  tab: KeyValueStorage;
  joined: JoinedClass;
  request: (request: ClassRequest) => void;
  read: ReadUrl;
  /** monotonic milliseconds */
  now: () => number;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

interface SurveyState {
  /** whether the questions are displayed */
  isOpen: boolean;
  hasAnswered: boolean;
}

export class ClassWork {
  readonly survey = createStore<SurveyState>()(() => ({ isOpen: false, hasAnswered: false }));
  readonly lesson: ClassLesson;
  readonly #ports: ClassWorkPorts;
  readonly #outbox: ProgressOutbox;
  readonly #programs: ProgramOutbox;
  readonly #reported: ReportedWork;
  readonly #reporter: LessonReporter;
  readonly #unsubscribe: () => void;
  #hasAsked = false;
  /** id of the message that offers the survey; null: none */
  #offer: number | null = null;

  constructor(ports: ClassWorkPorts) {
    this.#ports = ports;
    const { services, words, tab, joined, request, read, now, later } = ports;
    const { challenge, classes, lessons, run, screen, simulator, workspace } = services;
    const mark = new ClassLessonMark(storedLesson(tab)?.mark ?? null);
    const send = { send: (report: ClassReport) => request({ kind: "send", report }), now, later };
    this.#outbox = new ProgressOutbox({ ...send, tab });
    this.#programs = new ProgramOutbox(send);
    this.#reported = new ReportedWork(tab);
    this.survey.setState({ hasAnswered: this.#reported.hasAnswered });
    this.#reporter = new LessonReporter({
      challenge,
      workspace,
      run,
      simulator,
      lesson: mark,
      reported: this.#reported,
      add: (event) => {
        this.#outbox.add(event);
        // Who has solved the task needs no help with it.
        if (event.kind === "solved") request({ kind: "help", wanted: false });
      },
      setProgram: (task, link) => this.#programs.set(task, link),
      setPlace: (place) => request({ kind: "place", place }),
      onAllSolved: () => this.#askSurvey(),
      later,
    });
    this.lesson = new ClassLesson({
      read: async () => readClassLesson(joined, read),
      challenge,
      lessons,
      screen,
      tab,
      words,
      lesson: mark,
      isPaused: () => isPaused(classes),
      isDriving: () => run.getState().snapshot?.state === "running",
      onLesson: () => this.#changed(mark.mark),
      onNext: () => this.#reporter.update(),
      onHint: (hint) => this.#reporter.hint(hint),
      later,
    });
    classes.setState({
      onHint: (hint) => {
        this.#reporter.hint(hint);
        this.lesson.openHint(hint);
      },
    });
    this.#unsubscribe = simulator.listen((message) => {
      if (message.type === "class-hint") this.lesson.showHint(message.hint);
    });
  }

  /** The questions of the lesson. */
  questions(): LessonDocument["survey"] {
    return this.lesson.state.getState().document?.survey ?? [];
  }

  follow(session: ClassSession): void {
    this.lesson.follow(session);
    this.#programs.follow(session);
    this.#outbox.follow(session);
  }

  openSurvey(): void {
    this.survey.setState({ isOpen: true });
  }

  closeSurvey(): void {
    this.survey.setState({ isOpen: false });
  }

  answer(answers: Answers): void {
    const { services, words } = this.#ports;
    this.#outbox.add({ kind: "survey", answers });
    this.#reported.answered();
    this.survey.setState({ isOpen: false, hasAnswered: true });
    showMessage(services.screen, { tone: "info", text: words.t("join:survey.thanks") });
  }

  /** The page may close. */
  flush(): void {
    this.#reporter.flush();
  }

  /** The student is not in the class any more. */
  close(): void {
    this.#unsubscribe();
    this.#reporter.close();
    this.lesson.close();
    this.#outbox.close();
    this.#programs.close();
    this.closeSurvey();
    this.#ports.services.classes.setState({ onHint: undefined });
  }

  /** The lesson is known, or another one, which opens after this. */
  #changed(mark: string | null): void {
    this.#reporter.update();
    if (mark !== null) this.#reported.begin(mark);
    this.#hasAsked = false;
    if (this.#offer !== null) dismiss(this.#ports.services.screen, this.#offer);
    this.#offer = null;
    this.survey.setState({ hasAnswered: this.#reported.hasAnswered });
    if (this.#reporter.isAllSolved) this.#askSurvey();
  }

  /** Offers the survey, once. */
  #askSurvey(): void {
    if (this.#hasAsked || this.#reported.hasAnswered || this.questions().length === 0) return;
    this.#hasAsked = true;
    const { services, words } = this.#ports;
    this.#offer = showMessage(services.screen, {
      tone: "info",
      text: words.t("join:survey.ask"),
      stays: true,
      action: { label: words.t("join:survey.answer"), run: () => this.openSurvey() },
    });
  }
}
