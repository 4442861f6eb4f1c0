/** Connects the run to the announcements: puts the announcements of `RunListener` into words. */
import { causeLine, type Diagnosis } from "@corridor/coach";
import { showsHelp } from "../../model/challenge/challenge-store.ts";
import type { Services } from "../../model/services.ts";
import { asSentence, joinSentences } from "../../text/joined.ts";
import type { RunState } from "../../model/run/run-store.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import {
  diagnosisText,
  diagnosisTitle,
  diagnosisWords,
} from "../../model/diagnosis/diagnosis-text.ts";
import { describeTick, tickText } from "../../model/run/tick-description.ts";
import { timeText } from "../../model/run/time-text.ts";
import { timelineOf } from "../../model/run/timeline-of.ts";
import { storyOf, storyText } from "../../model/run/story.ts";
import { RunListener, type RunAnnouncement } from "./run-listener.ts";
import { decisionText, spoken, type Words } from "../../model/speech/run-words.ts";

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
export function announceRun(
  { challenge, run, workspace, screen, timeline, speech }: Ports,
  before: RunState,
  words: () => Words,
): () => void {
  const listener = new RunListener(before);

  function announce(announcement: RunAnnouncement): void {
    switch (announcement.kind) {
      case "event":
        speech.announce(eventText(announcement.event), "run event");
        return;
      case "decision": {
        const about = announcement.isTurn ? null : `line ${announcement.line}`;
        const utterance = { kind: "state", text: decision(), about } as const;
        // A turn repaints much of the page, so its text follows with the next update of the
        // numbers.
        if (run.getState().snapshot?.state === "running") speech.offer(utterance);
        else speech.speak(utterance);
        return;
      }
      case "past":
        announceState(
          joinSentences(words().t, [
            ...(announcement.isFirst ? [spoken(words().t)("runDetails:speech.past")] : []),
            ...displayedTickTexts(),
          ]),
        );
        return;
      case "too-fast":
        speech.dropState();
        return;
      case "at-start":
        speech.drop("run event");
        announceState(spoken(words().t)("runDetails:speech.atStart"));
        return;
      case "playing":
        announceState(spoken(words().t)("runDetails:speech.playing"));
        return;
      case "paused":
      case "now":
        announceState(
          spoken(words().t)(`runDetails:speech.${announcement.kind}`, { time: time() }),
        );
    }
  }

  function announceState(text: string): void {
    if (text !== "") speech.speak({ kind: "state", text, about: null });
    speech.allowRepeat();
  }

  function time(): string {
    const { t, language } = words();
    return timeText(t, run.getState().snapshot?.tick ?? 0, language);
  }

  function decision(): string {
    const state = run.getState();
    const line = state.snapshot?.line ?? null;
    return line === null
      ? ""
      : decisionText(
          words(),
          workspace.getState().program,
          line,
          state,
          showsHelp(challenge.getState().rights, "truth"),
        );
  }

  /**
   * The displayed tick in words. Empty while the timeline slider has the focus, because the slider
   * announces it.
   */
  function displayedTickTexts(): string[] {
    const { snapshot } = run.getState();
    if (snapshot === null || document.activeElement?.matches("[type=range]") === true) return [];
    const description = describeTick(timelineOf(timeline), snapshot.tick, snapshot);
    const { t, language } = words();
    const line = decision();
    if (line === "") return [asSentence(t, tickText(t, description, language))];
    // The line already states who drives and how it turns.
    const event = description.event?.kind === "turn" ? null : description.event;
    return [asSentence(t, tickText(t, { ...description, who: null, event }, language)), line];
  }

  function eventText(event: RunEvent): string {
    const { t, language } = words();
    if (event.diagnosis !== null) {
      const known = diagnosisWords(t, language, (tick) => timeline.waitedUpTo(tick));
      const { diagnosis } = event;
      // In a challenge its card announces the rest.
      const title = asSentence(t, diagnosisTitle(known, diagnosis));
      if (challenge.getState().lesson !== null) return title;
      // A diagnosis with a line already states the bump in its text.
      const titles = causeLine(diagnosis) === null ? [] : [title];
      const text = diagnosisText(known, diagnosis);
      return joinSentences(t, [...titles, text, ...fixCount(t, diagnosis)]);
    }
    const story = storyOf(event, timeline.waitedUpTo(event.tick));
    return storyText(t, story, language);
  }

  const listen = (state: RunState): void => {
    const announcement = listener.update(state, workspace.getState().program);
    if (!screen.getState().speakRun) return;
    if (announcement !== null) announce(announcement);
    else if (state.snapshot?.state === "running") speech.flush();
  };
  listen(run.getState());
  return run.subscribe(listen);
}
