/** Connects the run to the announcements: puts the notes of `RunEar` into words. */
import { causeLine, type Diagnosis } from "@corridor/coach";
import type { Services } from "../../app/services.ts";
import { asSentence, joinSentences } from "../../text/joined.ts";
import { formatSeconds } from "../../text/numbers.ts";
import type { RunState } from "../../stores/run-store.ts";
import type { RunEvent } from "../../worker/worker-messages.ts";
import { diagnosisText, diagnosisTitle, diagnosisWords } from "../cards/diagnosis-text.ts";
import { momentAt, sayMoment } from "../timeline/shown-moment.ts";
import { timelineOf } from "../timeline/timeline-of.ts";
import { storyOf, storyText } from "../transport/story.ts";
import { RunEar, type RunTalk } from "./run-listener.ts";
import { decisionText, spoken, type Words } from "./run-words.ts";

type Ports = Pick<Services, "challenge" | "run" | "workspace" | "screen" | "timeline" | "speech">;

/** The number of fixes that the card offers. */
function fixCount(t: Words["t"], { fixes }: Diagnosis): string[] {
  return fixes.length > 0 ? [spoken(t)("runDetails:speech.fixes", { count: fixes.length })] : [];
}

/**
 * @param before the last state that is already known
 * @param words called for each announcement, because the language can change
 * @returns a function that ends the announcements
 */
export function tellRun(
  { challenge, run, workspace, screen, timeline, speech }: Ports,
  before: RunState,
  words: () => Words,
): () => void {
  const ear = new RunEar(before);

  function say(talk: RunTalk): void {
    switch (talk.kind) {
      case "event":
        speech.tell(eventText(talk.event), "moment");
        return;
      case "decision": {
        const about = talk.isTurn ? null : `line ${talk.line}`;
        const utterance = { kind: "chatter", text: decision(), about } as const;
        // A turn repaints much of the page, so its text follows with the next update of the
        // numbers.
        if (run.getState().snapshot?.state === "running") speech.offer(utterance);
        else speech.say(utterance);
        return;
      }
      case "past":
        chat(
          joinSentences(words().t, [
            ...(talk.isFirst ? [spoken(words().t)("runDetails:speech.past")] : []),
            ...shownMoment(),
          ]),
        );
        return;
      case "too-fast":
        speech.hush();
        return;
      case "at-start":
        chat(spoken(words().t)("runDetails:speech.atStart"));
        return;
      case "playing":
        chat(spoken(words().t)("runDetails:speech.playing"));
        return;
      case "paused":
      case "now":
        chat(spoken(words().t)(`runDetails:speech.${talk.kind}`, { seconds: seconds() }));
    }
  }

  function chat(text: string): void {
    if (text !== "") speech.say({ kind: "chatter", text, about: null });
    speech.begin();
  }

  function seconds(): string {
    return formatSeconds(run.getState().snapshot?.tick ?? 0, words().language);
  }

  function decision(): string {
    const { snapshot } = run.getState();
    if (snapshot === null || snapshot.line === null) return "";
    return decisionText(words(), workspace.getState().program, snapshot.line, snapshot);
  }

  /**
   * The displayed tick in words. Empty while the timeline slider has the focus, because the slider
   * announces it.
   */
  function shownMoment(): string[] {
    const { snapshot } = run.getState();
    if (snapshot === null || document.activeElement?.matches("[type=range]") === true) return [];
    const moment = momentAt(timelineOf(timeline), snapshot.tick, snapshot);
    const { t, language } = words();
    const line = decision();
    if (line === "") return [asSentence(t, sayMoment(t, moment, language))];
    // The line already states who drives and how it turns.
    const event = moment.event?.kind === "turn" ? null : moment.event;
    return [asSentence(t, sayMoment(t, { ...moment, who: null, event }, language)), line];
  }

  function eventText(event: RunEvent): string {
    const { t, language } = words();
    if (event.diagnosis !== null) {
      const known = diagnosisWords(t, language, (tick) => timeline.waitedUpTo(tick));
      const { diagnosis } = event;
      // In a challenge its card announces the rest.
      const title = asSentence(t, diagnosisTitle(known, diagnosis));
      if (challenge.getState().challenge !== null) return title;
      // A diagnosis with a line already states the bump in its text.
      const titles = causeLine(diagnosis) === null ? [] : [title];
      const text = diagnosisText(known, diagnosis);
      return joinSentences(t, [...titles, text, ...fixCount(t, diagnosis)]);
    }
    const story = storyOf(event, timeline.waitedUpTo(event.tick));
    return storyText(t, { ...story, seconds: formatSeconds(story.after, language) });
  }

  const listen = (state: RunState): void => {
    const talk = ear.hear(state, workspace.getState().program);
    if (!screen.getState().speakRun) return;
    if (talk !== null) say(talk);
    else if (state.snapshot?.state === "running") speech.breathe();
  };
  listen(run.getState());
  return run.subscribe(listen);
}
