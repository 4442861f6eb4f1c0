/** Opens a big screen: it only receives, and shows no names. */
import { ScreenConnection } from "@corridor/client/show";
import { readLesson } from "@corridor/challenge/document";
import { readValue, screenContentSchema } from "@corridor/protocol";
import type { ReactNode } from "react";
import { createStore } from "zustand/vanilla";
import type { BigScreenState } from "./big-screen-state.ts";
import { BigScreen } from "./BigScreen.tsx";

const RETRY_MS = 2_000;

interface BigScreenParts {
  id: string;
  key: string;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export function openBigScreen({ id, key, tools }: BigScreenParts): ReactNode {
  const store = createStore<BigScreenState>()(() => ({
    status: "connecting",
    code: null,
    lesson: null,
    content: null,
    isLessonReadable: true,
    isContentReadable: true,
  }));
  let newest = "";
  const openLesson = async (version: string): Promise<void> => {
    newest = version;
    while (newest === version) {
      const text = await readText(`/api/v1/classes/${id}/lesson`, key);
      const read = text === null ? null : readLesson(text);
      if (newest !== version) return;
      if (read !== null) {
        return store.setState({
          ...(read.ok && { lesson: read.value }),
          isLessonReadable: read.ok,
        });
      }
      await new Promise((resolve) => setTimeout(resolve, RETRY_MS));
    }
  };
  const connection = new ScreenConnection({
    origin: location.origin,
    id,
    key,
    onMessage: (message) => {
      switch (message.type) {
        case "welcome":
          store.setState({ code: message.code });
          return void openLesson(message.lesson);
        case "code":
          return store.setState({ code: message.code });
        case "lesson":
          return void openLesson(message.version);
        case "display": {
          const read = readValue(screenContentSchema, message.content);
          return store.setState({
            ...(read.ok && { content: read.value }),
            isContentReadable: read.ok,
          });
        }
        case "problem":
          return;
      }
    },
    onStatus: ({ kind }) => {
      if (kind === "over") newest = "";
      store.setState({ status: kind });
    },
  });
  window.addEventListener("online", () => connection.open());
  return <BigScreen store={store} tools={tools} />;
}

/** null: no response, or the class has ended */
async function readText(path: string, key: string): Promise<string | null> {
  try {
    const answer = await fetch(path, { headers: { Authorization: `Bearer ${key}` } });
    return answer.ok ? await answer.text() : null;
  } catch {
    return null;
  }
}
