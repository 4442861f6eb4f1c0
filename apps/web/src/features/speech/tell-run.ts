/** Ties the run to the page's voice: what the ear notes is put into words and said. */
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
import { RunEar, type RunTalk } from "./run-ear.ts";
import { decisionText, spoken, type Words } from "./run-words.ts";

type Ports = Pick<Services, "challenge" | "run" | "workspace" | "screen" | "timeline" | "speech">;

/** How many changes the card offers. */
function fixCount(t: Words["t"], { fixes }: Diagnosis): string[] {
  return fixes.length > 0 ? [spoken(t)("runDetails:speech.mends", { count: fixes.length })] : [];
}

/**
 * @param before the state that was the last one to be known already
 * @param words read anew each time: the language can change
 * @returns a function that ends it
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
        // A turn paints much of the page anew: its words come with the numbers after it.
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

  /** The slider of the timeline says its moment by itself while it has the focus. */
  function shownMoment(): string[] {
    const { snapshot } = run.getState();
    if (snapshot === null || document.activeElement?.matches("[type=range]") === true) return [];
    const moment = momentAt(timelineOf(timeline), snapshot.tick);
    const { t, language } = words();
    const line = decision();
    if (line === "") return [asSentence(t, sayMoment(t, moment, language))];
    // The line says who drives and how it turns.
    const event = moment.event?.kind === "turn" ? null : moment.event;
    return [asSentence(t, sayMoment(t, { ...moment, who: null, event }, language)), line];
  }

  function eventText(event: RunEvent): string {
    const { t, language } = words();
    if (event.diagnosis !== null) {
      const known = diagnosisWords(t, language, (tick) => timeline.waitedUpTo(tick));
      const { diagnosis } = event;
      // In a challenge its card says the rest.
      const title = asSentence(t, diagnosisTitle(known, diagnosis));
      if (challenge.getState().challenge !== null) return title;
      // The sentence about the bump says that it is one.
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
